#include "catch_shim.hpp"
#include "fixture.hpp"

using namespace gausstest;
using gaussgen::passes::Program;
using gaussgen::passes::Writing;

TEST_CASE("what is used twice and costs an operation becomes a temporary, what is used once does not") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr z = declare(graph, SymbolClass::configuration, "z");
  const Expr shared = x + y;
  const Expr single = y * z;
  const Program program = program_of(graph, {{(shared * z).id(), (shared * single).id()}, {}, {}});
  CHECK(contains(temporaries(program), shared));
  CHECK_FALSE(contains(temporaries(program), single));
}

TEST_CASE("symbols, constants and minus signs are never temporaries, but what a minus sign repeats is") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr minus = -(x * y);
  const Program program = program_of(graph, {{minus.id(), minus.id(), x.id(), x.id(), (-x).id(), (-x).id()}, {}, {}});
  REQUIRE(temporaries(program).size() == 1);
  CHECK(contains(temporaries(program), x * y));
}

TEST_CASE("powers of one base share their squares") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  Writing writing(graph, {pow(x, 2).id(), pow(x, 3).id(), pow(x, 5).id()});
  CHECK(writing.operands(pow(x, 3).id()) == gaussgen::ir::Children{x.id(), pow(x, 2).id()});
  CHECK(writing.operands(pow(x, 5).id()) == gaussgen::ir::Children{x.id(), pow(x, 2).id(), pow(x, 2).id()});
  const Program program = program_of(graph, {{pow(x, 3).id(), pow(x, 5).id()}, {}, {}});
  CHECK(contains(temporaries(program), pow(x, 2)));
}

TEST_CASE("a large power takes as many products as its binary digits ask for") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  Writing writing(graph, {pow(x, 64).id()});
  CHECK(writing.order().size() == 7);  // x, x^2, x^4, … x^64
}

TEST_CASE("one reciprocal serves all powers of it that are wanted beside it") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  Writing beside(graph, {pow(x, -1).id(), pow(x, -2).id()});
  CHECK(beside.operands(pow(x, -2).id()) == gaussgen::ir::Children{pow(x, -1).id(), pow(x, -1).id()});
  Writing alone(graph, {pow(x, -2).id()});
  CHECK(alone.operands(pow(x, -2).id()) == gaussgen::ir::Children{pow(x, 2).id()});
}

TEST_CASE("half powers are a square root and a power") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const auto half = [](int n) { return gaussgen::ir::Rational(n) / 2; };
  Writing writing(graph, {pow(x, half(5)).id()});
  CHECK(writing.operands(pow(x, half(5)).id()) == gaussgen::ir::Children{pow(x, 2).id(), pow(x, half(1)).id()});
}

TEST_CASE("a sine and a cosine of one argument are one assignment") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr sum = x + y;
  const Program program = program_of(
      graph, {{(call(Function::sin, sum) * call(Function::cos, sum)).id(), call(Function::sin, x).id()}, {}, {}});
  REQUIRE(program.blocks.size() == 1);
  REQUIRE(program.blocks[0].assignments.size() == 2);
  // As they are needed; and the argument of a pair is written once, so it needs no name.
  CHECK(*program.blocks[0].assignments[0].cosine == call(Function::cos, sum).id());
  CHECK(program.blocks[0].assignments[1].node == call(Function::sin, x).id());
  CHECK_FALSE(program.blocks[0].assignments[1].cosine);
}

TEST_CASE("wanted names make temporaries, suggested names do not") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr product = x * y;
  const gaussgen::passes::Section section{"block",
                                          {{product.id(), "work"}, {pow(x, 7).id(), "not needed"}, {x.id(), "plain"}}};
  const Program wanted = program_of(graph, {{product.id()}, {section}, {}});
  REQUIRE(wanted.blocks.size() == 1);
  REQUIRE(wanted.blocks[0].assignments.size() == 1);
  CHECK(wanted.blocks[0].comment == "block");
  CHECK(wanted.blocks[0].assignments[0].name == "work");
  CHECK(program_of(graph, {{product.id()}, {}, {{product.id(), "work"}}}).blocks.empty());
  CHECK(program_of(graph, {{product.id(), product.id()}, {}, {{product.id(), "work"}}}).blocks[0].assignments[0].name ==
        "work");
}

TEST_CASE("an expression that would be too long to read is cut into temporaries") {
  Graph graph;
  Expr total = declare(graph, SymbolClass::configuration, "x0");
  for (int i = 1; i < 200; ++i) {
    const Expr x = declare(graph, SymbolClass::configuration, "x" + std::to_string(i));
    total = call(Function::tan, x) + pow(total, 2) * x;
  }
  const Program program = program_of(graph, {{total.id()}, {}, {}});
  CHECK(temporaries(program).size() > 199);
}

TEST_CASE("a graph that is deep does not overflow the stack") {
  Graph graph;
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  Expr deep = declare(graph, SymbolClass::configuration, "x");
  for (int i = 0; i < 100000; ++i) deep = call(Function::atan, deep + y);
  CHECK(temporaries(program_of(graph, {{deep.id()}, {}, {}})).size() == 100000);
}
