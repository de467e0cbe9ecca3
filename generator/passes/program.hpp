#pragma once
// A function as a list of statements: what `schedule` makes and the emitter prints.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "passes/writing.hpp"

namespace gaussgen::passes {

/// Nodes that belong together on the page, with the names wanted for them.
struct Section {
  std::string comment;
  std::vector<std::pair<NodeId, std::string>> nodes;
};

/// What one function has to compute.
struct Request {
  std::vector<NodeId> outputs;
  std::vector<Section> sections;
  /// Names for nodes that become temporaries anyway, such as results that are also tested.
  std::vector<std::pair<NodeId, std::string>> suggestions;
};

/// One temporary, or a sine and a cosine of one argument that are computed together.
struct Assignment {
  NodeId node;                   ///< the sine of a pair
  std::string name;              ///< wanted; empty for an anonymous shared term
  std::optional<NodeId> cosine;  ///< second of a pair
  std::string cosine_name;
};

struct Block {
  std::string comment;
  std::vector<Assignment> assignments;
};

struct Program {
  std::vector<Block> blocks;
  std::vector<NodeId> outputs;
};

/// True for conditions, which have a type of their own.
bool is_boolean(const ir::Graph& graph, NodeId id);

/// Broken invariants, one line each: a temporary is defined once and before it is used, every temporary is used, and
/// what is written out in place is written once. Empty when sound.
std::vector<std::string> violations(const Writing& writing, const Program& program);

}  // namespace gaussgen::passes
