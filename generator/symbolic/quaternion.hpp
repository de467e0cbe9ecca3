#pragma once
// A unit quaternion near a given attitude, in three rotation coordinates θ (theory, section 5).

#include <array>

#include "model/model.hpp"
#include "symbolic/vector.hpp"

namespace gaussgen::symbolic {

using Quaternion = std::array<ex, 4>;  ///< scalar first, body to space

/// e(θ) = δ(θ) ⊗ e when θ turns in space, e ⊗ δ(θ) when it turns in the body; δ = (1 - θ²/8, θ/2) is exact to
/// second order in θ, which is all that two derivatives at θ = 0 see.
Quaternion turned(const Quaternion& e, const Vector3& theta, model::Axes frame);

/// ω = (1 + ½ [θ]×) θ̇ in space, (1 - ½ [θ]×) θ̇ in the body: exact to first order in θ, so that at θ = 0
/// ω = θ̇ and dω/dt = θ̈.
Vector3 angular_velocity(const Vector3& theta, const Vector3& theta_dot, model::Axes frame);

/// Body to space, for a unit quaternion.
Matrix3 rotation_matrix(const Quaternion& e);

}  // namespace gaussgen::symbolic
