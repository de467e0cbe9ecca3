// Products of many factors, in groups.

#include <algorithm>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/differentiate.hpp"
#include "ir/traverse.hpp"
#include "ir/verify.hpp"

namespace {

using namespace gaussgen::ir;
using cln::cl_F;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;

struct Factors {
  Graph graph;
  std::vector<SymbolId> ids;
  std::vector<NodeId> nodes;
  Directional rate{graph};

  explicit Factors(int count) {
    for (int i = 0; i < count; ++i) {
      ids.push_back(graph.declare(SymbolClass::configuration, "x" + std::to_string(i)));
      nodes.push_back(graph.use(ids.back()));
      rate.seed(ids.back(), {graph, graph.constant(i + 1)});
    }
  }
  Expr second_rate(NodeId f) { return rate(rate({graph, f})); }
  std::size_t edges(Expr f) const {
    std::size_t sum = 0;
    for (const NodeId id : post_order(graph, {f.id()})) sum += graph[id].children.size();
    return sum;
  }
};

TEST_CASE("Derivatives of a product in groups have the values of those of the product") {
  Factors of(40);
  Evaluator<cl_F> evaluator(of.graph, Arithmetic<cl_F>(40));
  for (std::size_t i = 0; i < of.ids.size(); ++i)
    evaluator.bind(of.ids[i], evaluator.arithmetic().number(Rational(static_cast<int>(i) + 7) / 20));
  const NodeId plain = of.graph.product(of.nodes);
  const NodeId grouped = of.graph.product_in_groups(of.nodes, "factors");
  CHECK(plain != grouped);
  const cl_F a = *evaluator(of.second_rate(plain).id());
  const cl_F b = *evaluator(of.second_rate(grouped).id());
  CHECK(gaussgen::evaluate::to_double(cln::abs(a - b) / cln::abs(a)) < 1e-35);
  CHECK(violations(of.graph, {of.second_rate(grouped).id()}) == std::vector<std::string>{});
}

TEST_CASE("A second derivative of a product of many factors grows little faster than the product") {
  Factors small(100);
  Factors large(400);
  const std::size_t few = small.edges(small.second_rate(small.graph.product_in_groups(small.nodes, "factors")));
  const std::size_t many = large.edges(large.second_rate(large.graph.product_in_groups(large.nodes, "factors")));
  CHECK(many < 6 * few);
  CHECK(many < 400 * 60);
}

TEST_CASE("Few factors stay side by side, and the order of many makes no difference") {
  Factors few(10);
  CHECK(few.graph.product_in_groups(few.nodes, "factors") == few.graph.product(few.nodes));
  Factors many(50);
  const NodeId forwards = many.graph.product_in_groups(many.nodes, "factors");
  std::reverse(many.nodes.begin(), many.nodes.end());
  CHECK(many.graph.product_in_groups(many.nodes, "factors") == forwards);
  many.nodes.push_back(many.graph.constant(-3));
  CHECK(many.graph.product_in_groups(many.nodes, "factors") == many.graph.scale(-3, forwards));
}

}  // namespace
