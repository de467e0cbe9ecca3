// Products and powers: coefficients out, like bases merged, sums primitive, canonical order.

#include <algorithm>
#include <optional>

#include "ir/content.hpp"
#include "ir/graph.hpp"
#include "ir/positions.hpp"
#include "support/assert.hpp"

namespace gaussgen::ir {

namespace {

/// Products of this many factors are written as they are: what people write by hand has fewer.
constexpr std::size_t k_most_side_by_side = 24;
constexpr std::size_t k_largest_group = 8;

struct Factor {
  NodeId base;
  Rational exponent;
};

/// Collects factors as base^exponent with one rational coefficient outside.
class FactorCollector {
 public:
  explicit FactorCollector(Graph& graph) : graph_(graph) {}

  void multiply(NodeId id) {
    const Node& node = graph_[id];
    if (node.kind == Kind::constant) {
      coefficient_ = coefficient_ * node.value;
    } else if (node.kind == Kind::product) {
      for (const NodeId child : node.children) multiply(child);
    } else if (node.kind == Kind::sum && node.value == 0 && node.children.size() == 1) {
      coefficient_ = coefficient_ * node.coefficients[0];
      multiply(node.children[0]);
    } else if (node.kind == Kind::sum) {
      const Rational content = signed_content(node);
      coefficient_ = coefficient_ * content;
      merge(graph_.scale(1 / content, id), 1);
    } else if (node.kind == Kind::power) {
      merge(node.children[0], node.value);
    } else {
      merge(id, 1);
    }
  }

  const Rational& coefficient() const { return coefficient_; }
  const std::vector<Factor>& factors() const { return factors_; }

 private:
  void merge(NodeId base, const Rational& exponent) {
    const auto [place, is_new] = positions_.emplace(base);
    if (is_new) {
      factors_.push_back({base, exponent});
    } else {
      Rational& sum = factors_[place].exponent;
      sum = sum + exponent;
    }
  }

  Graph& graph_;
  Rational coefficient_ = 1;
  std::vector<Factor> factors_;
  Positions positions_;  ///< in factors_
};

bool can_be_factor(const Node& node) {
  switch (node.kind) {
    case Kind::constant:
    case Kind::product: return false;
    case Kind::sum: return signed_content(node) == 1;
    default: return true;
  }
}

/// gcd of fractions: gcd of the numerators over lcm of the denominators.
Rational common_content(const Rational& a, const Rational& b) {
  if (a == 0) return cln::abs(b);
  if (a == 1 && support::is_integer(b)) return a;  // of a long sum, nearly always
  return Rational(cln::gcd(cln::numerator(a), cln::numerator(b))) / cln::lcm(cln::denominator(a), cln::denominator(b));
}

/// Coprime integers of more bits come from numbers with many digits, and are beyond the range of a type where these were not.
constexpr long k_most_bits = 53;

bool has_long_integers(const Node& sum, const Rational& content) {
  const auto is_long = [&](const Rational& value) {
    return static_cast<long>(cln::integer_length(cln::numerator(value / content))) > k_most_bits;
  };
  return is_long(sum.value) || std::any_of(sum.coefficients.begin(), sum.coefficients.end(), is_long);
}

/// The power of two at or below the largest of the numbers.
Rational size_of(const Node& sum) {
  Rational largest = cln::abs(sum.value);
  for (const Rational& coefficient : sum.coefficients) largest = std::max<Rational>(largest, cln::abs(coefficient));
  const long above = static_cast<long>(cln::integer_length(cln::numerator(largest)));
  const long below = static_cast<long>(cln::integer_length(cln::denominator(largest)));
  const long bits = above - below;
  const Rational power =
      bits < 0 ? Rational(1) / cln::ash(cln::cl_I(1), -bits) : Rational(cln::ash(cln::cl_I(1), bits));
  return power <= largest ? power : Rational(power / 2);
}

}  // namespace

Rational signed_content(const Node& sum) {
  Rational content = sum.value;
  int signs = sum.value < 0 ? -1 : (sum.value > 0 ? 1 : 0);
  for (const Rational& coefficient : sum.coefficients) {
    content = common_content(content, coefficient);
    signs += coefficient < 0 ? -1 : 1;
  }
  if (has_long_integers(sum, content)) content = size_of(sum);
  const Rational& leading = sum.value == 0 ? sum.coefficients[0] : sum.value;
  const bool negative = signs < 0 || (signs == 0 && leading < 0);
  return negative ? Rational(-cln::abs(content)) : cln::abs(content);
}

/// In canonical order, so that the order of the factors does not matter.
std::optional<NodeId> Graph::first_undefined(const std::vector<NodeId>& nodes) const {
  std::optional<NodeId> first;
  for (const NodeId node : nodes) {
    if (is_undefined(node) && (!first || compare(node, *first) < 0)) first = node;
  }
  return first;
}

NodeId Graph::product(const std::vector<NodeId>& nodes) {
  // Neither 0/0 = 0 nor (1/0)^0 = 1; and what has no value takes no more room than it has to.
  if (const auto undefined = first_undefined(nodes)) return *undefined;
  if (std::any_of(nodes.begin(), nodes.end(), [this](NodeId id) { return is_zero(id); })) return constant(0);
  const auto base_of = [this](NodeId id) { return (*this)[id].kind == Kind::power ? (*this)[id].children[0] : id; };
  FactorCollector collector(*this);
  for (const NodeId node : nodes) collector.multiply(node);
  if (collector.coefficient() == 0) return constant(0);

  // x^(1/2) x^(1/2) is x again, which may itself be a product, a sum or a power: then collect once more.
  std::vector<NodeId> factors;
  bool settled = true;
  for (const Factor& factor : collector.factors()) {
    if (factor.exponent == 0) continue;
    const NodeId node = power(factor.base, factor.exponent);
    settled = settled && base_of(node) == factor.base && can_be_factor((*this)[node]);
    factors.push_back(node);
  }
  if (!settled) {
    factors.push_back(constant(collector.coefficient()));
    return product(factors);
  }
  if (factors.empty()) return constant(collector.coefficient());
  if (factors.size() == 1) return scale(collector.coefficient(), factors[0]);
  std::sort(factors.begin(), factors.end(), [this](NodeId a, NodeId b) { return compare(a, b) < 0; });
  Node node;
  node.kind = Kind::product;
  node.children.assign(factors.begin(), factors.end());
  return scale(collector.coefficient(), intern(std::move(node)));
}

// Halves of the canonical order, so that the groups do not depend on the order of the factors either.
NodeId Graph::grouped(const std::vector<NodeId>& factors, const std::string& name) {
  if (factors.size() <= k_largest_group) return product(factors);
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  const NodeId left = grouped({factors.begin(), middle}, name);
  const NodeId right = grouped({middle, factors.end()}, name);
  return product({kept_whole(left, name), kept_whole(right, name)});
}

NodeId Graph::product_in_groups(const std::vector<NodeId>& factors, const std::string& name) {
  const NodeId whole = product(factors);
  const Node& node = (*this)[whole];
  const bool has_coefficient = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
  if (has_coefficient) return scale(node.coefficients[0], product_in_groups({node.children[0]}, name));
  return node.kind == Kind::product && node.children.size() > k_most_side_by_side ? grouped(listed(node.children), name)
                                                                                  : whole;
}

namespace {

Rational integer_power(const Rational& base, int exponent) {
  GAUSS_ASSERT(base != 0 || exponent > 0, "0^{}", exponent);
  const Rational size = cln::expt_pos(base, cln::cl_I(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1 / size) : size;
}

/// base^exponent where it is rational again, such as 4^(1/2).
std::optional<Rational> exact_power(const Rational& base, const Rational& exponent) {
  const int top = cln::cl_I_to_int(cln::numerator(exponent));
  if (support::is_integer(exponent)) return integer_power(base, top);
  Rational root = 0;
  if (base < 0 || !cln::rootp(base, cln::denominator(exponent), &root)) return std::nullopt;
  return integer_power(root, top);
}

}  // namespace

NodeId Graph::power(NodeId base, const Rational& exponent) {
  if (is_undefined(base)) return base;  // neither (1/0)^0 = 1 nor 1/(1/0) = 0
  if (exponent == 0) return constant(1);
  if (exponent == 1) return base;
  const Node& node = (*this)[base];
  const bool is_whole = support::is_integer(exponent);
  if (node.kind == Kind::constant) {
    // 0^-1 stays as it is: the value is not finite at run time, and status says so.
    const bool is_pole = node.value == 0 && exponent < 0;
    if (const auto exact = is_pole ? std::nullopt : exact_power(node.value, exponent)) return constant(*exact);
  }
  if (node.kind == Kind::power && (is_whole || support::is_integer(1 / node.value))) {
    return power(node.children[0], node.value * exponent);
  }
  // |x|^2 = x^2
  const bool is_size = node.kind == Kind::function && node.function == Function::abs;
  if (is_size && support::is_integer(exponent / 2)) return power(node.children[0], exponent);
  if (is_whole && node.kind == Kind::product) {
    std::vector<NodeId> factors;
    for (const NodeId child : node.children) factors.push_back(power(child, exponent));
    return product(factors);
  }
  if (is_whole && node.kind == Kind::sum) {
    const bool is_monomial = node.value == 0 && node.children.size() == 1;
    const Rational content = is_monomial ? node.coefficients[0] : signed_content(node);
    if (content != 1) {
      const NodeId primitive = scale(1 / content, base);
      return scale(integer_power(content, support::to_int(exponent)), power(primitive, exponent));
    }
  }
  Node result;
  result.kind = Kind::power;
  result.value = exponent;
  result.children = {base};
  return intern(std::move(result));
}

}  // namespace gaussgen::ir
