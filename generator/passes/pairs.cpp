#include "passes/pairs.hpp"

#include <algorithm>
#include <map>
#include <set>

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
    while (!queue_.empty()) {
      const auto [negative_count, pair] = *queue_.begin();
      if (negative_count > -2) break;
      take(pair);
    }
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
    if (!users.empty()) queue_.erase({key(users.size()), pair});
    users.insert(list);
    queue_.insert({key(users.size()), pair});
  }

  void leave(const Pair& pair, std::size_t list) {
    std::set<std::size_t>& users = users_[pair];
    if (users.count(list) == 0) return;
    queue_.erase({key(users.size()), pair});
    users.erase(list);
    if (!users.empty()) queue_.insert({key(users.size()), pair});
  }

  void take(const Pair& pair) {
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
  std::set<std::pair<int, Pair>> queue_;
  std::vector<std::pair<Pair, Atom>> found_;
};

/// x and 1/x are different factors; numbered as they come up, so that nothing depends on node numbers.
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
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {}

  Request run(const Request& request) {
    std::vector<Pairing::List> lists;
    for (const NodeId id : order_) {
      Pairing::List list = list_of(id);
      if (list.size() < 2) continue;
      place_.emplace(id.index, lists.size());
      lists.push_back(std::move(list));
    }
    Pairing pairing(std::move(lists), static_cast<Atom>(names_.size()));
    pairing.run();
    for (const auto& [pair, own] : pairing.found()) pairs_.emplace(own, pair);
    for (const NodeId id : order_) rewrite_.replace(id, rewritten(id, pairing));
    return rewrite_(request);
  }

 private:
  Pairing::List list_of(NodeId id) {
    const Node& node = graph_[id];
    if (node.kind != Kind::product && node.kind != Kind::power) return {};
    Pairing::List list;
    for (const auto& [base, exponent] : factors_of(graph_, id)) {
      const Atom atom = names_.of(base, exponent < 0);
      for (int i = 0; i < std::abs(exponent); ++i) list.push_back(atom);
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  NodeId rewritten(NodeId id, const Pairing& pairing) {
    const auto place = place_.find(id.index);
    if (place == place_.end()) return rewrite_.rebuilt(id);
    std::vector<NodeId> factors;
    for (const Atom atom : pairing.list(place->second)) factors.push_back(value(atom));
    return factors.size() == 1 ? factors[0] : graph_.product(factors);
  }

  // Operands of a pair are operands of the products that it is in, and so they are known.
  NodeId value(Atom atom) {
    const auto known = values_.find(atom);
    if (known != values_.end()) return known->second;
    NodeId result{};
    if (atom < names_.size()) {
      const Factor& factor = names_[atom];
      result = graph_.power(rewrite_(factor.base), factor.exponent);
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
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< of products among the lists
  std::map<Atom, Pair> pairs_;
  std::map<Atom, NodeId> values_;
};

}  // namespace

Request share_factors(Graph& graph, const Request& request) { return FactorSharing(graph, request).run(request); }

}  // namespace gaussgen::passes
