// Projection that moves a state no further than errors of steps explain.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_PROJECTION_NEAR_HPP
#define GAUSS_INTEGRATE_PROJECTION_NEAR_HPP

#include <type_traits>

#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

template <class Model, class = void>
struct MayKeepEnergy : std::false_type {};
template <class Model>
struct MayKeepEnergy<Model, std::void_t<decltype(&Model::keeps_energy)>> : std::true_type {};

/// The model's projection of `state`, which is `before`. Near rest, rounding of positions is more energy than there is in the motion, and no speed should make up for it: a model that keeps its
/// energy goes onto its constraints alone where `is_near()` is false of the state that keeps both, as for all that moves too far.
template <class Model, class IsNear>
Status projection_near(const Model& model, const typename Model::Scalar& t, const typename Model::State& before,
                       typename Model::State& state, const IsNear& is_near) {
  const Status status = model.projection(t, state);
  if constexpr (MayKeepEnergy<Model>::value) {
    if (model.keeps_energy() && is_motion_known(status) && !is_near()) {
      state = before;
      return model.constraint_projection(t, state);
    }
  }
  return status;
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_PROJECTION_NEAR_HPP
