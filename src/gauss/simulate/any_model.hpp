// Emitted models behind one type, for programs that choose among some of them while they run.
// SPDX-License-Identifier: MIT
//
//     #include "ball_variants.hpp"  // by gauss-gen ball.yaml --variant near=gravity,air --variant far=gravity
//
//     gauss::simulate::ChosenModel ball(*gauss::simulate::find_model(gauss::ball_variants::variants, "far"));
//     ball.set("m", 0.2);
//     std::vector<double> x(ball.size()), rates(ball.size());
//     ball.initial_state(x.data());
//     ball.rhs(0, x.data(), rates.data());
//
// Variants may be regimes of contacts and friction (--variant resting=floor=closed, with --outputs rhs,guards): each is a function set of its own, and
// `guards` says when it ends.
//
// A call costs one jump through a pointer more than that of the emitted function.
#ifndef GAUSS_SIMULATE_ANY_MODEL_HPP
#define GAUSS_SIMULATE_ANY_MODEL_HPP

#include <cstddef>
#include <cstring>
#include <new>
#include <vector>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/model_concept.hpp"

namespace gauss::simulate {

/// One emitted model, in double. Arrays have as many numbers as it says; `prepared` is memory of `prepared_size` bytes, aligned for double.
struct AnyModel {
  const char* name;
  const char* effects;  ///< that act, with commas between
  const char* regime;   ///< modes that were asked for, as floor=closed, with commas between
  int n_q, n_v, n_parameters, n_inputs;
  const Quantity *coordinates, *speeds, *parameters, *inputs;  ///< tables end with a null name
  std::size_t prepared_size;
  void (*defaults)(double* parameters, double* inputs);
  void (*prepare)(const double* parameters, void* prepared);
  /// not_finite where the model was generated without `initial_state`.
  Status (*initial_state)(const void* prepared, double* state);
  Status (*rhs)(double t, const double* state, const double* inputs, const void* prepared, double* rates);
  /// In place. Leaves states of a model that was generated without `project` as they are.
  Status (*project)(double t, const void* prepared, double* state);
  int n_guards;                    ///< 0: it has none, or was generated without `guards`
  const char* const* guard_names;  ///< ends with a null; null without guards
  /// What ends this regime (docs/regimes.md). Null without guards.
  Status (*guards)(double t, const double* state, const double* inputs, const void* prepared, double* values);
};

/// A value by the name of a parameter, an input or a component of the state. Arrays of them end with a null name.
struct GivenValue {
  const char* name;
  double value;
};

/// One of several bodies of a scene (gauss-gen SCENE with `instances`): its functions, which others may share, and the values that are its own.
struct AnyInstance {
  const char* name;
  const AnyModel* model;
  const GivenValue* values;  ///< of parameters and inputs
  const GivenValue* start;   ///< of components of the initial state
};

namespace detail {

// Found through the namespace of Prepared.
template <class State, class Prepared>
auto start_if_any(int, const Prepared& prepared, State& state) -> decltype(initial_state(prepared, state)) {
  return initial_state(prepared, state);
}

template <class State, class Prepared>
Status start_if_any(long, const Prepared&, State&) {
  return Status::not_finite;
}

template <class M>
struct Calls {
  using Parameters = typename M::template Parameters<double>;
  using Inputs = typename M::template Inputs<double>;
  using Prepared = typename M::template Prepared<double>;
  using State = typename M::template State<double>;
  using Derivative = typename M::template Derivative<double>;

  static const Prepared& known(const void* prepared) { return *static_cast<const Prepared*>(prepared); }

  static Inputs inputs_of(const double* values) {
    Inputs inputs;
    for (int i = 0; i < M::n_inputs; ++i) inputs.*M::template inputs_of<double>()[i] = values[i];
    return inputs;
  }

  static State state_of(const double* values) {
    State state;
    std::memcpy(state.values, values, sizeof(state.values));
    return state;
  }

  static void defaults(double* parameters, double* inputs) {
    const Parameters of_model;
    for (int i = 0; i < M::n_parameters; ++i) parameters[i] = of_model.*M::template parameters_of<double>()[i];
    const Inputs of_calls;
    for (int i = 0; i < M::n_inputs; ++i) inputs[i] = of_calls.*M::template inputs_of<double>()[i];
  }

  static void prepare(const double* values, void* prepared) {
    Parameters parameters;
    for (int i = 0; i < M::n_parameters; ++i) parameters.*M::template parameters_of<double>()[i] = values[i];
    new (prepared) Prepared(M::prepare(parameters));
  }

  static Status initial_state(const void* prepared, double* values) {
    State state{};
    const Status status = start_if_any(0, known(prepared), state);
    std::memcpy(values, state.values, sizeof(state.values));
    return status;
  }

  static Status rhs(double t, const double* values, const double* inputs, const void* prepared, double* rates) {
    Derivative derivative;
    const Status status = M::rhs(t, state_of(values), inputs_of(inputs), known(prepared), derivative);
    std::memcpy(rates, derivative.values, sizeof(derivative.values));
    return status;
  }

  static Status project(double t, const void* prepared, double* values) {
    const State from = state_of(values);
    State state = from;
    const Status status = integrate::detail::project_if_any(0, t, from, known(prepared), state);
    std::memcpy(values, state.values, sizeof(state.values));
    return status;
  }
};

template <class M, class Guards>
Status guards_of(double t, const double* values, const double* numbers, const void* prepared, double* result) {
  using Own = Calls<M>;
  Guards found{};
  const Status status = guards(t, Own::state_of(values), Own::inputs_of(numbers), Own::known(prepared), found);
  std::memcpy(result, &found, sizeof(found));
  return status;
}

}  // namespace detail

/// `M`: of GAUSS_MODEL.
template <class M>
constexpr AnyModel any_model(const char* name, const char* effects, const char* regime = "") {
  using Calls = detail::Calls<M>;
  return {name,
          effects,
          regime,
          M::n_q,
          M::n_v,
          M::n_parameters,
          M::n_inputs,
          M::coordinates,
          M::speeds,
          M::parameters,
          M::inputs,
          sizeof(typename Calls::Prepared),
          Calls::defaults,
          Calls::prepare,
          Calls::initial_state,
          Calls::rhs,
          Calls::project,
          0,
          nullptr,
          nullptr};
}

/// `Guards`: of the emitted namespace, in double; `guard_names`: its members and a null behind them.
template <class M, class Guards, std::size_t n>
constexpr AnyModel any_model(const char* name, const char* effects, const char* regime,
                             const char* const (&guard_names)[n]) {
  static_assert(sizeof(Guards) == sizeof(double[n - 1]), "as many names as guards");
  AnyModel model = any_model<M>(name, effects, regime);
  model.n_guards = static_cast<int>(n - 1);
  model.guard_names = guard_names;
  model.guards = detail::guards_of<M, Guards>;
  return model;
}

/// Null: there is none of this name.
template <std::size_t n>
const AnyModel* find_model(const AnyModel (&models)[n], const char* name) {
  for (const AnyModel& model : models) {
    if (std::strcmp(model.name, name) == 0) return &model;
  }
  return nullptr;
}

/// The place of a guard in what `guards` fills; -1: this regime has none of this name.
inline int find_guard(const AnyModel& model, const char* name) {
  for (int i = 0; i < model.n_guards; ++i) {
    if (std::strcmp(model.guard_names[i], name) == 0) return i;
  }
  return -1;
}

template <std::size_t n>
const AnyInstance* find_instance(const AnyInstance (&instances)[n], const char* name) {
  for (const AnyInstance& instance : instances) {
    if (std::strcmp(instance.name, name) == 0) return &instance;
  }
  return nullptr;
}

/// One of them with its parameters and inputs.
class ChosenModel {
 public:
  /// With the values and the start of that body. `instance` outlives this.
  explicit ChosenModel(const AnyInstance& instance) : ChosenModel(*instance.model) {
    start_ = instance.start;
    for (const GivenValue* given = instance.values; given->name != nullptr; ++given) set(given->name, given->value);
  }

  /// `model` outlives this.
  explicit ChosenModel(const AnyModel& model)
      : model_(&model),
        parameters_(static_cast<std::size_t>(model.n_parameters)),
        inputs_(static_cast<std::size_t>(model.n_inputs)),
        prepared_(model.prepared_size / sizeof(double) + 1) {
    model.defaults(parameters_.data(), inputs_.data());
    model.prepare(parameters_.data(), prepared_.data());
  }

  const AnyModel& model() const { return *model_; }
  std::size_t size() const { return static_cast<std::size_t>(model_->n_q + model_->n_v); }

  /// Of a parameter or an input. False: this set of effects has none of this name, and nothing is changed.
  bool set(const char* name, double value) {
    if (double* const parameter = find(model_->parameters, name, parameters_)) {
      *parameter = value;
      model_->prepare(parameters_.data(), prepared_.data());
      return true;
    }
    double* const input = find(model_->inputs, name, inputs_);
    if (input != nullptr) *input = value;
    return input != nullptr;
  }

  /// Of an instance, components that are its own have these values, whatever its parameters are.
  Status initial_state(double* state) const {
    const Status status = model_->initial_state(prepared_.data(), state);
    if (start_ == nullptr || start_->name == nullptr) return status;
    for (const GivenValue* given = start_; given->name != nullptr; ++given) {
      if (double* const component = component_of(state, given->name)) *component = given->value;
    }
    const Status projected = project(0, state);  // quaternions have length 1
    return status == Status::ok ? projected : status;
  }
  Status rhs(double t, const double* state, double* rates) const {
    return model_->rhs(t, state, inputs_.data(), prepared_.data(), rates);
  }
  /// Of models with guards alone.
  Status guards(double t, const double* state, double* values) const {
    return model_->guards(t, state, inputs_.data(), prepared_.data(), values);
  }
  Status project(double t, double* state) const { return model_->project(t, prepared_.data(), state); }

 private:
  static double* find(const Quantity* table, const char* name, std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::strcmp(table[i].name, name) == 0) return &values[i];
    }
    return nullptr;
  }

  double* component_of(double* state, const char* name) const {
    for (int i = 0; i < model_->n_q + model_->n_v; ++i) {
      const Quantity& one = i < model_->n_q ? model_->coordinates[i] : model_->speeds[i - model_->n_q];
      if (std::strcmp(one.name, name) == 0) return state + i;
    }
    return nullptr;
  }

  const AnyModel* model_;
  const GivenValue* start_ = nullptr;
  std::vector<double> parameters_, inputs_;
  std::vector<double> prepared_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_ANY_MODEL_HPP
