#pragma once

#include "emit/unit.hpp"
#include "mechanics.hpp"
#include "pipeline.hpp"

namespace gaussgen {

/// Tables, names and artefacts for the emitter.
emit::Unit build_unit(Mechanics& mechanics, const support::Source& source, const PipelineOptions& options);

}  // namespace gaussgen
