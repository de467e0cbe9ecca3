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
auto project_if_any(int, const Scalar& t, const Prepared& prepared, State& state)
    -> decltype(project(t, state, prepared, state)) {
  return project(t, state, prepared, state);
}

template <class Scalar, class State, class Prepared>
StatusOf<Scalar> project_if_any(long, const Scalar&, const Prepared&, State&) {
  return StatusOf<Scalar>{};
}

}  // namespace detail

/// `Source` is the model's Inputs, or a function (t, state) -> Inputs, such as a controller.
template <class StateType, class DerivativeType, class Prepared, class Source>
class BoundModel {
 public:
  using State = StateType;
  using Derivative = DerivativeType;
  using Scalar = std::remove_all_extents_t<decltype(State::values)>;
  using Status = StatusOf<Scalar>;
  static constexpr std::size_t size = sizeof(State::values) / sizeof(Scalar);

  BoundModel(const Prepared& prepared, const Source& source) : prepared_(prepared), source_(source) {}

  Status derivative(const Scalar& t, const State& state, Derivative& result) const {
    if constexpr (std::is_invocable_v<const Source&, const Scalar&, const State&>) {
      return rhs(t, state, source_(t, state), prepared_, result);
    } else {
      return rhs(t, state, source_, prepared_, result);
    }
  }

  /// Back onto the constraints.
  Status projection(const Scalar& t, State& state) const { return detail::project_if_any(0, t, prepared_, state); }

 private:
  Prepared prepared_;
  Source source_;
};

/// With `GAUSS_MODEL(Ball, gauss::ball)` of gauss/model_concept.hpp: bind_model<Ball>(Ball::prepare(parameters), inputs).
template <class Model, class S = double, class Source>
BoundModel<typename Model::template State<S>, typename Model::template Derivative<S>,
           typename Model::template Prepared<S>, Source>
bind_model(const typename Model::template Prepared<S>& prepared, const Source& source) {
  static_assert(is_model<Model, S>, "a type made by GAUSS_MODEL is expected");
  return {prepared, source};
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_BOUND_MODEL_HPP
