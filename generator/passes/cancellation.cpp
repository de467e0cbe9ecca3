#include "passes/cancellation.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "ir/expr.hpp"
#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Expr;
using ir::Function;
using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

constexpr const char* k_cosines = "cosines";
constexpr const char* k_exponentials = "exponentials";
constexpr const char* k_logarithms = "logarithms";
constexpr const char* k_roots = "roots";
constexpr const char* k_squares = "squares";
constexpr const char* k_angles = "angles";

/// Longer sums are what a solution makes of many values, and no small difference of two.
constexpr std::size_t k_most_terms = 48;

/// With the number in it as a multiple of 1.
std::vector<Term> terms_of(Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind != Kind::sum) return {{1, id}};
  std::vector<Term> terms;
  for (std::size_t i = 0; i < node.children.size(); ++i) terms.push_back({node.coefficients[i], node.children[i]});
  if (node.value != 0) terms.push_back({node.value, graph.constant(1)});
  return terms;
}

std::vector<NodeId> factors(const Graph& graph, NodeId term) {
  return graph[term].kind == Kind::product ? listed(graph[term].children) : std::vector<NodeId>{term};
}

bool is_call(const Graph& graph, NodeId id, Function function) {
  return graph[id].kind == Kind::function && graph[id].function == function;
}

/// The root of what is a square wherever it has a value.
std::optional<Expr> root_of_square(Graph& graph, const Term& term) {
  Rational coefficient = 0;
  if (term.coefficient < 0 || !cln::sqrtp(term.coefficient, &coefficient)) return std::nullopt;
  std::vector<NodeId> roots{graph.constant(coefficient)};
  for (const NodeId factor : factors(graph, term.node)) {
    if (graph.is_one(factor)) continue;
    const Node& node = graph[factor];
    if (node.kind != Kind::power || !support::is_integer(node.value / 2)) return std::nullopt;
    roots.push_back(graph.power(node.children[0], node.value / 2));
  }
  return Expr(graph, graph.product(roots));
}

/// Two terms of a sum, and what they are together.
struct Pair {
  std::size_t first, second;
  NodeId together;
};

/// The rules, each for two terms of a sum.
class Rules {
 public:
  Rules(Graph& graph, const std::vector<std::string>& as_written) : graph_(graph), as_written_(as_written) {}

  /// Of the term at `first` and a later or earlier one that may cancel it, what their sum is in a form that does not.
  std::optional<Pair> of_pair(const std::vector<Term>& terms, std::size_t first) {
    for (const NodeId factor : factors(graph_, terms[first].node)) {
      if (!may_be_near_another(factor)) continue;
      const Expr rest = Expr(graph_, terms[first].node) / Expr(graph_, factor);
      for (std::size_t second = 0; second < terms.size(); ++second) {
        if (second == first) continue;
        const auto together = of_factor(factor, rest, terms[first], terms[second], terms.size() == 2);
        if (together) return Pair{first, second, (terms[first].coefficient * rest * *together).id()};
      }
    }
    return std::nullopt;
  }

  /// a² - b² = (a - b)(a + b): a and b are rounded no more than they are, their squares would be.
  std::optional<Expr> of_squares(const std::vector<Term>& terms) {
    if (!has(k_squares) || terms.size() != 2 || cln::signum(terms[0].coefficient) == cln::signum(terms[1].coefficient))
      return std::nullopt;
    const bool is_first = terms[0].coefficient > 0;
    const Term& above = terms[is_first ? 0 : 1];
    const Term& below = terms[is_first ? 1 : 0];
    const auto a = root_of_square(graph_, above);
    const auto b = root_of_square(graph_, {-below.coefficient, below.node});
    if (!a || !b) return std::nullopt;
    return (*a - *b) * (*a + *b);
  }

  /// log(1 + x) by the number that 1 + x is rounded to: log(y)/(y - 1) changes little from there to 1 + x (W. Kahan).
  std::optional<Expr> of_logarithm(NodeId id) {
    if (!has(k_logarithms) || !is_call(graph_, id, Function::log)) return std::nullopt;
    const NodeId argument = graph_[id].children[0];
    if (graph_[argument].kind != Kind::sum || graph_[argument].value != 1) return std::nullopt;
    const Expr x = Expr(graph_, argument) - one();
    const Expr y = Expr(graph_, argument).kept_whole("");
    const Expr step = y - one();
    const Expr is_one = at_most(call(Function::abs, step), 0 * one());
    return select(is_one, x, x * (call(Function::log, y) / step));
  }

  /// What is before several cosines together, in parts: 2 L - L cos x - L cos y as L - L cos x + L - L cos y, the height of two rods.
  std::vector<Term> in_shares(std::vector<Term> terms) {
    if (!has(k_cosines)) return terms;
    for (std::size_t whole = 0; whole < terms.size(); ++whole) {
      const std::vector<Rational> shares = shares_of(terms, terms[whole]);
      if (shares.size() < 2) continue;
      terms[whole].coefficient = shares[0];
      for (std::size_t k = 1; k < shares.size(); ++k) terms.push_back({shares[k], terms[whole].node});
    }
    return terms;
  }

  /// (1 - cos x)(1 + cos x), by which power of them: sin² x has one call instead of two.
  std::optional<NodeId> sine_of(NodeId less, NodeId more) {
    const std::vector<Term> a = terms_of(graph_, less), b = terms_of(graph_, more);
    const bool fits = a.size() == 2 && b.size() == 2 && graph_.is_one(a[1].node) && graph_.is_one(b[1].node) &&
                      a[0].node == b[0].node && is_call(graph_, a[0].node, Function::cos) && a[0].coefficient == -1 &&
                      a[1].coefficient == 1 && b[0].coefficient == 1 && b[1].coefficient == 1;
    if (!fits || !has(k_cosines)) return std::nullopt;
    return graph_.call(Function::sin, {graph_[a[0].node].children[0]});
  }

 private:
  /// Sizes of the coefficients of all cosines that `whole` is before, with its sign, if they are of one sign and as large as it together.
  std::vector<Rational> shares_of(const std::vector<Term>& terms, const Term& whole) {
    std::vector<Rational> shares;
    Rational sum = 0;
    int sign = 0;
    for (const Term& term : terms) {
      if (!is_before_cosine(whole.node, term.node)) continue;
      if (sign == (cln::plusp(term.coefficient) ? -1 : 1)) return {};
      sign = cln::plusp(term.coefficient) ? 1 : -1;
      shares.push_back(cln::signum(whole.coefficient) * cln::abs(term.coefficient));
      sum = sum + shares.back();
    }
    return sum == whole.coefficient ? shares : std::vector<Rational>{};
  }

  bool is_before_cosine(NodeId rest, NodeId term) {
    const std::vector<NodeId> all = factors(graph_, term);
    return std::any_of(all.begin(), all.end(), [&](NodeId factor) {
      return is_call(graph_, factor, Function::cos) && (Expr(graph_, term) / Expr(graph_, factor)).id() == rest;
    });
  }

  Expr one() { return {graph_, graph_.constant(1)}; }

  bool has(const char* rule) const {
    return std::find(as_written_.begin(), as_written_.end(), rule) == as_written_.end();
  }

  bool may_be_near_another(NodeId factor) const {
    const Node& node = graph_[factor];
    if (node.kind == Kind::power) return node.value == Rational(1) / 2;
    constexpr Function k_functions[] = {Function::cos, Function::sin, Function::cosh, Function::exp};
    return node.kind == Kind::function &&
           std::find(std::begin(k_functions), std::end(k_functions), node.function) != std::end(k_functions);
  }

  /// (factor rest c + second) / (rest c), c the number before the first.
  std::optional<Expr> of_factor(NodeId factor, Expr rest, const Term& first, const Term& second, bool is_whole_sum) {
    const bool is_alike = second.node == rest.id() && cln::abs(second.coefficient) == cln::abs(first.coefficient);
    if (is_alike) {
      if (const auto found = with_one(factor, second.coefficient == first.coefficient)) return found;
    }
    if (const auto found = root_less(factor, rest, first, second)) return found;
    return is_whole_sum && has(k_angles) ? of_angles(factor, rest, first, second) : std::nullopt;
  }

  /// f(x) - 1, or f(x) + 1.
  std::optional<Expr> with_one(NodeId f, bool adds) {
    if (graph_[f].kind != Kind::function || graph_[f].children.size() != 1) return std::nullopt;
    const Function function = graph_[f].function;
    const Expr x(graph_, graph_[f].children[0]);
    const Expr half = Rational(1) / 2 * x;
    if (function == Function::cos && has(k_cosines)) {
      return adds ? 2 * pow(call(Function::cos, half), 2) : -2 * pow(call(Function::sin, half), 2);
    }
    if (adds || !has(k_exponentials)) return std::nullopt;
    if (function == Function::cosh) return hyperbolic_less_one(f, x, half);
    if (function == Function::exp) return exponential_less_one(f, x);
    return std::nullopt;
  }

  // A square doubles the error of its root; where cosh x is large, 1 takes nothing from it.
  Expr hyperbolic_less_one(NodeId cosh, Expr x, Expr half) {
    const Expr is_small = less(pow(x, 2), 4 * one());
    return select(is_small, 2 * pow(call(Function::sinh, half), 2), Expr(graph_, cosh).kept_whole("") - one());
  }

  /// By the number y that e^x is rounded to: (y - 1)/log(y) changes little from e^x to y (W. Kahan). Beyond a factor of 2 by y - 1 itself, since
  /// log(y) may have no value there.
  Expr exponential_less_one(NodeId exp, Expr x) {
    const Expr y = Expr(graph_, exp).kept_whole("");
    const Expr step = y - one();
    const Expr size = call(Function::abs, step);
    const Expr near = select(at_most(size, 0 * one()), x, step * (x / call(Function::log, y)));
    return select(less(size, one()), near, step);
  }

  /// √A - b with b² among the terms of A: (A - b²)/(√A + |b|) + (|b| - b), since the sign of b need not be known.
  std::optional<Expr> root_less(NodeId root, Expr rest, const Term& with_root, const Term& other) {
    const Node& node = graph_[root];
    if (!has(k_roots) || node.kind != Kind::power || node.value != Rational(1) / 2) return std::nullopt;
    const Expr A(graph_, node.children[0]);
    const Expr b = -(other.coefficient / with_root.coefficient) * (Expr(graph_, other.node) / rest);
    if (graph_[A.id()].kind != Kind::sum || is_negative(b)) return std::nullopt;
    const Expr squared = pow(b, 2);
    const std::vector<Term> terms = terms_of(graph_, A.id());
    const auto is_square = [&](const Term& term) { return graph_.scale(term.coefficient, term.node) == squared.id(); };
    if (std::none_of(terms.begin(), terms.end(), is_square)) return std::nullopt;
    const Expr size = call(Function::abs, b);
    const Expr sum = Expr(graph_, root) + size;
    const Expr zero = 0 * one();
    return select(at_most(sum, zero), zero, (A - squared) / sum) + (size - b).kept_whole("");
  }

  /// Known to be below 0: numbers, and what this pass has left.
  bool is_negative(Expr value) {
    const Node& node = graph_[value.id()];
    if (node.kind == Kind::constant) return node.value < 0;
    return node.kind == Kind::sum && node.value == 0 && node.children.size() == 1 && node.coefficients[0] < 0 &&
           is_call(graph_, node.children[0], Function::abs);
  }

  /// cos a - cos b, sin a ∓ sin b, where a and b share all but a fixed part. Of two angles that differ by a third one nobody knows that this is
  /// small.
  std::optional<Expr> of_angles(NodeId f, Expr rest, const Term& first, const Term& second) {
    if (!is_call(graph_, f, Function::cos) && !is_call(graph_, f, Function::sin)) return std::nullopt;
    const Function function = graph_[f].function;
    const auto g = partner(function, rest, second.node);
    if (!g || cln::abs(first.coefficient) != cln::abs(second.coefficient)) return std::nullopt;
    const bool adds = first.coefficient == second.coefficient;
    const Expr a(graph_, graph_[f].children[0]), b(graph_, graph_[*g].children[0]);
    const Expr middle = Rational(1) / 2 * (a + b), half = Rational(1) / 2 * (a - b);
    const bool is_near = !graph_.varies(half.id()), is_mirrored = !graph_.varies(middle.id());
    if (function == Function::cos) {
      if (adds || !(is_near || is_mirrored)) return std::nullopt;
      return -2 * call(Function::sin, middle) * call(Function::sin, half);
    }
    if (!adds && is_near) return 2 * call(Function::cos, middle) * call(Function::sin, half);
    if (adds && is_mirrored) return 2 * call(Function::sin, middle) * call(Function::cos, half);
    return std::nullopt;
  }

  std::optional<NodeId> partner(Function function, Expr rest, NodeId term) {
    for (const NodeId factor : factors(graph_, term)) {
      if (is_call(graph_, factor, function) && Expr(graph_, term) / Expr(graph_, factor) == rest) return factor;
    }
    return std::nullopt;
  }

  Graph& graph_;
  const std::vector<std::string>& as_written_;
};

class DigitKeeper {
 public:
  DigitKeeper(Graph& graph, const Request& request, const std::vector<std::string>& as_written)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph), rules_(graph, as_written) {}

  Request run(const Request& request) {
    for (const NodeId id : order_) rewrite_.replace(id, kept(id));
    return rewrite_(request);
  }

 private:
  NodeId kept(NodeId id) {
    if (graph_[id].kind == Kind::product) return of_product(id);
    const NodeId rebuilt = rewrite_.rebuilt(id);
    if (graph_[rebuilt].kind == Kind::sum) return of_sum(rebuilt);
    const auto logarithm = rules_.of_logarithm(rebuilt);
    return logarithm ? logarithm->id() : rebuilt;
  }

  // Only where all terms are in pairs: what is left over would be rounded to its own size, and pairs beside it, such as the sides of a linkage,
  // would cost calls for nothing.
  NodeId of_sum(NodeId id) {
    std::vector<Term> terms = terms_of(graph_, id);
    if (terms.size() < 2 || terms.size() > k_most_terms) return id;
    if (const auto factored = rules_.of_squares(terms)) return factored->id();
    terms = rules_.in_shares(std::move(terms));
    std::vector<Term> done;
    while (const auto pair = first_pair(terms)) {
      done.push_back({1, pair->together});
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(std::max(pair->first, pair->second)));
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(std::min(pair->first, pair->second)));
    }
    return terms.empty() ? graph_.linear(0, done) : id;
  }

  std::optional<Pair> first_pair(const std::vector<Term>& terms) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (const auto pair = rules_.of_pair(terms, i)) return pair;
    }
    return std::nullopt;
  }

  NodeId of_product(NodeId id) {
    const std::vector<NodeId> old = listed(graph_[id].children);
    std::vector<NodeId> now;
    std::vector<bool> is_taken(old.size(), false);
    for (std::size_t i = 0; i < old.size(); ++i) {
      for (std::size_t j = 0; j < old.size(); ++j) {
        if (i == j || is_taken[i] || is_taken[j]) continue;
        const auto sine = rules_.sine_of(old[i], old[j]);
        if (!sine) continue;
        now.push_back(graph_.power(*sine, 2));
        is_taken[i] = is_taken[j] = true;
      }
    }
    if (now.empty()) return rewrite_.rebuilt(id);
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (!is_taken[i]) now.push_back(rewrite_(old[i]));
    }
    return graph_.product(now);
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  Rules rules_;
};

}  // namespace

Request keep_digits(Graph& graph, const Request& request) { return keep_digits_except(graph, request, {}); }

Request keep_digits_except(Graph& graph, const Request& request, const std::vector<std::string>& as_written) {
  return DigitKeeper(graph, request, as_written).run(request);
}

const std::vector<std::string>& digit_rules() {
  static const std::vector<std::string> k_rules{k_cosines, k_exponentials, k_logarithms, k_roots, k_squares, k_angles};
  return k_rules;
}

const std::vector<std::string>& digit_rules_by_cases() {
  static const std::vector<std::string> k_rules{k_exponentials, k_logarithms, k_roots};
  return k_rules;
}

}  // namespace gaussgen::passes
