// Sums: flattening, like terms, sin² + cos² = 1, canonical order.

#include <algorithm>
#include <optional>

#include "ir/graph.hpp"
#include "ir/positions.hpp"
#include "ir/pythagoras.hpp"

namespace gaussgen::ir {

namespace {

/// Merges like terms while it flattens nested sums.
class TermCollector {
 public:
  explicit TermCollector(const Graph& graph) : graph_(graph) {}

  void add(const Rational& factor, NodeId id) {
    const Node& node = graph_[id];
    if (node.kind == Kind::constant) {
      constant_ = constant_ + factor * node.value;
    } else if (node.kind == Kind::sum) {
      constant_ = constant_ + factor * node.value;
      for (std::size_t i = 0; i < node.children.size(); ++i) add_term(factor * node.coefficients[i], node.children[i]);
    } else {
      add_term(factor, id);
    }
  }

  const Rational& constant() const { return constant_; }

  std::vector<Term> terms() const {
    std::vector<Term> kept;
    for (const Term& term : terms_) {
      if (term.coefficient != 0) kept.push_back(term);
    }
    return kept;
  }

 private:
  void add_term(const Rational& coefficient, NodeId node) {
    const auto [place, is_new] = positions_.emplace(node);
    if (is_new) {
      terms_.push_back({coefficient, node});
    } else {
      Rational& sum = terms_[place].coefficient;
      sum = sum + coefficient;
    }
  }

  const Graph& graph_;
  Rational constant_ = 0;
  std::vector<Term> terms_;
  Positions positions_;  ///< in terms_
};

}  // namespace

NodeId Graph::sum(const std::vector<NodeId>& nodes) {
  std::vector<Term> terms;
  terms.reserve(nodes.size());
  for (const NodeId node : nodes) {
    if (!is_zero(node)) terms.push_back({1, node});
  }
  if (terms.size() == 1) return terms[0].node;  // which is in its canonical form already
  return linear(0, terms);
}

NodeId Graph::linear(const Rational& constant, const std::vector<Term>& terms) {
  std::vector<NodeId> undefined;
  for (const Term& term : terms) {
    if (is_undefined(term.node)) undefined.push_back(term.node);
  }
  if (const auto first = first_undefined(undefined)) return *first;  // 1/0 - 1/0 is not 0
  TermCollector collector(*this);
  for (const Term& term : terms) collector.add(term.coefficient, term.node);
  Rational total = collector.constant() + constant;
  // In canonical order, so that the pair which is found does not depend on the order of the arguments.
  const auto sorted = [this](std::vector<Term> list) {
    std::sort(list.begin(), list.end(), [this](const Term& a, const Term& b) { return compare(a.node, b.node) < 0; });
    return list;
  };
  std::vector<Term> collected = sorted(collector.terms());
  // Each use of the identity leaves fewer products if everything were multiplied out, so this ends.
  while (const std::optional<Replacement> found = find_pythagorean_pair(*this, total, collected)) {
    TermCollector again(*this);
    again.add(1, this->constant(found->constant));
    for (const Term& term : found->terms) again.add(term.coefficient, term.node);
    total = again.constant();
    collected = sorted(again.terms());
  }
  return finish_sum(total, collected);
}

NodeId Graph::finish_sum(const Rational& constant_term, const std::vector<Term>& terms) {
  if (terms.empty()) return constant(constant_term);
  if (terms.size() == 1 && constant_term == 0 && terms[0].coefficient == 1) return terms[0].node;
  Node node;
  node.kind = Kind::sum;
  node.value = constant_term;
  for (const Term& term : terms) {
    node.children.push_back(term.node);
    node.coefficients.push_back(term.coefficient);
  }
  return intern(std::move(node));
}

NodeId Graph::scale(const Rational& factor, NodeId node) {
  if (factor == 1) return node;  // which is in its canonical form already: most sums in products are primitive
  return linear(0, {{factor, node}});
}

}  // namespace gaussgen::ir
