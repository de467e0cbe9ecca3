#include "passes/calls.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::Rational;

namespace {

struct Pair {
  NodeId sine, cosine;
};

bool is_circular(const Node& node) {
  return node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos);
}

/// Of coordinates themselves: nothing in it is rewritten.
bool is_sum_of_symbols(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  return node.kind == Kind::sum && node.children.size() > 1 &&
         std::all_of(node.children.begin(), node.children.end(),
                     [&](NodeId child) { return graph[child].kind == Kind::symbol; });
}

constexpr std::size_t k_most_named_terms = 3;

/// a_plus_b_minus_c, or nothing where that would be long.
std::string name_of_sum(const Graph& graph, const Node& sum) {
  if (sum.value != 0 || sum.children.size() > k_most_named_terms) return {};
  std::string name;
  for (const int sign : {1, -1}) {
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      if (cln::abs(sum.coefficients[i]) != 1) return {};
      if (sum.coefficients[i] != sign) continue;
      if (name.empty() && sign < 0) return {};
      if (!name.empty()) name += sign > 0 ? "_plus_" : "_minus_";
      name += graph.symbol(graph[sum.children[i]].symbol).name;
    }
  }
  return name;
}

class Splitter {
 public:
  Splitter(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {
    for (const NodeId id : order_) {
      if (is_circular(graph_[id])) now_.emplace(id.index, id);
    }
  }

  Request run(const Request& request) {
    // Shorter sums first: they are parts of longer ones.
    for (const NodeId angle : sums()) {
      if (const std::optional<Pair> pair = from_parts(angle)) put(angle, *pair);
    }
    for (const NodeId id : order_) {
      const auto found = now_.find(id.index);
      rewrite_.replace(id, found == now_.end() ? rewrite_.rebuilt(id) : found->second);
    }
    return rewrite_(request);
  }

 private:
  std::vector<NodeId> sums() const {
    std::vector<NodeId> found;
    ir::NodeSet seen;
    for (const NodeId id : order_) {
      if (!is_circular(graph_[id])) continue;
      const NodeId angle = graph_[id].children[0];
      if (!is_sum_of_symbols(graph_, angle) || seen.contains(angle)) continue;
      seen.insert(angle);
      found.push_back(angle);
    }
    std::stable_sort(found.begin(), found.end(),
                     [this](NodeId a, NodeId b) { return graph_[a].children.size() < graph_[b].children.size(); });
    return found;
  }

  /// One of its terms, and the others.
  std::optional<Pair> from_parts(NodeId angle) {
    const Node sum = graph_[angle];
    for (std::size_t i = sum.children.size(); i-- > 0;) {
      std::vector<ir::Term> others;
      for (std::size_t k = 0; k < sum.children.size(); ++k) {
        if (k != i) others.push_back({sum.coefficients[k], sum.children[k]});
      }
      const auto a = pair_of(graph_.linear(sum.value, others));
      const auto b = pair_of(graph_.scale(sum.coefficients[i], sum.children[i]));
      if (!a || !b) continue;
      const std::string name = name_of_sum(graph_, sum);
      return Pair{turned(a->sine, b->cosine, a->cosine, b->sine, 1, name.empty() ? "" : "sin_" + name),
                  turned(a->cosine, b->cosine, a->sine, b->sine, -1, name.empty() ? "" : "cos_" + name)};
    }
    return std::nullopt;
  }

  /// a b ± c d
  NodeId turned(NodeId a, NodeId b, NodeId c, NodeId d, int sign, const std::string& name) {
    return graph_.kept_whole(graph_.linear(0, {{1, graph_.product({a, b})}, {sign, graph_.product({c, d})}}), name);
  }

  std::optional<Pair> pair_of(NodeId angle) {
    const auto sine = value_of(graph_.call(Function::sin, {angle}));
    const auto cosine = value_of(graph_.call(Function::cos, {angle}));
    return sine && cosine ? std::optional<Pair>({*sine, *cosine}) : std::nullopt;
  }

  /// What stands for a sine, a cosine or the opposite of one; nothing where the program has it not.
  std::optional<NodeId> value_of(NodeId id) {
    const Node node = graph_[id];
    const bool is_scaled = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
    const auto found = now_.find((is_scaled ? node.children[0] : id).index);
    if (found == now_.end()) return std::nullopt;
    return is_scaled ? graph_.scale(node.coefficients[0], found->second) : found->second;
  }

  void put(NodeId angle, const Pair& pair) {
    now_.insert_or_assign(graph_.call(Function::sin, {angle}).index, pair.sine);
    now_.insert_or_assign(graph_.call(Function::cos, {angle}).index, pair.cosine);
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  std::unordered_map<std::uint32_t, NodeId> now_;  ///< of sines and cosines: what is computed instead
};

}  // namespace

Request split_calls(Graph& graph, const Request& request) { return Splitter(graph, request).run(request); }

}  // namespace gaussgen::passes
