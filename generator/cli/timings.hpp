#pragma once

#include "cli/messages.hpp"
#include "pipeline.hpp"

namespace gaussgen::cli {

/// Says on standard error what each stage of the derivation took, how many operations each pass saved, and the most memory
/// that there was in use.
void print_timings(const PipelineResult& result, const MessageOptions& messages);

}  // namespace gaussgen::cli
