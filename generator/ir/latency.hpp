#pragma once
// How long results wait for each other.

#include <vector>

#include "ir/graph.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::ir {

/// Processor cycles of the longest chain of operations of which each needs the one before, on a processor that has as many units as it likes: 4 for a sum
/// or product of two, 14 for a division, 18 for a root, 60 for other functions (A. Fog, Instruction tables, 2022: x86 processors since 2015 within some
/// cycles). Sums and products of several take what is ready first. What parameters alone make is ready at once.
int latency(const Graph& graph, const std::vector<NodeId>& roots);

/// When each node below `roots` is ready, in the same measure; 0 where nothing is found.
NodeTable<int> ready_times(const Graph& graph, const std::vector<NodeId>& roots);

}  // namespace gaussgen::ir
