#pragma once
// Which nodes become temporaries.

#include <string>
#include <unordered_map>
#include <unordered_set>

#include "passes/program.hpp"

namespace gaussgen::passes {

struct Sharing {
  std::unordered_set<std::uint32_t> temporaries;
  std::unordered_map<std::uint32_t, NodeId> cosine_of;  ///< sine -> cosine of the same argument, both temporaries
  std::unordered_map<std::uint32_t, NodeId> sine_of;    ///< the other way round
  std::unordered_map<std::uint32_t, std::string> names;  ///< wanted by a section, a label or a named node
  std::unordered_map<std::uint32_t, std::string> suggestions;

  bool is_temporary(NodeId id) const { return temporaries.count(id.index) != 0; }
  std::string name(NodeId id) const;
};

/// Temporaries are: what is used more than once and costs an operation, what has a name, every value of a function such
/// as sin, and what would make one expression too long to read.
Sharing share(const Writing& writing, const Request& request);

/// Constants, symbols and negation cost nothing and are written in place; so is a named node, whose name goes to what it
/// names.
bool is_trivial(const Graph& graph, NodeId id);

/// What a named node names; any other node itself.
NodeId unwrapped(const Graph& graph, NodeId id);

}  // namespace gaussgen::passes
