#include "emit/structs.hpp"

#include "emit/cpp_printer.hpp"
#include "emit/expression.hpp"
#include "emit/formula.hpp"
#include "emit/literal.hpp"
#include "emit/text.hpp"
#include "ir/node_table.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::emit {

namespace {

std::string described(const std::string& unit, const std::string& about) {
  return comment_text((unit.empty() ? "" : "[" + unit + "] ") + about);
}

/// Whether an expression stays small without names for what is shared in it; a choice repeats what it compares.
bool is_small(const ir::Graph& graph, NodeId value) {
  constexpr std::size_t k_copies_in_choice = 4, k_most_nodes = 500;
  ir::NodeTable<std::size_t> sizes;
  for (const NodeId id : ir::post_order(graph, {value})) {
    const ir::Node& node = graph[id];
    const bool is_choice = node.kind == ir::Kind::function && ir::is_choice(node.function);
    std::size_t size = 1;
    for (const NodeId child : node.children) size += (is_choice ? k_copies_in_choice : 1) * *sizes.find(child);
    if (size > k_most_nodes) return false;
    sizes[id] = size;
  }
  return true;
}

/// What a prepared value is, where that takes a few words.
std::string formula_of(Plan& plan, NodeId value) {
  if (!is_small(plan.graph, value)) return {};
  const passes::Writing writing(plan.graph, {value});
  const std::string formula = cpp::print(as_formula(ExpressionWriter(writing, plan.names).value(value)));
  return formula.size() > 60 ? std::string() : formula;
}

/// A default value, with its decimal form where it is written as a quotient.
cpp::Member member_with_default(Plan& plan, const Entry& entry, NodeId value) {
  const passes::Writing writing(plan.graph, {value});
  const ExpressionWriter writer(writing, plan.names);
  std::string comment = described(entry.unit, entry.about);
  const ir::Node& node = plan.graph[value];
  if (node.kind == ir::Kind::constant && !is_single_literal(node.value)) {
    comment = decimal_text(node.value) + (comment.empty() ? "" : " ") + comment;
  }
  return {"S", plan.names.of(entry), {}, writer.value(value), comment};
}

void add_accessors(cpp::Struct& type, const std::vector<std::string>& names) {
  for (const bool is_const : {false, true}) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      cpp::Function accessor;
      accessor.prefix = "GAUSS_FUNCTION";
      accessor.type = is_const ? "const S&" : "S&";
      accessor.name = names[i];
      accessor.suffix = is_const ? "const noexcept" : "noexcept";
      accessor.body = {cpp::Return{cpp::atom("values[" + std::to_string(i) + "]")}};
      type.functions.push_back(std::move(accessor));
    }
  }
}

// An array has at least one element in C++, also when every coordinate is held.
cpp::Member values_member(const Plan& plan) {
  if (plan.unit.configuration.empty()) return {"S", "values", {"1"}, std::nullopt, "unused: no coordinate is free"};
  return {"S", "values", {"n_q + n_v"}, std::nullopt, {}};
}

}  // namespace

cpp::Struct parameters_struct(Plan& plan) {
  cpp::Struct type;
  type.comment = "Constants of a run, with the values of the model as defaults.";
  type.name = "Parameters";
  for (const ParameterEntry& parameter : plan.unit.parameters) {
    if (!parameter.is_formula) type.members.push_back(member_with_default(plan, parameter.entry, parameter.value));
  }
  return type;
}

cpp::Struct inputs_struct(Plan& plan) {
  cpp::Struct type;
  type.comment = "What a caller supplies at each call.";
  type.name = "Inputs";
  for (const InputEntry& input : plan.unit.inputs)
    type.members.push_back(member_with_default(plan, input.entry, input.value));
  return type;
}

cpp::Struct prepared_struct(Plan& plan) {
  cpp::Struct type;
  type.comment = "Parameters as the functions read them, and what follows from them alone; made by prepare().";
  type.name = "Prepared";
  for (const PreparedMember& member : plan.prepared) {
    const bool is_found = !member.is_plain && !member.is_formula;
    const std::string comment = is_found ? formula_of(plan, member.value) : comment_text(member.about);
    type.members.push_back({"S", member.name, {}, std::nullopt, comment});
  }
  return type;
}

cpp::Struct state_struct(const Plan& plan) {
  cpp::Struct type;
  type.comment = "Coordinates, then speeds: an array for integrators, with access by name.";
  type.name = "State";
  type.members.push_back(values_member(plan));
  std::vector<std::string> names;
  for (const Entry& entry : plan.unit.configuration) names.push_back(plan.names.of(entry));
  for (const Entry& entry : plan.unit.speeds) names.push_back(plan.names.of(entry));
  add_accessors(type, names);
  return type;
}

cpp::Struct derivative_struct(const Plan& plan) {
  cpp::Struct type;
  type.comment = "The rate of a State, in the same order: rates of the coordinates, then accelerations.";
  type.name = "Derivative";
  type.members.push_back(values_member(plan));
  std::vector<std::string> names;
  for (const std::string& rate : plan.unit.configuration_rates) names.push_back(plan.names.of(rate));
  for (const Entry& entry : plan.unit.accelerations) names.push_back(plan.names.of(entry));
  add_accessors(type, names);
  return type;
}

}  // namespace gaussgen::emit
