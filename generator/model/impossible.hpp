#pragma once
// Masses and inertias that no body has, and impacts that nobody sees.

#include <vector>

#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// What is wrong with the bodies of a model at the values of its parameters, `pi` among them: negative masses and moments, an
/// inertia that is not positive semidefinite are errors; principal moments of which one exceeds the sum of the others, where more than one of
/// them has a part in the motion, and neither mass nor inertia, are warnings. A restitution outside of 0 to 1 is an error. Flat bodies and thin rods are fine. What has no known value is
/// passed over.
std::vector<support::Diagnostic> impossible_bodies(const Model& model, const Values& values);

/// The same with the values that the parameters of the model have, wherever they come from.
std::vector<support::Diagnostic> impossible_bodies(const Model& model);

}  // namespace gaussgen::model
