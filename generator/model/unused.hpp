#pragma once

#include "model/model.hpp"
#include "support/diagnostics.hpp"
#include "support/source.hpp"

namespace gaussgen::model {

/// Warns of tables, parameters and inputs that no expression of a model without errors uses.
void check_uses(const Model& model, const support::Source& source, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
