#pragma once

#include "emit/unit.hpp"
#include "mechanics.hpp"
#include "pipeline.hpp"

namespace gaussgen {

/// Names of output_kinds: those that the options ask for, else those of the model, else the usual ones.
std::vector<std::string> wanted_outputs(const model::Model& model, const PipelineOptions& options);

/// Tables, names and artefacts for the emitter.
emit::Unit build_unit(Mechanics& mechanics, const support::Source& source, const PipelineOptions& options);

}  // namespace gaussgen
