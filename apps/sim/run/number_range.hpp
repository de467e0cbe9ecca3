#pragma once
// Whether a number type holds the values of a model.

#include "model/evaluate.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Of parameters, inputs and initial values: what float cannot hold would become 0 or infinite without a word. Told at the place of the number type in the
/// scene; throws cli::UsageError where an option says it.
void check_range_of_numbers(const Scene& scene, const gaussgen::model::Model& model,
                            const gaussgen::model::Values& parameters, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
