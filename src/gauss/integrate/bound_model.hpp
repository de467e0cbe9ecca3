// An emitted model with its parameters and inputs filled in: what every integrator starts from.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_BOUND_MODEL_HPP
#define GAUSS_INTEGRATE_BOUND_MODEL_HPP

#include <cstddef>
#include <type_traits>
#include <utility>

#include "gauss/math.hpp"

namespace gauss::integrate {

/// `Source` is the model's Inputs, or a function (t, state) -> Inputs, such as a controller.
/// The functions of the model are found through the namespace of its State.
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

  /// Back onto the constraints. A model that was generated without `project` is left as it is.
  Status projection(const Scalar& t, State& state) const { return projection_if_any(0, t, state); }

 private:
  template <class S>
  auto projection_if_any(int, const S& t, State& state) const -> decltype(project(t, state, prepared_(), state)) {
    return project(t, state, prepared_, state);
  }
  template <class S>
  Status projection_if_any(long, const S&, State&) const {
    return Status{};
  }

  Prepared prepared_;
  Source source_;
};

}  // namespace gauss::integrate

#endif
