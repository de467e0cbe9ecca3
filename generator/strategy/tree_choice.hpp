#pragma once

#include <optional>
#include <vector>

#include "strategy/tree.hpp"

namespace gaussgen::strategy {

/// A solution with the steps that lead to it.
struct Candidate {
  Solution solution;
  Steps steps;
  int operations = 0;  ///< of the accelerations and their conditions
  int latency = 0;     ///< of the same: see ir/latency.hpp

  std::string about;  ///< the form of the tree, where it is a special one

  /// About the time that a processor takes, twice: it does two operations at once where they do not wait for each other.
  int cycles() const { return operations + latency; }
};

Candidate counted(Solution solution, Steps steps);

/// The form of the tree that takes the fewest operations: with both places for the drift, and in the units in which most
/// lengths and masses are 1 where all are numbers. Nothing where `solve_tree` finds nothing.
std::optional<Candidate> cheapest_tree(const TreeProblem& problem, ir::Expr epsilon);

}  // namespace gaussgen::strategy
