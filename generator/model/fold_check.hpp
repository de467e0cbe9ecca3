#pragma once

#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Errors for expressions whose numbers grow too large for exact arithmetic once parameters are numbers, too: (k*x)^64 is
/// harmless until k is 1e300.
void check_fold(const Model& model, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
