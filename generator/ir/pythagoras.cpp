#include "ir/pythagoras.hpp"

#include <algorithm>

namespace gaussgen::ir {

namespace {

/// One way to read a term as rest * f(x)^2 with f = sin or cos.
struct Square {
  NodeId rest;
  NodeId partner;  ///< rest * g(x)^2, g the other one of sin and cos
};

std::optional<Function> other(Function function) {
  if (function == Function::sin) return Function::cos;
  if (function == Function::cos) return Function::sin;
  return std::nullopt;
}

bool is_trigonometric_power(const Graph& graph, NodeId factor) {
  const Node& node = graph[factor];
  if (node.kind != Kind::power || node.value < 2 || !support::is_integer(node.value)) return false;
  const Node& base = graph[node.children[0]];
  return base.kind == Kind::function && other(base.function).has_value();
}

std::vector<Square> squares_in(Graph& graph, NodeId term) {
  std::vector<NodeId> factors{term};
  if (graph[term].kind == Kind::product) factors = listed(graph[term].children);
  std::vector<Square> squares;
  for (const NodeId factor : factors) {
    if (!is_trigonometric_power(graph, factor)) continue;
    const NodeId base = graph[factor].children[0];
    const NodeId partner_base = graph.call(*other(graph[base].function), listed(graph[base].children));
    const NodeId rest = graph.product({term, graph.power(base, -2)});
    squares.push_back({rest, graph.product({rest, graph.power(partner_base, 2)})});
  }
  return squares;
}

bool has_square(const Graph& graph, NodeId term) {
  const auto is_square = [&](NodeId factor) { return is_trigonometric_power(graph, factor); };
  const Node& node = graph[term];
  if (node.kind != Kind::product) return is_square(term);
  return std::any_of(node.children.begin(), node.children.end(), is_square);
}

class PairFinder {
 public:
  PairFinder(Graph& graph, const Rational& constant, const std::vector<Term>& terms)
      : graph_(graph), constant_(constant), terms_(terms) {
    for (std::size_t i = 0; i < terms.size(); ++i) position_[terms[i].node] = i;
  }

  std::optional<Replacement> find() {
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      for (const Square& square : squares_in(graph_, terms_[i].node)) {
        if (auto found = with_partner(i, square)) return found;
        if (auto found = with_rest(i, square)) return found;
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Replacement> with_partner(std::size_t i, const Square& square) const {
    const std::size_t* const partner = position_.find(square.partner);
    if (partner == nullptr || terms_[*partner].coefficient != terms_[i].coefficient) return std::nullopt;
    Replacement result{constant_, {}};
    copy_without(i, *partner, result);
    result.terms.push_back({terms_[i].coefficient, square.rest});
    return result;
  }

  std::optional<Replacement> with_rest(std::size_t i, const Square& square) const {
    const Rational wanted = -terms_[i].coefficient;
    Replacement result{constant_, {}};
    if (graph_.is_one(square.rest)) {
      if (constant_ != wanted) return std::nullopt;
      result.constant = 0;
      copy_without(i, i, result);
    } else {
      const std::size_t* const rest = position_.find(square.rest);
      if (rest == nullptr || terms_[*rest].coefficient != wanted) return std::nullopt;
      copy_without(i, *rest, result);
    }
    result.terms.push_back({wanted, square.partner});
    return result;
  }

  void copy_without(std::size_t i, std::size_t j, Replacement& result) const {
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      if (k != i && k != j) result.terms.push_back(terms_[k]);
    }
  }

  Graph& graph_;
  const Rational& constant_;
  const std::vector<Term>& terms_;
  NodeTable<std::size_t> position_;
};

}  // namespace

std::optional<Replacement> find_pythagorean_pair(Graph& graph, const Rational& constant,
                                                 const std::vector<Term>& terms) {
  if (terms.size() + (constant == 0 ? 0U : 1U) < 2) return std::nullopt;
  // Most sums have none, and need no table of their terms.
  const auto holds_square = [&](const Term& term) { return has_square(graph, term.node); };
  if (std::none_of(terms.begin(), terms.end(), holds_square)) return std::nullopt;
  return PairFinder(graph, constant, terms).find();
}

}  // namespace gaussgen::ir
