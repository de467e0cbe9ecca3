#pragma once
// Outputs that were asked for by name, and in which this model has nothing, or nothing to be trusted.

#include "emit/unit.hpp"
#include "pipeline.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// A warning for each that `unit` lacks, and for derivatives where constraints follow from others wherever they hold. Of the usual set, which nobody chose,
/// nothing is said.
void check_outputs(const emit::Unit& unit, Mechanics& mechanics, const PipelineOptions& options,
                   support::Diagnostics& diagnostics);

/// The same warnings before any output is formed.
void check_outputs(Mechanics& mechanics, const PipelineOptions& options, support::Diagnostics& diagnostics);

}  // namespace gaussgen
