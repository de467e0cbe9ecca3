#pragma once

#include <string>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// One expression in infix form, named nodes by their names. For dumps, tests and messages.
std::string print(const Graph& graph, NodeId id);

/// The same with "..." for everything after the first `nodes` nodes: shared parts can make the full text endless.
std::string print_brief(const Graph& graph, NodeId id, int nodes = 24);

}  // namespace gaussgen::ir
