#include "passes/terms.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

/// Of longer sums, pairs are not counted: there are as many as the square of the terms.
constexpr std::size_t k_longest_sum = 48;

using Atom = std::uint32_t;

/// The term 1, for the number in a sum.
constexpr Atom k_one = 0;

struct Item {
  Atom atom;
  Rational coefficient;
};

/// first + ratio second, in any multiple.
struct PairOfTerms {
  Atom first;
  Atom second;
  std::uint32_t ratio;  ///< its number
  friend bool operator<(const PairOfTerms& a, const PairOfTerms& b) {
    return std::tie(a.first, a.second, a.ratio) < std::tie(b.first, b.second, b.ratio);
  }
};

int multiplications(const Rational& coefficient) { return cln::abs(coefficient) == 1 ? 0 : 1; }

/// Numbers ratios in the order in which they come up.
class Ratios {
 public:
  std::uint32_t of(const Rational& ratio) {
    const auto [place, is_new] = numbers_.emplace(ratio, ratios_.size());
    if (is_new) ratios_.push_back(ratio);
    return static_cast<std::uint32_t>(place->second);
  }
  const Rational& operator[](std::uint32_t number) const { return ratios_[number]; }

 private:
  struct Less {
    bool operator()(const Rational& a, const Rational& b) const { return a < b; }
  };
  std::map<Rational, std::size_t, Less> numbers_;
  std::vector<Rational> ratios_;
};

/// Finds the pair that saves most in all sums, again and again.
class TermPairing {
 public:
  using List = std::vector<Item>;  ///< no atom twice

  TermPairing(std::vector<List> lists, Atom first_free) : lists_(std::move(lists)), next_(first_free) {
    for (std::size_t i = 0; i < lists_.size(); ++i) enter_all(i);
  }

  void run() {
    while (!queue_.empty()) {
      const auto [negative_gain, pair] = *queue_.begin();
      if (negative_gain >= 0) break;
      take(pair);
    }
  }

  const List& list(std::size_t i) const { return lists_[i]; }
  const std::vector<std::pair<PairOfTerms, Atom>>& found() const { return found_; }
  const Rational& ratio(const PairOfTerms& pair) const { return ratios_[pair.ratio]; }

 private:
  struct Users {
    std::map<std::size_t, int> saved;  ///< by list
    int total = 0;
  };

  PairOfTerms pair_of(const Item& a, const Item& b) {
    const Item& first = a.atom < b.atom ? a : b;
    const Item& second = a.atom < b.atom ? b : a;
    return {first.atom, second.atom, ratios_.of(second.coefficient / first.coefficient)};
  }

  // An addition, and the factor of the second term: that of the first one stays with the pair.
  static int saved(const Item& a, const Item& b) { return 1 + multiplications((a.atom < b.atom ? b : a).coefficient); }

  int key(const PairOfTerms& pair, const Users& users) const {
    return users.saved.size() < 2 ? 0 : 1 + multiplications(ratio(pair)) - users.total;
  }

  void change(const PairOfTerms& pair, std::size_t list, int amount) {
    Users& users = users_[pair];
    if (!users.saved.empty()) queue_.erase({key(pair, users), pair});
    users.total += amount;
    if (amount > 0) {
      users.saved.emplace(list, amount);
    } else {
      users.saved.erase(list);
    }
    if (!users.saved.empty()) queue_.insert({key(pair, users), pair});
  }

  void enter_all(std::size_t i) {
    for_pairs(i, [&](const Item& a, const Item& b) { change(pair_of(a, b), i, saved(a, b)); });
  }

  void leave_all(std::size_t i) {
    for_pairs(i, [&](const Item& a, const Item& b) { change(pair_of(a, b), i, -saved(a, b)); });
  }

  template <class Action>
  void for_pairs(std::size_t i, Action action) {
    const List& list = lists_[i];
    for (std::size_t a = 0; a < list.size(); ++a) {
      for (std::size_t b = a + 1; b < list.size(); ++b) action(list[a], list[b]);
    }
  }

  void take(const PairOfTerms& pair) {
    const Atom own = next_++;
    found_.push_back({pair, own});
    const std::map<std::size_t, int> users = users_[pair].saved;
    for (const auto& [i, gain] : users) {
      leave_all(i);
      List& list = lists_[i];
      const auto is = [](Atom atom) { return [atom](const Item& item) { return item.atom == atom; }; };
      const Rational factor = std::find_if(list.begin(), list.end(), is(pair.first))->coefficient;
      list.erase(std::find_if(list.begin(), list.end(), is(pair.first)));
      list.erase(std::find_if(list.begin(), list.end(), is(pair.second)));
      list.push_back({own, factor});
      enter_all(i);
    }
  }

  std::vector<List> lists_;
  Atom next_;
  Ratios ratios_;
  std::map<PairOfTerms, Users> users_;
  std::set<std::pair<int, PairOfTerms>> queue_;
  std::vector<std::pair<PairOfTerms, Atom>> found_;
};

class TermSharing {
 public:
  TermSharing(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {}

  Request run(const Request& request) {
    std::vector<TermPairing::List> lists;
    for (const NodeId id : order_) {
      const Node& node = graph_[id];
      const bool is_short = node.children.size() < k_longest_sum;
      if (node.kind != Kind::sum || !is_short || node.children.size() + (node.value == 0 ? 0U : 1U) < 2) continue;
      place_.emplace(id.index, lists.size());
      lists.push_back(list_of(node));
    }
    TermPairing pairing(std::move(lists), static_cast<Atom>(nodes_.size() + 1));
    pairing.run();
    for (const auto& [pair, own] : pairing.found()) pairs_.emplace(own, pair);
    for (const NodeId id : order_) rewrite_.replace(id, rewritten(id, pairing));
    return rewrite_(request);
  }

 private:
  TermPairing::List list_of(const Node& sum) {
    TermPairing::List list;
    if (sum.value != 0) list.push_back({k_one, sum.value});
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      const auto [place, is_new] = atoms_.emplace(sum.children[i].index, nodes_.size() + 1);
      if (is_new) nodes_.push_back(sum.children[i]);
      list.push_back({place->second, sum.coefficients[i]});
    }
    return list;
  }

  NodeId rewritten(NodeId id, const TermPairing& pairing) {
    const auto place = place_.find(id.index);
    if (place == place_.end()) return rewrite_.rebuilt(id);
    const TermPairing::List& list = pairing.list(place->second);
    // Untouched ones keep the order of their terms.
    const bool has_pair =
        std::any_of(list.begin(), list.end(), [&](const Item& item) { return item.atom > nodes_.size(); });
    return has_pair ? sum_of(list, pairing) : rewrite_.rebuilt(id);
  }

  NodeId sum_of(const TermPairing::List& list, const TermPairing& pairing) {
    Rational number = 0;
    std::vector<Term> terms;
    for (const Item& item : list) {
      if (item.atom == k_one) {
        number = item.coefficient;
      } else {
        terms.push_back({item.coefficient, value(item.atom, pairing)});
      }
    }
    return graph_.linear(number, terms);
  }

  // Operands of a pair are operands of the sums that it is in, and so they are known.
  NodeId value(Atom atom, const TermPairing& pairing) {
    if (atom <= nodes_.size()) return rewrite_(nodes_[atom - 1]);
    const auto known = values_.find(atom);
    if (known != values_.end()) return known->second;
    const PairOfTerms& pair = pairs_.at(atom);
    const NodeId result = closed(graph_, sum_of({{pair.first, 1}, {pair.second, pairing.ratio(pair)}}, pairing));
    values_.emplace(atom, result);
    return result;
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  std::unordered_map<std::uint32_t, Atom> atoms_;
  std::vector<NodeId> nodes_;                             ///< of the atoms from 1 on
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< of sums among the lists
  std::map<Atom, PairOfTerms> pairs_;
  std::map<Atom, NodeId> values_;
};

}  // namespace

Request share_terms(Graph& graph, const Request& request) { return TermSharing(graph, request).run(request); }

}  // namespace gaussgen::passes
