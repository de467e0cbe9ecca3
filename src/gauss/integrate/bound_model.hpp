// An emitted model with its parameters and inputs filled in: what every integrator starts from.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_BOUND_MODEL_HPP
#define GAUSS_INTEGRATE_BOUND_MODEL_HPP

#include <cstddef>
#include <type_traits>

#include "gauss/model_concept.hpp"

namespace gauss::integrate {

namespace detail {

// Found through the namespace of State. A model that was generated without `project` is left as it is.
template <class Scalar, class State, class Prepared>
auto project_if_any(int, const Scalar& t, const State& from, const Prepared& prepared, State& state)
    -> decltype(project(t, from, prepared, state)) {
  return project(t, from, prepared, state);
}

template <class Scalar, class State, class Prepared>
StatusOf<Scalar> project_if_any(long, const Scalar&, const State& from, const Prepared&, State& state) {
  state = from;
  return StatusOf<Scalar>{};
}

// One step of Newton's method each, of models with equations of positions.
template <class Scalar, class State, class Prepared>
StatusOf<Scalar> position_step(const Scalar& t, const Prepared& prepared, State& state) {
  return project_positions(t, state, prepared, state);
}

template <class Scalar, class State, class Prepared>
auto speed_step(int, const Scalar& t, const Prepared& prepared, State& state)
    -> decltype(project_speeds(t, state, prepared, state)) {
  return project_speeds(t, state, prepared, state);
}

// Where the last step is also a check of what projection has moved: nothing so far.
template <class Scalar, class State, class Prepared>
auto speed_step(long, const Scalar& t, const Prepared& prepared, State& state)
    -> decltype(project_speeds(t, state, state, prepared, state)) {
  const State start = state;
  return project_speeds(t, start, start, prepared, state);
}

// Of a type by hand, nothing is known of units.
template <class Model, class = void>
struct Tables {
  static constexpr const Quantity *coordinates = nullptr, *speeds = nullptr;
};
template <class Model>
struct Tables<Model, std::void_t<decltype(Model::coordinates), decltype(Model::speeds)>> : Model {};

// Outside of BoundModel, whose member would hide it.
template <class Scalar, class State, class Prepared, class Energy>
StatusOf<Scalar> energy_of(const Scalar& t, const State& state, const Prepared& prepared, Energy& result) {
  return energy(t, state, prepared, result);
}

}  // namespace detail

/// `Source` is the model's Inputs, or a function (t, state) -> Inputs, such as a controller.
template <class StateType, class DerivativeType, class PreparedType, class Source, std::size_t coordinates>
class BoundModel {
 public:
  using State = StateType;
  using Derivative = DerivativeType;
  using Prepared = PreparedType;
  using Scalar = std::remove_all_extents_t<decltype(State::values)>;
  using Status = StatusOf<Scalar>;
  static constexpr std::size_t size = sizeof(State::values) / sizeof(Scalar);
  static constexpr std::size_t n_q = coordinates;
  static constexpr std::size_t n_v = size - n_q;

  /// The tables are those of the emitted header, or none.
  BoundModel(const Prepared& prepared, const Source& source, const Quantity* coordinate_table = nullptr,
             const Quantity* speed_table = nullptr)
      : prepared_(prepared), source_(source), coordinates_(coordinate_table), speeds_(speed_table) {}

  /// Of a component of the state, as the model file has it; null where nothing is known.
  const char* unit(std::size_t component) const {
    const Quantity* const table = component < n_q ? coordinates_ : speeds_;
    return table == nullptr ? nullptr : table[component < n_q ? component : component - n_q].unit;
  }

  Status derivative(const Scalar& t, const State& state, Derivative& result) const {
    return rhs(t, state, inputs(t, state), prepared_, result);
  }

  /// Of a model that was generated with `jacobian`; `Result` is its emitted struct.
  template <class Result>
  Status derivatives(const Scalar& t, const State& state, Result& result) const {
    return jacobian(t, state, inputs(t, state), prepared_, result);
  }

  /// Of a model that was generated with `taylor`: power series of the state from t on. `Result` is its emitted struct.
  template <class Result>
  Status series(const Scalar& t, const State& state, int order, Result& result) const {
    return taylor(t, state, inputs(t, state), prepared_, order, result);
  }

  /// Of a model that was generated with `energy`; `Result` is its emitted struct.
  template <class Result>
  Status energy(const Scalar& t, const State& state, Result& result) const {
    return detail::energy_of(t, state, prepared_, result);
  }

  /// Back onto the constraints.
  Status projection(const Scalar& t, State& state) const { return projection(t, state, state); }
  /// The same of `from`, which may be `state`.
  Status projection(const Scalar& t, const State& from, State& state) const {
    return detail::project_if_any(0, t, from, prepared_, state);
  }

  /// One step of Newton's method towards the equations of positions, in the metric of the masses; of a model that has some.
  Status position_step(const Scalar& t, State& state) const { return detail::position_step(t, prepared_, state); }

  /// The same towards the constraints of velocities.
  Status speed_step(const Scalar& t, State& state) const { return detail::speed_step(0, t, prepared_, state); }

  decltype(auto) inputs(const Scalar& t, const State& state) const {
    if constexpr (std::is_invocable_v<const Source&, const Scalar&, const State&>) {
      return source_(t, state);
    } else {
      return (source_);
    }
  }
  const Prepared& prepared() const { return prepared_; }
  /// The same model with other parameters.
  BoundModel with(const Prepared& prepared) const { return {prepared, source_, coordinates_, speeds_}; }

 private:
  Prepared prepared_;
  Source source_;
  const Quantity *coordinates_, *speeds_;
};

/// With `GAUSS_MODEL(Ball, gauss::ball)` of gauss/model_concept.hpp: bind_model<Ball>(Ball::prepare(parameters), inputs).
template <class Model, class S = double, class Source>
BoundModel<typename Model::template State<S>, typename Model::template Derivative<S>,
           typename Model::template Prepared<S>, Source, static_cast<std::size_t>(Model::n_q)>
bind_model(const typename Model::template Prepared<S>& prepared, const Source& source) {
  static_assert(is_model<Model, S>, "a type made by GAUSS_MODEL is expected");
  return {prepared, source, detail::Tables<Model>::coordinates, detail::Tables<Model>::speeds};
}

/// With the inputs that the model's file has, and its parameters if there are no others.
template <class Model, class S = double>
auto bind_model(const typename Model::template Parameters<S>& parameters = {}) {
  return bind_model<Model, S>(Model::prepare(parameters), typename Model::template Inputs<S>{});
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_BOUND_MODEL_HPP
