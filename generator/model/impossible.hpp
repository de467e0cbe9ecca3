#pragma once
// Masses and inertias that no body has.

#include <vector>

#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// What is wrong with the bodies of a model at the values of its parameters, `pi` among them: negative masses and moments, an
/// inertia that is not positive semidefinite, principal moments of which one exceeds the sum of the others, are errors; neither
/// mass nor inertia is a warning. Flat bodies and thin rods are fine. What has no known value is passed over.
std::vector<support::Diagnostic> impossible_bodies(const std::vector<Body>& bodies, const Values& values);

/// The same with the values that the parameters of the model have, wherever they come from.
std::vector<support::Diagnostic> impossible_bodies(const Model& model);

}  // namespace gaussgen::model
