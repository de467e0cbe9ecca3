#pragma once
// What the factorisation found out about a model as a whole, in every configuration.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Errors for expressions without a value, for constraints without a gradient and for speeds that nothing determines.
void check_structure(Mechanics& mechanics, support::Diagnostics& diagnostics);

/// An error: no free speed is in the constraint.
void report_no_gradient(const model::Constraint& row, support::Diagnostics& diagnostics);

/// A warning for every constraint that follows from the others in every configuration; where there is an initial state,
/// ConstraintCheck says more.
void report_redundant(const Mechanics& mechanics, support::Diagnostics& diagnostics);

/// A warning where the emitted route does not take the dependent speeds that the model chooses, as they are not safe.
void check_choice(const Mechanics& mechanics, support::Diagnostics& diagnostics);

/// Where the model declares the coordinate or the angular velocity that is called `label`.
support::Span span_of_speed(const model::Model& model, const std::string& label);

}  // namespace gaussgen
