#include <random>

#include "catch_shim.hpp"
#include "fixture.hpp"
#include "ir/print.hpp"

using namespace gausstest;
using gaussgen::passes::Program;
using gaussgen::passes::Request;
using gaussgen::passes::Writing;

namespace {

/// A random graph over a few symbols; the same for the same seed.
std::vector<NodeId> random_outputs(Graph& graph, unsigned seed, int size) {
  std::mt19937 random(seed);
  std::vector<Expr> nodes;
  for (const char* name : {"x", "y", "z"}) nodes.push_back(declare(graph, SymbolClass::configuration, name));
  const auto pick = [&] { return nodes[random() % nodes.size()]; };
  for (int i = 0; i < size; ++i) {
    switch (random() % 6) {
      case 0: nodes.push_back(pick() + pick()); break;
      case 1: nodes.push_back(pick() * pick()); break;
      case 2: nodes.push_back(pow(pick(), static_cast<int>(random() % 4) + 2)); break;
      case 3: nodes.push_back(call(Function::sin, pick())); break;
      case 4: nodes.push_back(call(Function::cos, pick())); break;
      default: nodes.push_back(-pick()); break;
    }
  }
  return {nodes.back().id(), nodes[nodes.size() - 2].id(), nodes[nodes.size() / 2].id()};
}

std::string text(const Graph& graph, const Program& program) {
  std::string result;
  for (const auto& block : program.blocks) {
    result += block.comment + "\n";
    for (const auto& assignment : block.assignments) result += gaussgen::ir::print(graph, assignment.node) + "\n";
  }
  return result;
}

}  // namespace

TEST_CASE("every temporary is defined once, before its use, and used: random graphs") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Graph graph;
    const Request request{random_outputs(graph, seed, 30), {}, {}};
    const Writing writing(graph, request.outputs);
    const Program program = schedule(writing, share(writing, request), request);
    CHECK(violations(writing, program).empty());
  }
}

TEST_CASE("broken programs are found out") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr inner = call(Function::exp, x);
  const Expr outer = call(Function::exp, inner + y);
  const Request request{{(outer * inner).id()}, {}, {}};
  const Writing writing(graph, request.outputs);
  const Program good = schedule(writing, share(writing, request), request);
  REQUIRE(violations(writing, good).empty());
  REQUIRE(good.blocks[0].assignments.size() == 2);

  Program swapped = good;
  std::swap(swapped.blocks[0].assignments[0], swapped.blocks[0].assignments[1]);
  CHECK(violations(writing, swapped).front().find("before its definition") != std::string::npos);
  Program twice = good;
  twice.blocks[0].assignments.push_back(twice.blocks[0].assignments[0]);
  CHECK(violations(writing, twice).front().find("defined twice") != std::string::npos);
  Program missing = good;
  missing.blocks[0].assignments.erase(missing.blocks[0].assignments.begin());
  CHECK(violations(writing, missing).front().find("computed twice") != std::string::npos);
  Program unused = good;
  unused.outputs = {y.id()};
  CHECK(violations(writing, unused).front().find("without a use") != std::string::npos);
}

TEST_CASE("sines come in the order in which they are needed, each with its cosine") {
  Graph graph;
  std::vector<Expr> q;
  for (const char* name : {"q_1", "q_2", "q_3"}) q.push_back(declare(graph, SymbolClass::configuration, name));
  const auto turned = [&](std::size_t i, Expr before) {
    return call(Function::sin, q[i]) * before + call(Function::cos, q[i]) * pow(before, 2);
  };
  const Expr inner = turned(2, q[0]).named("inner");
  const Expr middle = turned(0, inner).named("middle");
  const Expr outer = turned(1, middle).named("outer");
  Request request{
      {outer.id()}, {{"inward", {{inner.id(), "inner"}, {middle.id(), "middle"}, {outer.id(), "outer"}}}}, {}};
  const Writing writing(graph, request.outputs);
  const Program program = schedule(writing, share(writing, request), request);
  REQUIRE(program.blocks[0].comment == "Sines and cosines");
  std::vector<std::string> order;
  for (const auto& assignment : program.blocks[0].assignments)
    order.push_back(gaussgen::ir::print(graph, assignment.node));
  CHECK(order == std::vector<std::string>{"sin(q_3)", "sin(q_1)", "sin(q_2)"});
}

TEST_CASE("the order depends on structure only, not on when nodes were made") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Graph plain;
    const Request request{random_outputs(plain, seed, 30), {}, {}};
    const std::string expected = text(plain, program_of(plain, request));
    Graph littered;
    // Other nodes first, so that every NodeId differs.
    Expr litter = declare(littered, SymbolClass::input, "litter");
    for (int i = 0; i < 100; ++i) litter = call(Function::exp, litter);
    const Request same{random_outputs(littered, seed, 30), {}, {}};
    CHECK(text(littered, program_of(littered, same)) == expected);
  }
}

TEST_CASE("sections appear in their order, each with what it needs first") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr common = call(Function::exp, x);
  const Expr first = common + y;
  const Expr second = common * y;
  const Program program = program_of(
      graph, {{first.id(), second.id()},
              {{"one", {{first.id(), "a"}}}, {"none", {{pow(y, 9).id(), "c"}}}, {"two", {{second.id(), "b"}}}},
              {}});
  REQUIRE(program.blocks.size() == 2);
  CHECK(program.blocks[0].comment == "one");
  CHECK(program.blocks[0].assignments[0].node == common.id());
  CHECK(program.blocks[0].assignments[1].name == "a");
  CHECK(program.blocks[1].comment == "two");
}
