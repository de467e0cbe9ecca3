#pragma once
// Steady motion: speeds are constant, and only coordinates change on which nothing else depends.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reduction.hpp"

namespace gaussgen {

/// Of the independent ones: coordinates without effect on anything but others of them.
std::vector<std::size_t> cyclic_coordinates(const ReducedMotion& motion, const IndependentChoice& choice);

/// Whether one of them changes; what a displacement of 1e-9 would change counts as nothing.
bool moves(const ReducedMotion& motion, std::size_t k);

/// Of the independent ones, unless the motion is steady here: speeds that change, and coordinates that move and are not in `cyclic`.
std::vector<std::size_t> changing(const ReducedMotion& motion, const std::vector<std::size_t>& cyclic,
                                  const IndependentChoice& choice);

/// Whether the motion is the same some time later, when coordinates have gone on as they move, in everything but `cyclic` ones.
bool goes_on(StatePoint<double>& point, const IndependentChoice& choice, const std::vector<std::size_t>& cyclic,
             const support::Rational& time);

/// Newton's method from where `rough` is: least steps over what is not `fixed` (indices among displacements and speeds). Leaves
/// `fine` at the motion, with all its digits. Says why there is none, or nothing.
std::string find_steady(StatePoint<double>& rough, StatePoint<cln::cl_F>& fine, const IndependentChoice& choice,
                        const std::set<std::size_t>& fixed);

}  // namespace gaussgen
