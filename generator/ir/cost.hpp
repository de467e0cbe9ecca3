#pragma once

#include <map>
#include <string>
#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// Operation counts of a set of roots with every shared node counted once. Negation and comparison are free, as is
/// what depends on parameters and constants alone (it is computed in `prepare`).
struct OperationCount {
  int additions = 0;
  int multiplications = 0;
  int divisions = 0;
  int square_roots = 0;
  int functions = 0;
  std::map<std::string, int> by_function;

  int total() const { return additions + multiplications + divisions + square_roots + functions; }
};

OperationCount count_operations(const Graph& graph, const std::vector<NodeId>& roots, bool with_preparation = false);

/// Total of count_operations.
int operations(const Graph& graph, const std::vector<NodeId>& roots);

/// Of these nodes alone, each with its operands given; none of them depends on parameters alone.
int operations_of(const Graph& graph, const std::vector<NodeId>& nodes);

/// Whether `a` takes fewer operations than `b`, as `operations` counts them. Where both stand on the same functions and named
/// values, what lies below counts for both: two ways to write one sum are compared at about the cost of that sum.
bool takes_fewer_operations(const Graph& graph, NodeId a, NodeId b);

}  // namespace gaussgen::ir
