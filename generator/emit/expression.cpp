#include "emit/expression.hpp"

#include <algorithm>

#include "emit/choice.hpp"
#include "emit/literal.hpp"
#include "ir/content.hpp"
#include "ir/print.hpp"
#include "support/assert.hpp"

namespace gaussgen::emit {

using cpp::Expression;
using ir::Kind;
using ir::Node;
using ir::Rational;
using passes::PowerForm;

const std::string* ExpressionWriter::bound(NodeId id) const {
  const auto it = bound_.find(id.index);
  return it == bound_.end() ? nullptr : &it->second;
}

Expression ExpressionWriter::value(NodeId id) const {
  if (const std::string* name = bound(id)) return cpp::atom(*name);
  return definition(id);
}

Expression ExpressionWriter::definition(NodeId id) const {
  const Node& node = writing_.graph()[id];
  switch (node.kind) {
    case Kind::constant: return literal(node.value);
    case Kind::symbol: return symbol(node);
    case Kind::named: return value(node.children[0]);
    case Kind::function: return function(node);
    case Kind::sum: return sum(node);
    case Kind::power: return power(id);
    case Kind::product: return scaled(1, id);
  }
  return {};
}

Expression ExpressionWriter::symbol(const Node& node) const {
  const std::string text = names_.of_symbol(node.symbol);
  GAUSS_ASSERT(!text.empty(), "symbol={} has no place in emitted code", writing_.graph().symbol(node.symbol).name);
  return cpp::atom(text);
}

Expression ExpressionWriter::condition(NodeId id) const {
  const Node& node = writing_.graph()[id];
  return node.kind == Kind::constant ? cpp::atom(node.value == 0 ? "Bool(false)" : "Bool(true)") : value(id);
}

Expression ExpressionWriter::choice(const Node& node) const {
  const bool is_piecewise = node.function == ir::Function::piecewise;
  const Node& compared = is_piecewise ? writing_.graph()[node.children[0]] : node;
  std::vector<Comparand> operands;
  for (const NodeId child : compared.children) {
    operands.push_back({value(child), writing_.graph()[child].kind == Kind::constant});
  }
  switch (node.function) {
    case ir::Function::abs: return size_of(operands[0].value);
    case ir::Function::sign: return sign_of(operands[0].value);
    case ir::Function::min: return smaller(operands[0], operands[1]);
    case ir::Function::max: return larger(operands[0], operands[1]);
    default: break;
  }
  const bool is_strict = compared.function == ir::Function::less;
  return by_case({is_strict, operands[0], operands[1]}, value(node.children[1]), value(node.children[2]));
}

Expression ExpressionWriter::function(const Node& node) const {
  if (ir::is_choice(node.function) && node.function != ir::Function::select) return choice(node);
  if (node.function == ir::Function::table) {
    // With its type, which is not that of the argument where that is an expression template.
    return cpp::call(names_.of_table(node.table, support::to_int(node.value)) + "<S>", {value(node.children[0])});
  }
  std::vector<Expression> arguments;
  for (const NodeId child : node.children) {
    const bool is_condition =
        node.function == ir::Function::any || (node.function == ir::Function::select && arguments.empty());
    arguments.push_back(is_condition ? condition(child) : value(child));
  }
  return cpp::call("Math<S>::" + std::string(ir::name_of(node.function)), std::move(arguments));
}

Expression ExpressionWriter::power(NodeId id) const {
  const PowerForm& form = writing_.power_form(id);
  const Rational& exponent = writing_.graph()[id].value;
  switch (form.kind) {
    case PowerForm::Kind::square_root: return cpp::call("Math<S>::sqrt", {value(form.operands[0])});
    case PowerForm::Kind::general: return cpp::call("Math<S>::pow", {value(form.operands[0]), literal(exponent)});
    default: return scaled(1, id);
  }
}

namespace {

bool is_negation(const Node& node) {
  return node.kind == Kind::sum && node.value == 0 && node.children.size() == 1 && node.coefficients[0] == -1;
}

}  // namespace

void ExpressionWriter::multiply(Fraction& fraction, NodeId factor) const {
  const Node& node = writing_.graph()[factor];
  if (bound(factor) == nullptr && node.kind == Kind::product) {
    std::vector<NodeId> children = listed(node.children);
    if (children.size() > 2) {
      std::stable_sort(children.begin(), children.end(),
                       [&](NodeId a, NodeId b) { return writing_.ready(a) < writing_.ready(b); });
    }
    for (const NodeId child : children) multiply(fraction, child);
    return;
  }
  if (bound(factor) == nullptr && node.kind == Kind::power) {
    const PowerForm& form = writing_.power_form(factor);
    if (form.kind == PowerForm::Kind::reciprocal) return divide(fraction, form.operands[0]);
    if (form.kind == PowerForm::Kind::factors) {
      for (const NodeId operand : form.operands) multiply(fraction, operand);
      return;
    }
  }
  if (bound(factor) == nullptr && node.kind == Kind::named) return multiply(fraction, node.children[0]);
  // -x among factors: the sign goes in front of them all.
  if (bound(factor) == nullptr && is_negation(node)) {
    fraction.is_negative = !fraction.is_negative;
    return multiply(fraction, node.children[0]);
  }
  fraction.top.push_back(value(factor));
}

// a / (b c c) and not a / (b (c c)).
void ExpressionWriter::divide(Fraction& fraction, NodeId divisor) const {
  Fraction inner;
  multiply(inner, divisor);
  fraction.bottom.insert(fraction.bottom.end(), inner.top.begin(), inner.top.end());
  fraction.top.insert(fraction.top.end(), inner.bottom.begin(), inner.bottom.end());
  fraction.is_negative = fraction.is_negative != inner.is_negative;
}

Expression ExpressionWriter::scaled(const Rational& factor, NodeId id) const {
  Fraction fraction;
  multiply(fraction, id);
  if (factor != 1 && fraction.top.empty() && !is_single_literal(factor)) {
    fraction.top.push_back(literal(cln::numerator(factor)));
    fraction.bottom.insert(fraction.bottom.begin(), literal(cln::denominator(factor)));
  } else if (factor != 1 || fraction.top.empty()) {
    fraction.top.insert(fraction.top.begin(), literal(factor));
  }
  Expression result = cpp::product(std::move(fraction.top));
  if (!fraction.bottom.empty()) result = cpp::quotient(std::move(result), cpp::product(std::move(fraction.bottom)));
  return fraction.is_negative ? cpp::negated(std::move(result)) : result;
}

namespace {

struct Item {
  Rational coefficient;
  const NodeId* node;  ///< null for the constant
};

// What is ready first is added first: C++ adds from the left.
std::vector<Item> items_of(const Node& sum, const passes::Writing& writing) {
  std::vector<Item> items;
  if (sum.value != 0) items.push_back({sum.value, nullptr});
  for (std::size_t i = 0; i < sum.children.size(); ++i) items.push_back({sum.coefficients[i], &sum.children[i]});
  const auto ready = [&](const Item& item) { return item.node == nullptr ? 0 : writing.ready(*item.node); };
  if (items.size() > 2) {
    std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) { return ready(a) < ready(b); });
  }
  return items;
}

int multiplications(const std::vector<Item>& items, const Rational& divisor) {
  int count = 0;
  for (const Item& item : items) {
    const Rational rest = cln::abs(item.coefficient / divisor);
    if (item.node != nullptr && rest != 1) count += is_single_literal(rest) ? 1 : 2;
  }
  return count;
}

// Pulled out where that saves a multiplication: a/2 + b/2 is 0.5 (a + b), but 1 + 2 x stays.
Rational common_factor(const Node& sum, const std::vector<Item>& items) {
  Rational content = cln::abs(ir::signed_content(sum));
  const bool all_negative =
      std::all_of(items.begin(), items.end(), [](const Item& item) { return item.coefficient < 0; });
  const int inside = multiplications(items, content) + (is_single_literal(content) ? 1 : 2);
  if (items.size() == 1 || inside >= multiplications(items, 1)) content = 1;
  return all_negative ? Rational(-content) : content;
}

}  // namespace

Expression ExpressionWriter::sum(const Node& node) const {
  const std::vector<Item> items = items_of(node, writing_);
  const Rational factor = common_factor(node, items);
  std::vector<Expression> terms;
  for (const Item& item : items) {
    const Rational coefficient = item.coefficient / factor;
    const Rational size = cln::abs(coefficient);
    Expression term = item.node == nullptr ? literal(size) : scaled(size, *item.node);
    if (coefficient < 0) term = cpp::negated(std::move(term));
    terms.push_back(std::move(term));
  }
  // -(-a + b) is a - b, and b comes first in -a + b.
  const auto is_negation = [](const Expression& term) { return term.kind == Expression::Kind::negation; };
  const bool is_negative = factor < 0 && std::none_of(terms.begin(), terms.end(), is_negation);
  if (factor < 0 && !is_negative) std::transform(terms.begin(), terms.end(), terms.begin(), cpp::negated);
  const auto positive = std::find_if_not(terms.begin(), terms.end(), is_negation);
  if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
  Expression result = cpp::sum(std::move(terms));
  const Rational size = cln::abs(factor);
  if (size != 1) result = cpp::product({literal(size), std::move(result)});
  return is_negative ? cpp::negated(std::move(result)) : result;
}

}  // namespace gaussgen::emit
