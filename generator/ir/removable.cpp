#include "ir/removable.hpp"

#include <functional>
#include <vector>

#include "ir/content.hpp"

namespace gaussgen::ir {

namespace {

/// With 16 terms, what is left out of Σ (-x²)^k/(2k + 1)! is below 1e-24 of the sum up to x² = 4, and below 0.02 ε up to x² = 100 ε^(1/16), as
/// (33!)^(1/16) = 200. More have numbers beyond the range of float.
constexpr int k_terms = 16;
constexpr int k_reach_of_a_type = 100;

/// Up to which x² a series is taken. sin(x)/x is as good by itself, but for x = 0; its slopes are from here on, and the series loses a digit
/// beyond. What is a difference is as good further out, and the sum of absolute terms there is twice the value.
constexpr int k_reach_of_quotients = 2;
constexpr int k_reach_of_differences = 4;

Rational factorial(int n) { return n < 2 ? Rational(1) : n * factorial(n - 1); }

struct Power {
  NodeId base;
  Rational exponent;
};

std::vector<Power> powers_in(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind == Kind::constant) return {};
  if (node.kind == Kind::sum && node.value == 0 && node.children.size() == 1) return powers_in(graph, node.children[0]);
  const auto one = [&](NodeId factor) {
    const Node& power = graph[factor];
    return power.kind == Kind::power ? Power{power.children[0], power.value} : Power{factor, 1};
  };
  std::vector<Power> powers;
  if (node.kind != Kind::product) return {one(id)};
  for (const NodeId child : node.children) powers.push_back(one(child));
  return powers;
}

/// Whether x^sign is a factor of the reciprocal of a product.
bool is_divided_by(const Graph& graph, const std::vector<Power>& product, NodeId x, int sign) {
  const std::vector<Power> wanted = powers_in(graph, x);
  if (wanted.empty()) return false;
  for (const Power& part : wanted) {
    bool is_there = false;
    for (const Power& power : product) {
      is_there = is_there || (power.base == part.base && part.exponent > 0 && sign * power.exponent <= -part.exponent);
    }
    if (!is_there) return false;
  }
  return true;
}

class Removal {
 public:
  Removal(Expr product, Expr epsilon) : product_(product), epsilon_(epsilon), graph_(product.graph()) {}

  // Each step takes a function that has a zero at 0 out of the product, so this ends.
  Expr run() {
    while (step()) {
    }
    return product_;
  }

 private:
  bool step() {
    const std::vector<Power> powers = powers_in(graph_, product_.id());
    for (const Power& power : powers) {
      if (!support::is_integer(power.exponent)) continue;
      const Kind kind = graph_[power.base].kind;
      if (kind == Kind::function && of_function(powers, power)) return true;
      if (kind == Kind::sum && of_difference(powers, power)) return true;
    }
    return false;
  }

  void exchange(Expr factor, int sign, Expr by) { product_ = product_ * pow(factor, -sign) * pow(by, sign); }

  bool of_function(const std::vector<Power>& powers, const Power& power) {
    const Function function = graph_[power.base].function;
    const bool has_zero = function == Function::sin || function == Function::sinh || function == Function::tan;
    const int sign = power.exponent < 0 ? -1 : 1;
    if (!has_zero || !is_divided_by(graph_, powers, graph_[power.base].children[0], sign)) return false;
    const Expr x(graph_, graph_[power.base].children[0]);
    Expr by = x * (function == Function::sinh ? hyperbolic_quotient(x) : quotient(x));
    if (function == Function::tan) by = by * pow(call(Function::cos, x), -1);
    exchange(Expr(graph_, power.base), sign, by);
    return true;
  }

  bool of_difference(const std::vector<Power>& powers, const Power& power) {
    const int sign = power.exponent < 0 ? -1 : 1;
    const std::vector<NodeId> terms = listed(graph_[power.base].children);
    for (const NodeId term : terms) {
      for (const Power& part : powers_in(graph_, term)) {
        if (graph_[part.base].kind != Kind::function || graph_[part.base].children.size() != 1) continue;
        const Expr x(graph_, graph_[part.base].children[0]);
        if (is_divided_by(graph_, powers, x.id(), sign) && of_difference(power.base, sign, x)) return true;
      }
    }
    return false;
  }

  bool of_difference(NodeId sum, int sign, Expr x) {
    const Expr half = Rational(1) / 2 * x, square = pow(x, 2), cube = pow(x, 3);
    const Expr sine = call(Function::sin, x), cosine = call(Function::cos, x), growing = call(Function::cosh, x);
    const Expr one(graph_, graph_.constant(1));
    // A division by the square has two roundings, the square of a reciprocal three.
    const Expr by_square = pow(square.kept_whole(""), -1);
    const auto is = [&](Expr difference, const std::function<Expr()>& form) {
      const Node& node = graph_[difference.id()];
      if (node.kind != Kind::sum) return false;
      const Rational content = signed_content(node);
      if (graph_.scale(1 / content, difference.id()) != sum) return false;
      exchange(Expr(graph_, sum), sign, 1 / content * form());
      return true;
    };
    return is(one - cosine,
              [&] {
                return square * difference_or(x, -1, versine, 2 * pow(call(Function::sin, half), 2) * by_square);
              }) ||
           is(one - growing,
              [&] { return -(square * difference_or(x, 1, versine, (growing.kept_whole("") - one) * by_square)); }) ||
           is(x - sine, [&] { return cube * difference_or(x, -1, excess, (one - sine * pow(x, -1)) * by_square); }) ||
           is(sine - x * cosine,
              [&] { return cube * difference_or(x, -1, bend, (sine * pow(x, -1) - cosine) * by_square); });
  }

  static Rational versine(int k) { return 1 / factorial(2 * k + 2); }
  static Rational excess(int k) { return 1 / factorial(2 * k + 3); }
  static Rational bend(int k) { return (2 * k + 2) / factorial(2 * k + 3); }

  Expr difference_or(Expr x, int sign, Rational (*coefficient)(int), Expr otherwise) {
    return series_or(x, sign, k_reach_of_differences, coefficient, otherwise);
  }

  Expr quotient(Expr x) {
    return series_or(
        x, -1, k_reach_of_quotients, [](int k) { return 1 / factorial(2 * k + 1); },
        call(Function::sin, x) * pow(x, -1));
  }

  Expr hyperbolic_quotient(Expr x) {
    return series_or(
        x, 1, k_reach_of_quotients, [](int k) { return 1 / factorial(2 * k + 1); },
        call(Function::sinh, x) * pow(x, -1));
  }

  /// Σ coefficient(k) (sign x²)^k up to where its terms end, and `otherwise` beyond.
  Expr series_or(Expr x, int sign, int reach, const std::function<Rational(int)>& coefficient, Expr otherwise) {
    const Expr square = pow(x, 2);
    Expr sum(graph_, graph_.constant(coefficient(k_terms - 1)));
    // By Horner's rule, each step a value of its own: multiplied out, their numbers would be beyond the range of float.
    for (int k = k_terms - 2; k >= 0; --k) {
      const Expr first(graph_, graph_.constant(coefficient(k)));
      sum = (first + Rational(sign) * (square * sum)).kept_whole("");
    }
    const Expr of_type = Rational(k_reach_of_a_type) * pow(epsilon_, Rational(1) / k_terms);
    const Expr most(graph_, graph_.constant(reach));
    const Expr limit(graph_, graph_.call(Function::min, {of_type.id(), most.id()}));
    return select(less(square, limit), sum, otherwise);
  }

  Expr product_;
  Expr epsilon_;
  Graph& graph_;
};

}  // namespace

Expr without_removable_pole(Expr product, Expr epsilon) { return Removal(product, epsilon).run(); }

}  // namespace gaussgen::ir
