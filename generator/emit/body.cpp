#include "emit/body.hpp"

#include <algorithm>
#include <unordered_set>

#include "emit/identifiers.hpp"
#include "emit/natural.hpp"
#include "emit/text.hpp"

namespace gaussgen::emit {

namespace {

constexpr std::size_t k_comment_width = 104;
/// In one call: two registers of the widest kind, and few enough for what passes them on one by one.
constexpr std::size_t k_most_angles = 16;

}  // namespace

Body::Body(const passes::Writing& writing, const UnitNames& names, NameScope& scope)
    : writing_(writing), names_(names), writer_(writing, names), scope_(scope) {}

void Body::blank_line() {
  if (!statements_.empty() && !std::holds_alternative<cpp::BlankLine>(statements_.back())) {
    statements_.emplace_back(std::in_place_type<cpp::BlankLine>);
  }
}

void Body::define(const passes::Program& program) {
  const std::string* above = nullptr;
  for (const passes::Block& block : program.blocks) {
    // A link with two hinges is minimised over one after the other: one heading is enough for what goes on under it.
    const bool goes_on = above != nullptr && !block.comment.empty() && *above == block.comment;
    above = &block.comment;
    if (!goes_on) blank_line();
    if (!goes_on && !block.comment.empty()) add(cpp::Comment{wrapped(block.comment, k_comment_width)});
    for (std::size_t i = 0; i < block.assignments.size();) {
      const std::size_t angles = angles_from(block.assignments, i);
      if (angles > 1) {
        define_angles(block.assignments, i, angles);
      } else {
        define(block.assignments[i]);
      }
      i += std::max<std::size_t>(angles, 1);
    }
  }
}

std::size_t Body::angles_from(const Assignments& assignments, std::size_t first) const {
  std::unordered_set<std::uint32_t> found;
  const auto depends = [&](NodeId root) {
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
      const NodeId id = stack.back();
      stack.pop_back();
      if (found.count(id.index) != 0) return true;
      if (writer_.bound(id) != nullptr) continue;
      const ir::Children& operands = writing_.operands(id);
      stack.insert(stack.end(), operands.begin(), operands.end());
    }
    return false;
  };
  std::size_t count = 0;
  for (; count < k_most_angles && first + count < assignments.size(); ++count) {
    const passes::Assignment& assignment = assignments[first + count];
    if (!assignment.cosine || depends(writing_.operands(assignment.node)[0])) break;
    found.insert({assignment.node.index, assignment.cosine->index});
  }
  return count;
}

void Body::define_angles(const Assignments& assignments, std::size_t first, std::size_t count) {
  std::vector<cpp::Expression> arguments;
  for (std::size_t i = first; i < first + count; ++i) {
    const passes::Assignment& assignment = assignments[i];
    const std::string sine = name_for(assignment.node, assignment.name);
    const std::string cosine = name_for(*assignment.cosine, assignment.cosine_name);
    add(cpp::Declaration{"S", {sine, cosine}});
    arguments.push_back(writer_.value(writing_.operands(assignment.node)[0]));
    arguments.push_back(cpp::atom(sine));
    arguments.push_back(cpp::atom(cosine));
    writer_.bind(assignment.node, sine);
    writer_.bind(*assignment.cosine, cosine);
  }
  add(cpp::Evaluation{cpp::call("Angles<S>::sincos", std::move(arguments))});
}

void Body::define(const passes::Assignment& assignment) {
  if (assignment.cosine) {
    const std::string sine = name_for(assignment.node, assignment.name);
    const std::string cosine = name_for(*assignment.cosine, assignment.cosine_name);
    const cpp::Expression argument = writer_.value(writing_.operands(assignment.node)[0]);
    add(cpp::Declaration{"S", {sine, cosine}});
    add(cpp::Evaluation{cpp::call("Math<S>::sincos", {argument, cpp::atom(sine), cpp::atom(cosine)})});
    writer_.bind(assignment.node, sine);
    writer_.bind(*assignment.cosine, cosine);
    return;
  }
  const bool is_condition = passes::is_boolean(writing_.graph(), assignment.node);
  cpp::Expression value = writer_.definition(assignment.node);
  const std::string name = name_for(assignment.node, assignment.name);
  add(cpp::Definition{is_condition ? "const Bool" : "const S", name, std::move(value)});
  writer_.bind(assignment.node, name);
}

cpp::Expression Body::define_condition(NodeId id, const std::string& name) {
  if (writing_.graph()[id].kind == ir::Kind::constant || writer_.bound(id) != nullptr) return writer_.condition(id);
  const std::string text = scope_.allocate(name);
  add(cpp::Definition{"const Bool", text, writer_.condition(id)});
  return cpp::atom(text);
}

std::string Body::name_for(NodeId id, const std::string& wanted) {
  if (const auto own = reserved_.find(id.index); own != reserved_.end()) return own->second;
  // Where the wanted name is taken, wanted_2 would read as its square.
  const std::string natural = natural_name_for(id);
  for (const std::string& name : {wanted, natural}) {
    if (!name.empty() && scope_.is_free(mangled(name))) return scope_.allocate(name);
  }
  if (wanted.empty() && natural.empty()) return scope_.allocate_anonymous("t");
  return scope_.allocate(wanted.empty() ? natural : wanted);
}

std::string Body::natural_name_for(NodeId id) const {
  const ir::Graph& graph = writing_.graph();
  const auto name_of = [&](NodeId operand) -> std::string {
    if (const std::string* bound = writer_.bound(operand)) return *bound;
    const ir::Node& node = graph[operand];
    if (node.kind != ir::Kind::symbol) return {};
    const std::string text = names_.of_symbol(node.symbol);
    return text.find(':') == std::string::npos ? text : graph.symbol(node.symbol).name;
  };
  return natural_name(graph, id, name_of);
}

void name_type_of_conditions(std::vector<cpp::Statement>& statements, bool is_returned) {
  const bool has_conditions =
      is_returned || std::any_of(statements.begin(), statements.end(), [](const auto& statement) {
        const auto* definition = std::get_if<cpp::Definition>(&statement);
        return definition != nullptr && definition->type == "const Bool";
      });
  if (has_conditions) statements.insert(statements.begin(), cpp::Alias{"Bool", "typename Math<S>::Bool"});
}

}  // namespace gaussgen::emit
