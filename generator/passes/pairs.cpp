#include "passes/pairs.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

/// Numbers what factors and terms stand for: nodes of the graph, then pairs as they are found.
using Atom = std::uint32_t;
using Pair = std::pair<Atom, Atom>;

/// Finds the pair that occurs in most lists, again and again.
class Pairing {
 public:
  using List = std::vector<Atom>;  ///< sorted, with repetitions

  explicit Pairing(std::vector<List> lists, Atom first_free) : lists_(std::move(lists)), next_(first_free) {
    for (std::size_t i = 0; i < lists_.size(); ++i) {
      for (const Pair& pair : pairs_in(lists_[i])) enter(pair, i);
    }
  }

  void run() {
    while (!queue_.empty()) take(queue_.begin()->second);
  }

  const List& list(std::size_t i) const { return lists_[i]; }

  /// In the order in which they were found: later ones may have earlier ones in them.
  const std::vector<std::pair<Pair, Atom>>& found() const { return found_; }

 private:
  static std::set<Pair> pairs_in(const List& list) {
    std::set<Pair> pairs;
    for (std::size_t a = 0; a < list.size(); ++a) {
      for (std::size_t b = a + 1; b < list.size(); ++b) pairs.insert({list[a], list[b]});
    }
    return pairs;
  }

  static int key(std::size_t count) { return -static_cast<int>(count); }

  void enter(const Pair& pair, std::size_t list) {
    std::set<std::size_t>& users = users_[pair];
    if (users.count(list) != 0) return;
    if (users.size() > 1) queue_.erase({key(users.size()), pair});
    users.insert(list);
    if (users.size() > 1) queue_.insert({key(users.size()), pair});
  }

  void leave(const Pair& pair, std::size_t list) {
    std::set<std::size_t>& users = users_[pair];
    if (users.count(list) == 0) return;
    if (users.size() > 1) queue_.erase({key(users.size()), pair});
    users.erase(list);
    if (users.size() > 1) queue_.insert({key(users.size()), pair});
  }

  void take(const Pair pair) {
    const Atom own = next_++;
    found_.push_back({pair, own});
    const std::set<std::size_t> users = users_[pair];
    for (const std::size_t i : users) {
      for (const Pair& old : pairs_in(lists_[i])) leave(old, i);
      List& list = lists_[i];
      list.erase(std::find(list.begin(), list.end(), pair.first));
      list.erase(std::find(list.begin(), list.end(), pair.second));
      list.push_back(own);
      for (const Pair& now : pairs_in(list)) enter(now, i);
    }
  }

  std::vector<List> lists_;
  Atom next_;
  std::map<Pair, std::set<std::size_t>> users_;
  std::set<std::pair<int, Pair>> queue_;  ///< of those with two users or more, most first
  std::vector<std::pair<Pair, Atom>> found_;
};

/// x, 1/x and numbers are different factors; numbered as they come up, so that nothing depends on node numbers.
class FactorNames {
 public:
  Atom of(NodeId base, bool is_inverse) {
    const auto [place, is_new] = atoms_.emplace(std::pair{base.index, is_inverse}, nodes_.size());
    if (is_new) nodes_.push_back({base, is_inverse ? -1 : 1});
    return static_cast<Atom>(place->second);
  }

  std::size_t size() const { return nodes_.size(); }
  const Factor& operator[](Atom atom) const { return nodes_[atom]; }

 private:
  std::map<std::pair<std::uint32_t, bool>, std::size_t> atoms_;
  std::vector<Factor> nodes_;
};

class FactorSharing {
 public:
  FactorSharing(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {
    for (const NodeId id : order_) {
      for (const NodeId child : graph[id].children) ++uses_[child];
    }
    for (const NodeId id : request.outputs) ++uses_[id];
    for (const Section& section : request.sections) {
      for (const auto& [node, name] : section.nodes) ++uses_[node];
    }
  }

  Request run(const Request& request) {
    std::vector<Pairing::List> lists;
    for (const NodeId id : order_) {
      if (graph_[id].kind == Kind::sum) {
        add_multiples(id, lists);
      } else {
        add(factors_in(id), lists, place_, id.index);
      }
    }
    Pairing pairing(std::move(lists), static_cast<Atom>(names_.size()));
    pairing.run();
    for (const auto& [pair, own] : pairing.found()) pairs_.emplace(own, pair);
    for (const NodeId id : order_) rewrite_.replace(id, rewritten(id, pairing));
    return rewrite_(request);
  }

 private:
  using TermId = std::pair<std::uint32_t, std::size_t>;  ///< of a sum, and which of its terms

  template <class Place, class Key>
  static void add(Pairing::List list, std::vector<Pairing::List>& lists, Place& place, Key key) {
    if (list.size() < 2) return;
    std::sort(list.begin(), list.end());
    place.insert_or_assign(key, lists.size());
    lists.push_back(std::move(list));
  }

  // 2/3 x and 2/3 x y: the number is a factor too. It joins those of a product that nothing else needs.
  void add_multiples(NodeId sum, std::vector<Pairing::List>& lists) {
    const Node& node = graph_[sum];
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const NodeId child = node.children[i];
      if (cln::abs(node.coefficients[i]) == 1 || is_quotient(child)) continue;
      const Atom number = names_.of(graph_.constant(cln::abs(node.coefficients[i])), false);
      const auto product = place_.find(child.index);
      const bool is_private = *uses_.find(child) == 1 && graph_.label(child).empty();
      if (product == place_.end() || !is_private) {
        add({number, names_.of(child, false)}, lists, multiples_, TermId{sum.index, i});
      } else {
        Pairing::List& list = lists[product->second];
        list.insert(std::lower_bound(list.begin(), list.end(), number), number);
        multiples_.emplace(TermId{sum.index, i}, product->second);
      }
    }
  }

  // The number is its numerator, at no cost.
  bool is_quotient(NodeId id) const {
    const std::vector<Factor> factors = factors_of(graph_, id);
    return std::all_of(factors.begin(), factors.end(), [](const Factor& factor) { return factor.exponent < 0; });
  }

  Pairing::List factors_in(NodeId id) {
    const Node& node = graph_[id];
    if (node.kind != Kind::product && node.kind != Kind::power) return {};
    Pairing::List list;
    for (const auto& [base, exponent] : factors_of(graph_, id)) {
      const Atom atom = names_.of(base, exponent < 0);
      for (int i = 0; i < std::abs(exponent); ++i) list.push_back(atom);
    }
    return list;
  }

  NodeId rewritten(NodeId id, const Pairing& pairing) {
    if (graph_[id].kind == Kind::sum) return sum_of(id, pairing);
    const auto place = place_.find(id.index);
    return place == place_.end() ? rewrite_.rebuilt(id) : product_of(pairing.list(place->second));
  }

  NodeId sum_of(NodeId id, const Pairing& pairing) {
    const Node node = graph_[id];
    std::vector<Term> terms;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const auto place = multiples_.find({id.index, i});
      const bool is_taken = place != multiples_.end() && !has_number(pairing.list(place->second));
      const Rational sign = node.coefficients[i] < 0 ? -1 : 1;
      if (is_taken) {
        terms.push_back({sign, product_of(pairing.list(place->second))});
      } else {
        terms.push_back({node.coefficients[i], rewrite_(node.children[i])});
      }
    }
    return graph_.linear(node.value, terms);
  }

  bool has_number(const Pairing::List& list) const {
    return std::any_of(list.begin(), list.end(), [this](Atom atom) { return is_number(atom); });
  }

  bool is_number(Atom atom) const { return atom < names_.size() && graph_[names_[atom].base].kind == Kind::constant; }

  // A number that no pair has taken stays with the sum that it was found in.
  NodeId product_of(const Pairing::List& list) {
    std::vector<NodeId> factors;
    for (const Atom atom : list) {
      if (!is_number(atom)) factors.push_back(value(atom));
    }
    return factors.size() == 1 ? factors[0] : graph_.product(factors);
  }

  // Operands of a pair are operands of the products that it is in, and so they are known.
  NodeId value(Atom atom) {
    const auto known = values_.find(atom);
    if (known != values_.end()) return known->second;
    NodeId result{};
    if (atom < names_.size()) {
      const Factor& factor = names_[atom];
      result = is_number(atom) ? factor.base : graph_.power(rewrite_(factor.base), factor.exponent);
    } else {
      const Pair& pair = pairs_.at(atom);
      const NodeId first = value(pair.first);
      const NodeId second = value(pair.second);
      result = closed(graph_, graph_.product({first, second}));
    }
    values_.emplace(atom, result);
    return result;
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  FactorNames names_;
  ir::NodeTable<int> uses_;
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< of products among the lists
  std::map<TermId, std::size_t> multiples_;               ///< of terms with a number among the lists
  std::map<Atom, Pair> pairs_;
  std::map<Atom, NodeId> values_;
};

}  // namespace

Request share_factors(Graph& graph, const Request& request) { return FactorSharing(graph, request).run(request); }

}  // namespace gaussgen::passes
