#pragma once
// Nodes that have no value whatever their symbols are, such as 1/(y - y).

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// Whether `node`, about to enter the graph, holds a constant part without a finite real value: a pole, a root or a
/// logarithm of what has none. It shuts out 0 * (1/0) = 0 and 1/0 - 1/0 = 0: simplification keeps such nodes, so that the
/// value is not finite at run time and says so. What chooses among its arguments may do without them.
bool has_no_value(const Graph& graph, const Node& node);

}  // namespace gaussgen::ir
