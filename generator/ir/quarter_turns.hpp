#pragma once

#include <optional>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// sin, cos or tan of c π + x for a rational c: by one of x where c is a multiple of 1/2 (of 1 for tan), and a number where x is 0 and the
/// value is rational, which it is for multiples of 1/6 (sin, cos) and 1/4 (tan) alone (Niven, Irrational Numbers, 3.11 and 3.12). Nothing
/// for other functions and angles.
std::optional<NodeId> of_quarter_turns(Graph& graph, Function function, NodeId angle);

}  // namespace gaussgen::ir
