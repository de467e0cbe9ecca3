#include "series_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "ir/traverse.hpp"
#include "model/expressions.hpp"
#include "model/functions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

using ir::Function;
using ir::NodeId;

bool changes_in_a_step(const ir::Symbol& symbol) {
  return symbol.symbol_class == ir::SymbolClass::time || symbol.symbol_class == ir::SymbolClass::configuration ||
         symbol.symbol_class == ir::SymbolClass::speed;
}

/// A pivot is divided by unless it is lost to rounding; where it is, the status says so.
bool is_of_pivot(const ir::Graph& graph, const ir::Node& node) {
  return node.function == Function::select && (graph.is_zero(node.children[1]) || graph.is_zero(node.children[2]));
}

bool has_cases(Function function) { return function == Function::piecewise || function == Function::select; }

/// What is chosen by; of all others, the function itself.
NodeId decided_by(const ir::Node& node, NodeId id) { return has_cases(node.function) ? node.children[0] : id; }

/// Functions with a jump or a kink in what changes within a step.
std::vector<Function> edges_of(const Mechanics& mechanics) {
  std::vector<NodeId> roots;
  for (const ir::Expr rate : mechanics.kinematics.configuration_rates.values()) roots.push_back(rate.id());
  for (const ir::Expr acceleration : mechanics.solution.accelerations) roots.push_back(acceleration.id());
  const ir::Graph& graph = mechanics.graph;
  const std::vector<NodeId> order = ir::post_order(graph, roots);
  const ir::NodeSet changing = ir::depends_on(graph, order, changes_in_a_step);
  std::vector<Function> edges;
  const auto is_condition = [&](NodeId id) {
    return graph[id].kind == ir::Kind::function && ir::is_boolean(graph[id].function);
  };
  for (const NodeId id : ir::post_order(graph, roots, is_condition)) {
    const ir::Node& node = graph[id];
    const bool may_have_one =
        node.kind == ir::Kind::function && (ir::is_choice(node.function) || node.function == Function::table);
    if (may_have_one && !is_of_pivot(graph, node) && changing.contains(decided_by(node, id)))
      edges.push_back(node.function);
  }
  return edges;
}

/// Where the model calls such a function of something that is no parameter.
class Finder {
 public:
  Finder(const model::Model& model, const std::vector<Function>& edges) : model_(model), edges_(edges) {}

  std::optional<model::Name> find() {
    model::for_each_expression(model_, [&](const model::Ast& ast, const model::Place&) { visit(ast); });
    return found_;
  }

 private:
  void visit(const model::Ast& ast) {
    if (found_) return;
    if (ast.kind == model::AstKind::call && is_meant(ast) && varies(ast)) found_ = model::Name{ast.name, ast.span};
    for (const model::Ast& child : ast.children) visit(child);
  }

  bool is_meant(const model::Ast& ast) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](Function edge) {
      return edge == Function::table ? ast.table != nullptr : ast.name == ir::name_of(edge);
    });
  }

  bool varies(const model::Ast& ast) const {
    if (ast.kind == model::AstKind::symbol) {
      const auto symbol = model_.symbols.find(ast.name);
      return symbol != model_.symbols.end() && symbol->second.kind != model::SymbolKind::pi &&
             symbol->second.kind != model::SymbolKind::parameter;
    }
    return std::any_of(ast.children.begin(), ast.children.end(), [this](const auto& child) { return varies(child); });
  }

  const model::Model& model_;
  const std::vector<Function>& edges_;
  std::optional<model::Name> found_;
};

}  // namespace

void check_series(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const std::vector<Function> edges = edges_of(mechanics);
  if (edges.empty()) return;
  const char* const taken = "the output 'taylor' differentiates the motion without end";
  if (const auto name = Finder(mechanics.model, edges).find()) {
    diagnostics.error(support::code::k_not_smooth, name->span,
                      fmt::format("{}(...) has a jump or a kink: {}", name->text, taken),
                      "take 'taylor' out of the outputs, or write a smooth form, as sqrt(x^2 + eps^2) for abs(x)");
    return;
  }
  diagnostics.error(
      support::code::k_not_smooth, mechanics.model.name.span,
      fmt::format("the equations of motion choose between two forms by the state, as those of sin(q)/q do "
                  "near q = 0: {}",
                  taken),
      "take 'taylor' out of the outputs; '--as-written limits' leaves sin(q)/q without a value at 0");
}

}  // namespace gaussgen
