#pragma once
// Outputs that were asked for by name, and in which this model has nothing.

#include "emit/unit.hpp"
#include "pipeline.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// A warning for each that `unit` lacks. Of the usual set, which nobody chose, nothing is said.
void check_outputs(const emit::Unit& unit, const model::Model& model, const PipelineOptions& options,
                   support::Diagnostics& diagnostics);

/// The same warnings before any output is formed.
void check_outputs(Mechanics& mechanics, const PipelineOptions& options, support::Diagnostics& diagnostics);

}  // namespace gaussgen
