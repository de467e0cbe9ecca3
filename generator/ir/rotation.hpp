#pragma once
// Turns of pairs of components in a plane, where r cos ψ and r sin ψ turned by θ are r cos(ψ + θ) and r sin(ψ + θ): one call
// instead of a product of two, and nothing that cancels.

#include <optional>
#include <utility>

#include "ir/vector3.hpp"

namespace gaussgen::ir {

/// (c x - s y, s x + c y) of the angle.
std::pair<Expr, Expr> turned(Expr x, Expr y, Expr angle);

/// About axis 0, 1 or 2: from turned axes to those before; by the opposite angle, back.
Vector3 turned(const Vector3& v, std::size_t axis, Expr angle);

/// Of a pair that is (r cos ψ, r sin ψ) or (r sin ψ, r cos ψ) up to signs: by which angle axes turn in which one of the
/// components vanishes.
std::optional<Expr> polar_angle(Expr x, Expr y);

}  // namespace gaussgen::ir
