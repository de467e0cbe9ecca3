#pragma once
// Outputs that were asked for by name, and in which this model has nothing.

#include "emit/unit.hpp"
#include "pipeline.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// A warning for each that `unit` lacks. Of the usual set, which nobody chose, nothing is said.
void check_outputs(const Mechanics& mechanics, const emit::Unit& unit, const PipelineOptions& options,
                   support::Diagnostics& diagnostics);

}  // namespace gaussgen
