#pragma once
// What is wrong with a model whatever its equations of motion are, found before the time is spent on them.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Errors for expressions without a value and for constraints without a gradient: those of check_structure that need neither
/// bodies nor their accelerations.
void check_early(const model::Model& model, const MechanicsOptions& options, support::Diagnostics& diagnostics);

}  // namespace gaussgen
