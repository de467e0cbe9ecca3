#include <ctime>
#include <set>

#include "catch_shim.hpp"
#include "ir/expr.hpp"
#include "ir/traverse.hpp"

namespace {

using namespace gaussgen::ir;

struct Fixture {
  Graph graph;
  Expr m{graph, graph.use(graph.declare(SymbolClass::parameter, "m"))};
  Expr x{graph, graph.use(graph.declare(SymbolClass::configuration, "x"))};
};

TEST_CASE_METHOD(Fixture, "children come before parents and every node once", "[ir]") {
  const Expr shared = call(Function::sin, x);
  const Expr root = shared * (shared + m) + pow(shared + m, 3);
  std::set<std::uint32_t> seen;
  for (const NodeId id : post_order(graph, {root.id(), shared.id()})) {
    for (const NodeId child : graph[id].children) CHECK(seen.count(child.index) == 1);
    CHECK(seen.insert(id.index).second);
  }
  CHECK(seen.count(root.id().index) == 1);
}

TEST_CASE_METHOD(Fixture, "a walk does not go below a node where it is told to stop", "[ir]") {
  const Expr inner = x + m;
  const Expr root = call(Function::sin, inner);
  const auto order = post_order(graph, {root.id()}, [&](NodeId id) { return id == inner.id(); });
  CHECK(order == std::vector<NodeId>{inner.id(), root.id()});
}

TEST_CASE_METHOD(Fixture, "dependence reaches parents and stops at parameters", "[ir]") {
  const Expr fixed = call(Function::sin, m);
  const Expr root = fixed * x;
  const NodeSet depends = depends_on(graph, post_order(graph, {root.id()}), varies);
  CHECK(depends.contains(root.id()));
  CHECK(depends.contains(x.id()));
  CHECK_FALSE(depends.contains(fixed.id()));
}

TEST_CASE_METHOD(Fixture, "depth is no obstacle", "[ir]") {
  Expr a = x;
  for (int i = 0; i < 100000; ++i) a = call(Function::sin, a);
  CHECK(post_order(graph, {a.id()}).size() == 100001);
}

TEST_CASE_METHOD(Fixture, "many small walks in a large graph cost what they visit", "[ir]") {
  const Expr small = call(Function::sin, x + m);
  const auto time_of_walks = [&] {
    const std::clock_t begin = std::clock();
    std::size_t visited = 0;
    for (int i = 0; i < 5000; ++i) visited += post_order(graph, {small.id()}).size();
    CHECK(visited == 20000);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  const double before = time_of_walks();
  for (int i = 0; i < 200000; ++i) graph.constant(Rational(i) + Rational(1) / 3);
  // A mark per node of the graph would take ten thousand times as long.
  CHECK(time_of_walks() < 50 * before + 0.05);
}

TEST_CASE("a table of nodes holds what was put in", "[ir]") {
  NodeTable<int> table;
  CHECK_FALSE(table.contains(NodeId{7}));
  for (std::uint32_t i = 0; i < 1000; ++i) table[NodeId{i * i}] = static_cast<int>(i);
  CHECK(table.size() == 1000);
  for (std::uint32_t i = 0; i < 1000; ++i) CHECK(*table.find(NodeId{i * i}) == static_cast<int>(i));
  CHECK_FALSE(table.contains(NodeId{2}));
  table.clear();
  CHECK_FALSE(table.contains(NodeId{0}));
}

}  // namespace
