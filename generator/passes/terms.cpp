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

/// Numbers coefficients and ratios of them in the order in which they come up, and remembers what it once has divided.
class Numbers {
 public:
  using Id = std::uint32_t;

  Id of(const Rational& value) {
    const auto [place, is_new] = ids_.emplace(value, values_.size());
    if (is_new) values_.push_back(value);
    return static_cast<Id>(place->second);
  }

  const Rational& operator[](Id id) const { return values_[id]; }
  int multiplications(Id id) const { return cln::abs(values_[id]) == 1 ? 0 : 1; }

  struct Quotient {
    Id value = 0;
    bool is_exact = false;  ///< a binary fraction
  };

  const Quotient& quotient(Id above, Id below) {
    const auto [place, is_new] = quotients_.emplace(std::uint64_t{above} << 32U | below, Quotient{});
    if (is_new) {
      const Rational value = values_[above] / values_[below];
      place->second = {of(value), is_binary(value)};
    }
    return place->second;
  }

 private:
  struct Less {
    bool operator()(const Rational& a, const Rational& b) const { return a < b; }
  };
  std::map<Rational, std::size_t, Less> ids_;
  std::vector<Rational> values_;
  std::unordered_map<std::uint64_t, Quotient> quotients_;
};

struct Item {
  Atom atom;
  Numbers::Id coefficient;
};

/// first + ratio second, in any multiple. The ratio is a binary fraction if it can be: 3 x + y are so many times y + 3 x, and not
/// x + y/3, whose number is rounded.
struct PairOfTerms {
  Atom first;
  Atom second;
  Numbers::Id ratio;
  friend bool operator<(const PairOfTerms& a, const PairOfTerms& b) {
    return std::tie(a.first, a.second, a.ratio) < std::tie(b.first, b.second, b.ratio);
  }
};

/// Finds the pair that saves most in all sums, again and again.
class TermPairing {
 public:
  using List = std::vector<Item>;  ///< no atom twice

  TermPairing(std::vector<List> lists, Atom first_free, Numbers& numbers)
      : lists_(std::move(lists)), next_(first_free), numbers_(numbers) {
    for (std::size_t i = 0; i < lists_.size(); ++i) {
      for (std::size_t last = 1; last < lists_[i].size(); ++last) {
        for (std::size_t other = 0; other < last; ++other) enter(i, lists_[i][other], lists_[i][last]);
      }
    }
  }

  void run() {
    while (!queue_.empty()) take(queue_.begin()->second);
  }

  const List& list(std::size_t i) const { return lists_[i]; }
  const std::vector<std::pair<PairOfTerms, Atom>>& found() const { return found_; }

 private:
  struct Users {
    std::map<std::size_t, int> saved;  ///< by list
    int total = 0;
  };

  void enter(std::size_t list, const Item& a, const Item& b) { count(list, a, b, 1); }
  void leave(std::size_t list, const Item& a, const Item& b) { count(list, a, b, -1); }

  // An addition, and the factor of the second term: that of the first one stays with the pair.
  void count(std::size_t list, const Item& a, const Item& b, int sign) {
    const bool is_in_order = leads(a, b);
    const Item& first = is_in_order ? a : b;
    const Item& second = is_in_order ? b : a;
    const Numbers::Quotient& ratio = numbers_.quotient(second.coefficient, first.coefficient);
    // No number is rounded that was not.
    if (!ratio.is_exact && is_binary(numbers_[second.coefficient])) return;
    change({first.atom, second.atom, ratio.value}, list, sign * (1 + numbers_.multiplications(second.coefficient)));
  }

  bool leads(const Item& a, const Item& b) {
    const bool is_exact = numbers_.quotient(b.coefficient, a.coefficient).is_exact;
    const bool is_exact_the_other_way = numbers_.quotient(a.coefficient, b.coefficient).is_exact;
    return is_exact == is_exact_the_other_way ? a.atom < b.atom : is_exact;
  }

  int gain(const PairOfTerms& pair, const Users& users) const {
    return users.saved.size() < 2 ? 0 : users.total - 1 - numbers_.multiplications(pair.ratio);
  }

  void change(const PairOfTerms& pair, std::size_t list, int amount) {
    Users& users = users_[pair];
    if (const int old = gain(pair, users); old > 0) queue_.erase({-old, pair});
    users.total += amount;
    if (amount > 0) {
      users.saved.emplace(list, amount);
    } else {
      users.saved.erase(list);
    }
    if (const int now = gain(pair, users); now > 0) queue_.insert({-now, pair});
  }

  void take(const PairOfTerms pair) {
    const Atom own = next_++;
    found_.push_back({pair, own});
    const std::map<std::size_t, int> users = users_[pair].saved;
    for (const auto& [i, saved] : users) {
      const Item first = removed(pair.first, i);
      removed(pair.second, i);
      const Item now{own, first.coefficient};
      for (const Item& other : lists_[i]) enter(i, other, now);
      lists_[i].push_back(now);
    }
  }

  Item removed(Atom atom, std::size_t i) {
    List& list = lists_[i];
    const auto place = std::find_if(list.begin(), list.end(), [&](const Item& item) { return item.atom == atom; });
    const Item item = *place;
    list.erase(place);
    for (const Item& other : list) leave(i, item, other);
    return item;
  }

  std::vector<List> lists_;
  Atom next_;
  Numbers& numbers_;
  std::map<PairOfTerms, Users> users_;
  std::set<std::pair<int, PairOfTerms>> queue_;  ///< the largest gain first
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
    TermPairing pairing(std::move(lists), static_cast<Atom>(nodes_.size() + 1), numbers_);
    pairing.run();
    for (const auto& [pair, own] : pairing.found()) pairs_.emplace(own, pair);
    for (const NodeId id : order_) rewrite_.replace(id, rewritten(id, pairing));
    return rewrite_(request);
  }

 private:
  TermPairing::List list_of(const Node& sum) {
    TermPairing::List list;
    if (sum.value != 0) list.push_back({k_one, numbers_.of(sum.value)});
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      const auto [place, is_new] = atoms_.emplace(sum.children[i].index, nodes_.size() + 1);
      if (is_new) nodes_.push_back(sum.children[i]);
      list.push_back({place->second, numbers_.of(sum.coefficients[i])});
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
        number = numbers_[item.coefficient];
      } else {
        terms.push_back({numbers_[item.coefficient], value(item.atom, pairing)});
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
    const NodeId result = closed(graph_, sum_of({{pair.first, numbers_.of(1)}, {pair.second, pair.ratio}}, pairing));
    values_.emplace(atom, result);
    return result;
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  Numbers numbers_;
  std::unordered_map<std::uint32_t, Atom> atoms_;
  std::vector<NodeId> nodes_;                             ///< of the atoms from 1 on
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< of sums among the lists
  std::map<Atom, PairOfTerms> pairs_;
  std::map<Atom, NodeId> values_;
};

}  // namespace

Request share_terms(Graph& graph, const Request& request) { return TermSharing(graph, request).run(request); }

}  // namespace gaussgen::passes
