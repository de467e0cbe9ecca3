// Function calls: exact special values, and signs pulled out of odd and even functions.

#include <optional>
#include <utility>

#include "ir/content.hpp"
#include "ir/graph.hpp"
#include "ir/quarter_turns.hpp"

namespace gaussgen::ir {

std::string_view name_of(Function function) {
  switch (function) {
    case Function::sin: return "sin";
    case Function::cos: return "cos";
    case Function::tan: return "tan";
    case Function::asin: return "asin";
    case Function::acos: return "acos";
    case Function::atan: return "atan";
    case Function::atan2: return "atan2";
    case Function::exp: return "exp";
    case Function::log: return "log";
    case Function::sinh: return "sinh";
    case Function::cosh: return "cosh";
    case Function::tanh: return "tanh";
    case Function::abs: return "abs";
    case Function::sign: return "sign";
    case Function::min: return "min";
    case Function::max: return "max";
    case Function::piecewise: return "piecewise";
    case Function::table: return "table";
    case Function::less: return "less";
    case Function::at_most: return "at_most";
    case Function::not_finite: return "not_finite";
    case Function::any: return "any";
    case Function::select: return "select";
  }
  return "?";
}

bool is_boolean(Function function) { return function >= Function::less && function != Function::select; }

bool is_choice(Function function) {
  return (function >= Function::abs && function <= Function::piecewise) || function == Function::select;
}

Parity parity(Function function) {
  switch (function) {
    case Function::sin:
    case Function::tan:
    case Function::asin:
    case Function::atan:
    case Function::sinh:
    case Function::tanh:
    case Function::sign: return Parity::odd;
    case Function::cos:
    case Function::cosh:
    case Function::abs: return Parity::even;
    default: return Parity::none;
  }
}

namespace {

bool has_negative_sign(const Node& node) {
  if (node.kind == Kind::constant) return node.value < 0;
  return node.kind == Kind::sum && signed_content(node) < 0;
}

/// Of abs and sign anywhere, else f(0) where it is rational; log and acos have theirs at 1.
bool exact_value(Function function, const Rational& at, Rational& value) {
  if (function == Function::abs || function == Function::sign) {
    value = function == Function::abs ? cln::abs(at) : cln::signum(at);
    return true;
  }
  const bool at_one = function == Function::log || function == Function::acos;
  if (at != (at_one ? 1 : 0)) return false;
  if (function == Function::atan2 || function >= Function::min) return false;
  value = function == Function::cos || function == Function::exp || function == Function::cosh ? 1 : 0;
  return true;
}

/// constant + coefficient * epsilon
struct WithRounding {
  Rational constant = 0, coefficient = 0;
};

bool is_epsilon(const Graph& graph, const Node& node) {
  return node.kind == Kind::symbol && graph.symbol(node.symbol).symbol_class == SymbolClass::epsilon;
}

std::optional<WithRounding> with_rounding(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind == Kind::constant) return WithRounding{node.value, 0};
  if (is_epsilon(graph, node)) return WithRounding{0, 1};
  const bool is_sum_of_two = node.kind == Kind::sum && node.children.size() == 1;
  if (!is_sum_of_two || !is_epsilon(graph, graph[node.children[0]])) return std::nullopt;
  return WithRounding{node.value, node.coefficients[0]};
}

/// 1/128 of a type with 8 binary digits: none for mechanics has fewer.
constexpr int k_one_over_largest_epsilon = 128;

/// Between numbers, and what the rounding unit adds to them: the same for every type of numbers.
std::optional<bool> decided_comparison(const Graph& graph, Function function, const std::vector<NodeId>& arguments) {
  if (function != Function::less && function != Function::at_most) return std::nullopt;
  const auto a = with_rounding(graph, arguments[0]);
  const auto b = with_rounding(graph, arguments[1]);
  if (!a || !b) return std::nullopt;
  const auto holds_at = [&](const Rational& epsilon) {
    const Rational left = a->constant + a->coefficient * epsilon, right = b->constant + b->coefficient * epsilon;
    return function == Function::less ? left < right : left <= right;
  };
  const bool holds = holds_at(0);
  return holds_at(Rational(1) / k_one_over_largest_epsilon) == holds ? std::optional(holds) : std::nullopt;
}

/// Without conditions that never hold, which leaves one, or none.
std::vector<NodeId> undecided(const Graph& graph, const std::vector<NodeId>& conditions) {
  std::vector<NodeId> rest;
  for (const NodeId condition : conditions) {
    if (graph.is_one(condition)) return {condition};
    if (!graph.is_zero(condition)) rest.push_back(condition);
  }
  return rest;
}

/// -x <= c is -c <= x, where c is there before: a sign less at each evaluation.
bool is_better_mirrored(const Graph& graph, Function function, const std::vector<NodeId>& arguments) {
  if (function != Function::less && function != Function::at_most) return false;
  const auto is_negative = [&](NodeId id) { return graph.varies(id) && has_negative_sign(graph[id]); };
  return (is_negative(arguments[0]) && !graph.varies(arguments[1])) ||
         (is_negative(arguments[1]) && !graph.varies(arguments[0]));
}

/// What the larger or smaller of two is where that is known: numbers, and x beside x.
std::optional<NodeId> decided_extreme(const Graph& graph, Function function, const std::vector<NodeId>& arguments) {
  if (function != Function::min && function != Function::max) return std::nullopt;
  if (arguments[0] == arguments[1]) return arguments[0];
  const Node& a = graph[arguments[0]];
  const Node& b = graph[arguments[1]];
  if (a.kind != Kind::constant || b.kind != Kind::constant) return std::nullopt;
  return arguments[(function == Function::min) == (a.value <= b.value) ? 0 : 1];
}

/// Of atan2(y, x) where nothing of it changes, so that fixed directions are exact: y/√(x² + y²), x/√(x² + y²).
std::optional<NodeId> of_fixed_direction(Graph& graph, Function function, const Node& angle) {
  const bool is_circular = function == Function::sin || function == Function::cos;
  if (!is_circular || angle.kind != Kind::function || angle.function != Function::atan2) return std::nullopt;
  const NodeId y = angle.children[0], x = angle.children[1];
  if (graph.varies(y) || graph.varies(x)) return std::nullopt;
  const NodeId squared = graph.sum({graph.power(x, 2), graph.power(y, 2)});
  return graph.product({function == Function::sin ? y : x, graph.power(squared, Rational(-1) / 2)});
}

/// |x| is never negative: a size, or an even power.
bool is_size(const Node& node) {
  if (node.kind == Kind::function) return node.function == Function::abs;
  return node.kind == Kind::power && support::is_integer(node.value / 2);
}

}  // namespace

NodeId Graph::look_up(TableId table, int order, NodeId argument) {
  const support::Table& points = this->table(table);
  if (order > static_cast<int>(points.degree())) return is_undefined(argument) ? argument : constant(0);
  const Node& at = (*this)[argument];
  if (at.kind == Kind::constant) return constant(support::value_at(points, order, at.value));
  Node node;
  node.kind = Kind::function;
  node.function = Function::table;
  node.table = table;
  node.value = order;
  node.children = {argument};
  return intern(std::move(node));
}

NodeId Graph::call_again(const Node& node, std::vector<NodeId> arguments) {
  if (node.function == Function::table) return look_up(node.table, support::to_int(node.value), arguments[0]);
  return call(node.function, std::move(arguments));
}

NodeId Graph::call(Function function, std::vector<NodeId> arguments) {
  if (const auto decided = decided_comparison(*this, function, arguments)) return constant(*decided ? 1 : 0);
  if (is_better_mirrored(*this, function, arguments)) {
    const NodeId first = scale(-1, arguments[1]);
    return call(function, {first, scale(-1, arguments[0])});
  }
  if (const auto extreme = decided_extreme(*this, function, arguments)) return *extreme;
  if (function == Function::any) {
    arguments = undecided(*this, arguments);
    if (arguments.size() < 2) return arguments.empty() ? constant(0) : arguments[0];
  }
  if (function == Function::select || function == Function::piecewise) {
    if (arguments[1] == arguments[2]) return arguments[1];
    const Node& condition = (*this)[arguments[0]];
    if (condition.kind == Kind::constant) return arguments[condition.value == 0 ? 2 : 1];
  }
  if (arguments.size() == 1) {
    const Node& argument = (*this)[arguments[0]];
    Rational value = 0;
    if (function == Function::abs && is_size(argument)) return arguments[0];
    if (argument.kind == Kind::constant && exact_value(function, argument.value, value)) return constant(value);
    if (const auto turned = of_quarter_turns(*this, function, arguments[0])) return *turned;
    if (const auto direction = of_fixed_direction(*this, function, argument)) return *direction;
    const Parity kind = parity(function);
    if (kind != Parity::none && has_negative_sign(argument)) {
      const NodeId mirrored = call(function, {scale(-1, arguments[0])});
      return kind == Parity::odd ? scale(-1, mirrored) : mirrored;
    }
  }
  // A condition stays a condition for those that choose by it, and they may do without what they do not choose.
  const bool is_number = !is_boolean(function) && function != Function::select && function != Function::piecewise;
  if (const auto undefined = first_undefined(arguments); undefined && is_number) return *undefined;
  Node node;
  node.kind = Kind::function;
  node.function = function;
  node.children.assign(arguments.begin(), arguments.end());
  return intern(std::move(node));
}

}  // namespace gaussgen::ir
