#include "emit/lookup.hpp"

#include <set>

#include "emit/literal.hpp"
#include "emit/text.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::emit {

using cpp::Expression;
using ir::TableId;
using support::Table;

namespace {

constexpr std::size_t k_comment_width = 104;

cpp::Function function_of(const std::string& type, const std::string& name, std::vector<cpp::Argument> arguments) {
  cpp::Function function;
  function.prefix = "GAUSS_FUNCTION";
  function.type = type;
  function.name = name;
  function.arguments = std::move(arguments);
  function.suffix = "noexcept";
  return function;
}

std::string text_of(std::size_t number) { return std::to_string(number); }

/// The begin and the coefficients.
std::size_t width(const Table& table) { return table.degree() + 2; }

std::vector<std::vector<Expression>> rows_of(const Table& table) {
  std::vector<std::vector<Expression>> rows;
  for (const Table::Piece& piece : table.pieces) {
    std::vector<Expression> row{literal(piece.begin)};
    for (const ir::Rational& coefficient : piece.coefficients) row.push_back(literal(coefficient));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// for (int i …) piece[i] = value;
cpp::Loop copied(const Table& table, Expression value) {
  return {"i", "0", text_of(width(table)), {{cpp::Assignment{cpp::atom("piece[i]"), std::move(value)}}}};
}

cpp::Function pieces_function(const Table& table, const std::string& name) {
  const std::string piece = "(&piece)[" + text_of(width(table)) + "]";
  cpp::Function function = function_of("void", name, {{"const S&", "x", true}, {"S", piece, true}});
  function.comment = wrapped("Table " + table.name + ": " + table.about, k_comment_width) + "\n" +
                     wrapped(
                         "The piece that x lies in, the last one that begins at or before it: its begin, then the "
                         "coefficients of 1, u, u^2, ... with u = x - begin.",
                         k_comment_width);
  function.body.emplace_back(cpp::Array{"S", "pieces", rows_of(table)});
  function.body.emplace_back(copied(table, cpp::atom("pieces[0][i]")));
  const Expression is_reached = cpp::call("Math<S>::at_most", {cpp::atom("pieces[k][0]"), cpp::atom("x")});
  const Expression chosen =
      cpp::call("Math<S>::select", {cpp::atom("is_reached"), cpp::atom("pieces[k][i]"), cpp::atom("piece[i]")});
  cpp::Loop loop{"k", "1", text_of(table.pieces.size()), {}};
  loop.body.push_back({cpp::Definition{"const typename Math<S>::Bool", "is_reached", is_reached}});
  loop.body.push_back({copied(table, chosen)});
  function.body.emplace_back(std::move(loop));
  return function;
}

/// n (n - 1) … of a derivative.
ir::Rational falling(std::size_t n, int order) {
  ir::Rational result = 1;
  for (int i = 0; i < order; ++i) result = result * (static_cast<int>(n) - i);
  return result;
}

Expression coefficient(std::size_t n, int order) {
  const Expression entry = cpp::atom("piece[" + text_of(n + 1) + "]");
  const ir::Rational factor = falling(n, order);
  return factor == 1 ? entry : cpp::product({literal(factor), entry});
}

/// Horner's rule. A constant takes x - x with it, so that no NaN gets lost.
Expression polynomial(const Table& table, int order) {
  const std::size_t lowest = static_cast<std::size_t>(order);
  Expression value = coefficient(table.degree(), order);
  if (table.degree() == lowest) return cpp::sum({value, cpp::sum({cpp::atom("x"), cpp::negated(cpp::atom("x"))})});
  for (std::size_t n = table.degree(); n-- > lowest;) {
    value = cpp::sum({coefficient(n, order), cpp::product({cpp::atom("u"), std::move(value)})});
  }
  return value;
}

cpp::Function value_function(const Table& table, const UnitNames& names, TableId id, int order) {
  cpp::Function function = function_of("S", names.of_table(id, order), {{"const S&", "x", true}});
  const std::string which = order == 0 ? "The value" : "Derivative " + std::to_string(order);
  function.comment = which + " of the table " + table.name + " at x.";
  function.body.emplace_back(cpp::Declaration{"S", {"piece[" + text_of(width(table)) + "]"}});
  function.body.emplace_back(cpp::Evaluation{cpp::call(names.of_pieces(id), {cpp::atom("x"), cpp::atom("piece")})});
  if (static_cast<std::size_t>(order) < table.degree()) {
    const Expression u = cpp::sum({cpp::atom("x"), cpp::negated(cpp::atom("piece[0]"))});
    function.body.emplace_back(cpp::Definition{"const S", "u", u});
  }
  function.body.emplace_back(cpp::Return{polynomial(table, order)});
  return function;
}

/// Tables and orders that some function or default value needs.
std::set<std::pair<std::uint32_t, int>> used_tables(const Plan& plan) {
  std::vector<NodeId> roots;
  for (const Task& task : plan.tasks)
    roots.insert(roots.end(), task.request.outputs.begin(), task.request.outputs.end());
  for (const PreparedMember& member : plan.prepared) roots.push_back(member.value);
  for (const ParameterEntry& parameter : plan.unit.parameters) roots.push_back(parameter.value);
  for (const InputEntry& input : plan.unit.inputs) roots.push_back(input.value);
  std::set<std::pair<std::uint32_t, int>> used;
  for (const NodeId id : ir::post_order(plan.graph, roots)) {
    const ir::Node& node = plan.graph[id];
    const bool is_table = node.kind == ir::Kind::function && node.function == ir::Function::table;
    if (is_table) used.emplace(node.table.index, support::to_int(node.value));
  }
  return used;
}

}  // namespace

std::vector<cpp::Function> table_functions(const Plan& plan) {
  std::vector<cpp::Function> functions;
  std::set<std::uint32_t> begun;
  for (const auto& [index, order] : used_tables(plan)) {
    const TableId id{index};
    const Table& table = plan.graph.table(id);
    if (begun.insert(index).second) functions.push_back(pieces_function(table, plan.names.of_pieces(id)));
    functions.push_back(value_function(table, plan.names, id, order));
  }
  return functions;
}

std::map<std::string, Operations> costs_of(const std::vector<cpp::Function>& tables) {
  std::map<std::string, Operations> costs;
  for (const cpp::Function& function : tables) costs.emplace(function.name + "<S>", operations_of(function));
  return costs;
}

}  // namespace gaussgen::emit
