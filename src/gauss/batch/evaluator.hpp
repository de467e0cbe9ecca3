#pragma once
// Evaluates an emitted model for many trajectories at a time, over structures of arrays.
// SPDX-License-Identifier: MIT-0
//
//     GAUSS_MODEL(Pendulum, gauss::pendulum);
//     const gauss::batch::Evaluator<Pendulum> pendulums(parameters);      // the same parameters for all
//     gauss::batch::Points<double> points;
//     points.count = 1000;
//     points.states = {y, 1000};                                          // y[0 … 999]: theta, y[1000 …]: theta_dot
//     std::size_t bad = pendulums.rhs(points, {dy, 1000}, statuses);
//
// Every trajectory is computed by itself: neither its neighbours, nor its place among them, nor how many there are changes a
// bit of its results (but in float, for sines and cosines of angles beyond 60 rad). Columns that begin at multiples of 64 bytes are
// the fastest.

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "gauss/batch/lanes.hpp"
#include "gauss/model_concept.hpp"

#if defined(__GNUC__)
#define GAUSS_FLATTENED __attribute__((flatten))
#define GAUSS_RARE __attribute__((noinline, cold))
#else
#define GAUSS_FLATTENED
#define GAUSS_RARE
#endif

namespace gauss::batch {

namespace detail {

// Found through the namespace of State; a class that has members of these names would not look there.
template <class... Arguments>
auto call_rhs_and_reactions(Arguments&... arguments) {
  return rhs_and_reactions(arguments...);
}
template <class... Arguments>
auto call_jacobian(Arguments&... arguments) {
  return jacobian(arguments...);
}

}  // namespace detail

/// Component c of trajectory k is data[c * stride + k]; a stride is at least the number of trajectories.
template <class T>
struct Columns {
  T* data = nullptr;
  std::size_t stride = 0;
};

/// What is evaluated: some trajectories, each at its state and time.
template <class T>
struct Points {
  std::size_t count = 0;
  Columns<const T> states;       ///< coordinates, then speeds, as in State
  T time = T(0);                 ///< of all, unless each has its own:
  const T* times = nullptr;      ///< of each trajectory
  Columns<const T> inputs = {};  ///< of each trajectory, in the order of input_table; else Evaluator::inputs is taken
};

/// `Model` is made by GAUSS_MODEL, T is the type of the numbers in the arrays. S is what is computed with: `Widest<T>`, or any
/// xsimd::batch of T. Every function returns how many trajectories have a status other than ok; `statuses`, one for each
/// trajectory, says which and why, and may be null.
template <class Model, class T = double, class S = Widest<T>>
class Evaluator {
  static_assert(is_model<Model, S>, "a type made by GAUSS_MODEL is expected");
  static_assert(std::is_same_v<typename Lanes<S>::Number, T>, "S is T or a batch of T");

 public:
  using Parameters = typename Model::template Parameters<T>;
  using Inputs = typename Model::template Inputs<T>;
  static constexpr std::size_t lanes = Lanes<S>::size;

  /// For trajectories that do not bring their own.
  Inputs inputs{};

  explicit Evaluator(const Parameters& shared = {})
      : prepared_{prepared_with([&](int k) { return Lanes<S>::same(shared.*Model::template parameters_of<T>()[k]); })} {
  }

  /// Parameters of each trajectory, in the order of parameter_table; later calls are for these `count` trajectories.
  Evaluator(std::size_t count, Columns<const T> parameters) : count_(count) {
    for (std::size_t first = 0; first < count; first += lanes) {
      prepared_.push_back(
          prepared_with([&](int k) { return block(parameters, static_cast<std::size_t>(k), first, count); }));
    }
  }

  /// Rates of coordinates, then accelerations: `derivatives` has n_q + n_v components.
  std::size_t rhs(const Points<T>& points, Columns<T> derivatives, Status* statuses = nullptr) const {
    return evaluate<Model::template Derivative>(
        [](const auto& t, const auto& state, const auto& in, const auto& prepared, auto& derivative) {
          return Model::rhs(t, state, in, prepared, derivative);
        },
        points, {derivatives}, statuses);
  }

  /// `Reactions` is that of the model: rhs_and_reactions<gauss::pendulum::Reactions>(…). Components are its members in order.
  template <template <class> class Reactions>
  std::size_t rhs_and_reactions(const Points<T>& points, Columns<T> derivatives, Columns<T> reactions,
                                Status* statuses = nullptr) const {
    return evaluate<Model::template Derivative, Reactions>(
        [](const auto& t, const auto& state, const auto& in, const auto& prepared, auto& derivative, auto& result) {
          return detail::call_rhs_and_reactions(t, state, in, prepared, derivative, result);
        },
        points, {derivatives, reactions}, statuses);
  }

  /// `Jacobian` is that of the model. Components are its entries: by state, by inputs, by time, as their patterns say.
  template <template <class> class Jacobian>
  std::size_t jacobian(const Points<T>& points, Columns<T> entries, Status* statuses = nullptr) const {
    return evaluate<Jacobian>([](const auto& t, const auto& state, const auto& in, const auto& prepared,
                                 auto& result) { return detail::call_jacobian(t, state, in, prepared, result); },
                              points, {entries}, statuses);
  }

  /// Any function of the model: function(t, state, inputs, prepared, result…) fills each of the structs `Results`, whose
  /// members in order are the components of `columns`.
  template <template <class> class... Results, class Function>
  std::size_t evaluate(const Function& function, const Points<T>& points,
                       const Columns<T> (&columns)[sizeof...(Results)], Status* statuses) const {
    std::size_t bad = 0, first = 0;
    const auto take = [&](const Points<T>& from, std::size_t place, std::size_t wanted) {
      Status* const to = statuses == nullptr ? nullptr : statuses + first;
      bad += at<Function, Results<S>...>(function, from, place, {first, wanted, to}, columns);
    };
    for (; first + lanes <= points.count; first += lanes) take(points, first, lanes);
    if (first < points.count) {
      const Rest rest(points, first);
      take(rest.points, 0, points.count - first);
    }
    return bad;
  }

 private:
  using Prepared = typename Model::template Prepared<S>;

  /// What is left over for less than a register: the last trajectory fills its lanes, so that each is computed as in a full one.
  struct Rest {
    Rest(const Points<T>& all, std::size_t first) {
      points.count = lanes;
      points.time = all.time;
      points.states = copied(all.states, all.count, first, states, n_state);
      if (all.times != nullptr) points.times = copied({all.times, 0}, all.count, first, times, 1).data;
      if (all.inputs.data != nullptr) points.inputs = copied(all.inputs, all.count, first, given, Model::n_inputs);
    }

    Points<T> points;

   private:
    static Columns<const T> copied(Columns<const T> from, std::size_t count, std::size_t first, T* to,
                                   std::size_t components) {
      for (std::size_t i = 0; i < components * lanes; ++i)
        to[i] = from.data[i / lanes * from.stride + std::min(first + i % lanes, count - 1)];
      return {to, lanes};
    }

    static constexpr std::size_t n_state = static_cast<std::size_t>(Model::n_q + Model::n_v);
    T states[n_state * lanes], given[(static_cast<std::size_t>(Model::n_inputs) + 1) * lanes], times[lanes];
  };

  static S block(Columns<const T> columns, std::size_t component, std::size_t first) {
    return Lanes<S>::load(columns.data + component * columns.stride + first);
  }

  static S block(Columns<const T> columns, std::size_t component, std::size_t first, std::size_t count) {
    T numbers[lanes];
    for (std::size_t i = 0; i < lanes; ++i)
      numbers[i] = columns.data[component * columns.stride + std::min(first + i, count - 1)];
    return Lanes<S>::load(numbers);
  }

  template <class ValueOf>
  static Prepared prepared_with(const ValueOf& value_of) {
    typename Model::template Parameters<S> parameters;
    for (int k = 0; k < Model::n_parameters; ++k) parameters.*Model::template parameters_of<S>()[k] = value_of(k);
    return Model::prepare(parameters);
  }

  // Without loops, and all in one function: a state that is read where it was loaded never goes to memory in between.
  template <std::size_t... I>
  static void load(const Points<T>& points, std::size_t first, typename Model::template State<S>& state,
                   std::index_sequence<I...>) {
    ((state.values[I] = block(points.states, I, first)), ...);
  }

  /// Some trajectories, at most a register of them, among all.
  struct Block {
    std::size_t first;
    std::size_t count;
    Status* statuses;  ///< of the first, or null
  };

  /// Of how many the status is not ok. `place` is where the trajectories stand in `points`.
  template <class Function, class... Results>
  GAUSS_FLATTENED std::size_t at(const Function& function, const Points<T>& points, std::size_t place, Block to,
                                 const Columns<T>* columns) const {
    typename Model::template State<S> state;
    load(points, place, state, std::make_index_sequence<static_cast<std::size_t>(Model::n_q + Model::n_v)>());
    typename Model::template Inputs<S> in;
    for (int k = 0; k < Model::n_inputs; ++k) {
      in.*Model::template inputs_of<S>()[k] = points.inputs.data != nullptr
                                                  ? block(points.inputs, static_cast<std::size_t>(k), place)
                                                  : Lanes<S>::same(inputs.*Model::template inputs_of<T>()[k]);
    }
    const S t = points.times != nullptr ? Lanes<S>::load(points.times + place) : Lanes<S>::same(points.time);
    std::tuple<Results...> results;
    const Prepared& prepared = prepared_[count_ == 0 ? 0 : to.first / lanes];
    return std::apply(
        [&](Results&... each) {
          const StatusOf<S> status = function(t, state, in, prepared, each...);
          (store(each, *columns++, to.first, to.count, std::make_index_sequence<scalars_in<Results>()>()), ...);
          if (!Lanes<S>::all_ok(status)) return report(status, to);
          if (to.statuses != nullptr) set_ok(to);
          return std::size_t{0};
        },
        results);
  }

  template <class Result>
  static constexpr std::size_t scalars_in() {
    static_assert(std::is_empty_v<Result> || sizeof(Result) % sizeof(S) == 0, "a result holds scalars only");
    return std::is_empty_v<Result> ? 0 : sizeof(Result) / sizeof(S);
  }

  /// A result holds scalars only, so it is an array of them.
  template <class Result, std::size_t... I>
  static void store(const Result& result, Columns<T> columns, std::size_t first, std::size_t wanted,
                    std::index_sequence<I...>) {
    const S* const values = reinterpret_cast<const S*>(&result);
    if (wanted == lanes) {
      (Lanes<S>::store(values[I], columns.data + I * columns.stride + first), ...);
    } else {
      (Lanes<S>::store(values[I], columns.data + I * columns.stride + first, wanted), ...);
    }
  }

  /// Of a full register without a call, which would cost as much as many operations.
  static void set_ok(Block to) {
    if (to.count == lanes) {
      std::fill_n(to.statuses, lanes, Status::ok);
    } else {
      std::fill_n(to.statuses, to.count, Status::ok);
    }
  }

  GAUSS_RARE static std::size_t report(StatusOf<S> status, Block to) {
    std::size_t bad = 0;
    for (std::size_t i = 0; i < to.count; ++i) {
      const Status one = Lanes<S>::status_of(status, i);
      bad += one == Status::ok ? 0 : 1;
      if (to.statuses != nullptr) to.statuses[i] = one;
    }
    return bad;
  }

  std::vector<Prepared> prepared_;  ///< one, or one for each register of trajectories
  std::size_t count_ = 0;           ///< trajectories with parameters of their own; 0: they share them
};

}  // namespace gauss::batch
