#include "passes/program.hpp"

#include <unordered_set>

#include "ir/print.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;

bool is_boolean(const ir::Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind == Kind::named) return is_boolean(graph, node.children[0]);
  return node.kind == Kind::function && ir::is_boolean(node.function);
}

namespace {

class Checker {
 public:
  Checker(const Writing& writing, const Program& program) : writing_(writing) {
    for (const Block& block : program.blocks) {
      for (const Assignment& assignment : block.assignments) {
        declare(assignment.node);
        if (assignment.cosine) declare(*assignment.cosine);
      }
    }
  }

  void check(const Program& program) {
    for (const Block& block : program.blocks) {
      for (const Assignment& assignment : block.assignments) {
        for (const NodeId operand : writing_.operands(assignment.node)) use(operand);
        defined_.insert(assignment.node.index);
        if (assignment.cosine) defined_.insert(assignment.cosine->index);
      }
    }
    for (const NodeId output : program.outputs) use(output);
    for (const NodeId id : declared_) {
      if (used_.count(id.index) == 0) report(id, "temporary without a use");
    }
  }

  std::vector<std::string> found;

 private:
  void report(NodeId id, const std::string& what) { found.push_back(what + ": " + ir::print(writing_.graph(), id)); }

  void declare(NodeId id) {
    if (!temporaries_.insert(id.index).second) report(id, "temporary defined twice");
    declared_.push_back(id);
  }

  void use(NodeId root) {
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
      const NodeId id = stack.back();
      stack.pop_back();
      if (temporaries_.count(id.index) != 0) {
        used_.insert(id.index);
        if (defined_.count(id.index) == 0) report(id, "temporary used before its definition");
        continue;
      }
      const ir::Children& operands = writing_.operands(id);
      if (!written_.insert(id.index).second && !is_trivial(writing_.graph(), id)) report(id, "computed twice");
      stack.insert(stack.end(), operands.begin(), operands.end());
    }
  }

  const Writing& writing_;
  std::vector<NodeId> declared_;
  std::unordered_set<std::uint32_t> temporaries_;
  std::unordered_set<std::uint32_t> defined_;
  std::unordered_set<std::uint32_t> used_;
  std::unordered_set<std::uint32_t> written_;
};

}  // namespace

std::vector<std::string> violations(const Writing& writing, const Program& program) {
  Checker checker(writing, program);
  checker.check(program);
  return checker.found;
}

}  // namespace gaussgen::passes
