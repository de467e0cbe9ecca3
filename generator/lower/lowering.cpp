#include "lower/lowering.hpp"

#include <algorithm>
#include <string>

#include "support/assert.hpp"
#include "symbolic/rational.hpp"

namespace gaussgen::lower {

using GiNaC::ex;
using ir::NodeId;

namespace {

ir::Function function_named(const std::string& name) {
  for (const ir::Function function : {ir::Function::sin, ir::Function::cos, ir::Function::tan, ir::Function::asin,
                                      ir::Function::acos, ir::Function::atan, ir::Function::atan2, ir::Function::exp,
                                      ir::Function::log, ir::Function::sinh, ir::Function::cosh, ir::Function::tanh}) {
    if (ir::name_of(function) == name) return function;
  }
  // symbolic/choices.hpp
  for (const ir::Function function : {ir::Function::abs, ir::Function::sign, ir::Function::min, ir::Function::max}) {
    if (std::string(ir::name_of(function)) + "_of" == name) return function;
  }
  GAUSS_ASSERT(false, "GiNaC function {}", name);
  return ir::Function::sin;
}

}  // namespace

NodeId Lowering::operator()(const ex& expression) {
  if (const auto known = memo_.find(expression); known != memo_.end()) return known->second;
  const NodeId node = lowered(expression);
  memo_.emplace(expression, node);
  return node;
}

std::vector<NodeId> Lowering::operands(const ex& expression) {
  std::vector<NodeId> nodes;
  nodes.reserve(expression.nops());
  for (const ex& operand : expression) nodes.push_back((*this)(operand));
  return nodes;
}

NodeId Lowering::lowered(const ex& expression) {
  if (GiNaC::is_a<GiNaC::numeric>(expression)) {
    return graph_.constant(symbolic::rational(GiNaC::ex_to<GiNaC::numeric>(expression)));
  }
  if (GiNaC::is_a<GiNaC::symbol>(expression)) return resolve_(GiNaC::ex_to<GiNaC::symbol>(expression));
  if (expression.is_equal(GiNaC::Pi)) return graph_.use(pi_);
  if (GiNaC::is_a<GiNaC::add>(expression)) return sum(expression);
  if (GiNaC::is_a<GiNaC::mul>(expression)) return graph_.product(operands(expression));
  if (GiNaC::is_a<GiNaC::power>(expression)) return power(expression);
  GAUSS_ASSERT(GiNaC::is_a<GiNaC::function>(expression), "an expression of class {}",
               GiNaC::ex_to<GiNaC::basic>(expression).class_name());
  return call(expression);
}

NodeId Lowering::sum(const ex& expression) {
  std::vector<NodeId> terms = operands(expression);
  // The graph looks for sin² + cos² from the first term on: in GiNaC's order the pair found could differ.
  std::sort(terms.begin(), terms.end(), [this](NodeId a, NodeId b) { return graph_.compare(a, b) < 0; });
  return graph_.sum(terms);
}

NodeId Lowering::power(const ex& expression) {
  const ex& exponent = expression.op(1);
  GAUSS_ASSERT(GiNaC::is_a<GiNaC::numeric>(exponent), "a power with a variable exponent");
  return graph_.power((*this)(expression.op(0)), symbolic::rational(GiNaC::ex_to<GiNaC::numeric>(exponent)));
}

NodeId Lowering::call(const ex& expression) {
  const std::string name = GiNaC::ex_to<GiNaC::function>(expression).get_name();
  if (name == "table_at") return table(expression);
  const std::vector<NodeId> nodes = operands(expression);
  if (name != "case_less" && name != "case_at_most") return graph_.call(function_named(name), nodes);
  const NodeId condition =
      graph_.call(name == "case_less" ? ir::Function::less : ir::Function::at_most, {nodes[0], nodes[1]});
  return graph_.call(ir::Function::piecewise, {condition, nodes[2], nodes[3]});
}

// The graph has the tables of the model in their order.
NodeId Lowering::table(const ex& expression) {
  const int index = GiNaC::ex_to<GiNaC::numeric>(expression.op(0)).to_int();
  const int order = GiNaC::ex_to<GiNaC::numeric>(expression.op(1)).to_int();
  GAUSS_ASSERT(static_cast<std::size_t>(index) < graph_.table_count(), "table {} of {}", index, graph_.table_count());
  return graph_.look_up(ir::TableId{static_cast<std::uint32_t>(index)}, order, (*this)(expression.op(2)));
}

}  // namespace gaussgen::lower
