#pragma once
// Which values have to be looked at, so that none of many is a NaN or an infinity.

#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::passes {

using ir::NodeId;

/// Those of `values`, each once and without a sign, that have to be finite numbers for all of them to be: what is not finite makes sums and products
/// of it so. It may get lost below a division (1/∞ = 0), unless it is a NaN, as sines and cosines make of it, and in functions and
/// choices. Holds in floating-point arithmetic, overflow included.
std::vector<NodeId> fewest_to_check(const ir::Graph& graph, const std::vector<NodeId>& values);

}  // namespace gaussgen::passes
