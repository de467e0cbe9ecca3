#include "passes/schedule.hpp"

#include <algorithm>

#include "ir/traverse.hpp"
#include "support/assert.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;

namespace {

class Scheduler {
 public:
  Scheduler(const Writing& writing, const Sharing& sharing) : writing_(writing), sharing_(sharing) {}

  Program run(const Request& request) {
    circular_functions(request);
    for (const Section& section : request.sections) {
      open(section.comment);
      for (const auto& [node, name] : section.nodes) {
        const NodeId target = unwrapped(writing_.graph(), node);
        if (sharing_.is_temporary(target)) place(target);
      }
    }
    // After all that has a comment of its own, what is left belongs to results.
    open(request.sections.empty() ? "Shared terms" : "Results");
    for (const NodeId output : request.outputs) place(output);
    close();
    program_.outputs = request.outputs;
    return std::move(program_);
  }

 private:
  // sin and cos of plain arguments, those first that are needed first: what follows can begin while others are computed.
  void circular_functions(const Request& request) {
    std::vector<NodeId> roots;
    for (const Section& section : request.sections) {
      for (const auto& [node, name] : section.nodes) {
        const NodeId target = unwrapped(writing_.graph(), node);
        if (sharing_.is_temporary(target)) roots.push_back(target);
      }
    }
    roots.insert(roots.end(), request.outputs.begin(), request.outputs.end());
    open("Sines and cosines");
    for (const NodeId id : ir::post_order(writing_.graph(), roots)) {
      const Node& node = writing_.graph()[id];
      const bool is_circular =
          node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos);
      if (is_circular && sharing_.is_temporary(id) && is_plain(node.children[0])) place(id);
    }
  }

  bool is_plain(NodeId root) const {
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
      const NodeId id = stack.back();
      stack.pop_back();
      if (sharing_.is_temporary(id)) return false;
      const ir::Children& operands = writing_.operands(id);
      stack.insert(stack.end(), operands.begin(), operands.end());
    }
    return true;
  }

  void open(const std::string& comment) {
    close();
    block_.comment = comment;
  }

  void close() {
    if (!block_.assignments.empty()) program_.blocks.push_back(std::move(block_));
    block_ = {};
  }

  // Without recursion: the depth of the graph grows with the model.
  void place(NodeId root) {
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
      const NodeId id = stack.back();
      if (seen_.insert(id.index).second) {
        const ir::Children& operands = writing_.operands(id);
        for (auto it = operands.rbegin(); it != operands.rend(); ++it) {
          if (seen_.count(it->index) == 0) stack.push_back(*it);
        }
      } else {
        stack.pop_back();
        if (sharing_.is_temporary(id) && placed_.insert(id.index).second) append(id);
      }
    }
  }

  void append(NodeId id) {
    Assignment assignment{id, sharing_.name(id), std::nullopt, {}};
    if (const auto sine = sharing_.sine_of.find(id.index); sine != sharing_.sine_of.end()) {
      assignment.node = sine->second;
      assignment.name = sharing_.name(sine->second);
    }
    if (const auto cosine = sharing_.cosine_of.find(assignment.node.index); cosine != sharing_.cosine_of.end()) {
      assignment.cosine = cosine->second;
      assignment.cosine_name = sharing_.name(cosine->second);
      placed_.insert(cosine->second.index);
    }
    placed_.insert(assignment.node.index);
    block_.assignments.push_back(std::move(assignment));
  }

  const Writing& writing_;
  const Sharing& sharing_;
  std::unordered_set<std::uint32_t> seen_;
  std::unordered_set<std::uint32_t> placed_;
  Block block_;
  Program program_;
};

}  // namespace

Program schedule(const Writing& writing, const Sharing& sharing, const Request& request) {
  Program program = Scheduler(writing, sharing).run(request);
  const std::vector<std::string> broken = violations(writing, program);
  GAUSS_ASSERT(broken.empty(), "{} (and {} more)", broken.front(), broken.size() - 1);
  return program;
}

}  // namespace gaussgen::passes
