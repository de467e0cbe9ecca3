#pragma once

#include <string>
#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// Broken invariants (graph.hpp) of everything below `roots`, one line each; empty when sound.
std::vector<std::string> violations(const Graph& graph, const std::vector<NodeId>& roots);

}  // namespace gaussgen::ir
