#include "passes/rewrite.hpp"

#include <algorithm>

#include "ir/content.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using ir::Term;

void Rewrite::replace(NodeId old, NodeId now) {
  map_[old] = now;
  if (old == now || graph_[old].kind == Kind::named) return;
  const std::string& label = graph_.label(old);
  if (!label.empty() && graph_.label(now).empty()) graph_.relabel(now, label);
}

NodeId Rewrite::rebuilt(NodeId old) const {
  const Node& node = graph_[old];
  // Most nodes stay as they are.
  const bool is_same =
      std::all_of(node.children.begin(), node.children.end(), [this](NodeId child) { return (*this)(child) == child; });
  if (is_same) return old;
  std::vector<NodeId> children;
  children.reserve(node.children.size());
  for (const NodeId child : node.children) children.push_back((*this)(child));
  switch (node.kind) {
    case Kind::sum: {
      std::vector<Term> terms;
      for (std::size_t i = 0; i < children.size(); ++i) terms.push_back({node.coefficients[i], children[i]});
      return graph_.linear(node.value, terms);
    }
    case Kind::product: return graph_.product(children);
    case Kind::power: return graph_.power(children[0], node.value);
    case Kind::function: return graph_.call_again(node, children);
    case Kind::named: return graph_.kept_whole(children[0], graph_.name(node));
    default: return old;
  }
}

Request Rewrite::operator()(const Request& request) const {
  Request result;
  for (const NodeId output : request.outputs) result.outputs.push_back((*this)(output));
  const auto moved = [&](const std::vector<std::pair<NodeId, std::string>>& nodes) {
    std::vector<std::pair<NodeId, std::string>> kept;
    for (const auto& [node, name] : nodes) {
      if (knows(node)) kept.emplace_back((*this)(node), name);
    }
    return kept;
  };
  for (const Section& section : request.sections) result.sections.push_back({section.comment, moved(section.nodes)});
  result.suggestions = moved(request.suggestions);
  return result;
}

NodeId closed(Graph& graph, NodeId node) {
  const bool is_negative = graph[node].kind == Kind::sum && ir::signed_content(graph[node]) < 0;
  return is_negative ? graph.scale(-1, graph.kept_whole(graph.scale(-1, node), "")) : graph.kept_whole(node, "");
}

bool is_binary(const ir::Rational& value) { return cln::logcount(cln::cl_I(cln::denominator(value))) == 1; }

std::vector<Factor> factors_of(const Graph& graph, NodeId id) {
  const auto one = [&](NodeId factor) -> Factor {
    const Node& node = graph[factor];
    const bool is_whole = node.kind == Kind::power && support::is_integer(node.value) && cln::abs(node.value) <= 8;
    return is_whole ? Factor{node.children[0], support::to_int(node.value)} : Factor{factor, 1};
  };
  std::vector<Factor> factors;
  if (graph[id].kind != Kind::product) return {one(id)};
  for (const NodeId child : graph[id].children) factors.push_back(one(child));
  return factors;
}

}  // namespace gaussgen::passes
