#pragma once

#include <string>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// One expression in infix form, named nodes by their names. For dumps, tests and messages.
std::string print(const Graph& graph, NodeId id);

}  // namespace gaussgen::ir
