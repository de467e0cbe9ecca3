#pragma once

#include "passes/program.hpp"

namespace gaussgen::passes {

/// sin(a + b) and cos(a + b) by the sines and cosines of a and b, where a program has those anyway: three operations each, where a
/// call takes the time of twenty. The one pass that may add operations.
Request split_calls(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
