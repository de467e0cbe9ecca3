#include "emit/body.hpp"

#include "emit/identifiers.hpp"
#include "emit/natural.hpp"
#include "emit/text.hpp"

namespace gaussgen::emit {

namespace {

constexpr std::size_t k_comment_width = 104;

}  // namespace

Body::Body(const passes::Writing& writing, const UnitNames& names, NameScope& scope)
    : writing_(writing), names_(names), writer_(writing, names), scope_(scope) {}

void Body::blank_line() {
  if (!statements_.empty() && !std::holds_alternative<cpp::BlankLine>(statements_.back())) {
    statements_.emplace_back(std::in_place_type<cpp::BlankLine>);
  }
}

void Body::define(const passes::Program& program) {
  for (const passes::Block& block : program.blocks) {
    blank_line();
    if (!block.comment.empty()) add(cpp::Comment{wrapped(block.comment, k_comment_width)});
    for (const passes::Assignment& assignment : block.assignments) define(assignment);
  }
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

}  // namespace gaussgen::emit
