// The minimum over the turn of a bar with its divisions postponed is the Schur complement, in exact numbers.

#include <random>

#include "catch_shim.hpp"
#include "strategy/bar.hpp"

namespace {

using gaussgen::ir::Expr;
using gaussgen::ir::Graph;
using gaussgen::ir::Rational;
using namespace gaussgen::strategy;

struct Numbers {
  Expr number(const Rational& value) { return {graph, graph.constant(value)}; }
  Expr random() { return number(Rational(static_cast<int>(engine() % 19) - 9) / static_cast<int>(engine() % 5 + 1)); }
  Expr positive() {
    return number(Rational(static_cast<int>(engine() % 19) + 20) / static_cast<int>(engine() % 5 + 1));
  }

  Graph graph;
  std::mt19937 engine{20261123};
};

struct Reference {
  Expr inertia;
  PlaneBlock block;
};

/// Z of the end and of the bar over (angle, origin): I α²/2 + α b·a + ½ a·P a, with u the way of the end and k that of the mass centre per angle.
Reference schur_complement(const Bar& bar) {
  const PlaneVector u{-bar.offset[1], bar.offset[0]}, k{-bar.first[1], bar.first[0]};
  const PlaneBlock& P = bar.end;
  const PlaneVector Pu = P * u;
  const Expr I = u[0] * Pu[0] + u[1] * Pu[1] + bar.inertia;
  const PlaneVector b{Pu[0] + k[0], Pu[1] + k[1]};
  return {I, PlaneBlock::of(P.pp - b[0] * b[0] / I, P.pq - b[0] * b[1] / I, P.qq - b[1] * b[1] / I)};
}

void check_equal(const PlaneBlock& found, const PlaneBlock& expected) {
  CHECK(found.pp == expected.pp);
  CHECK(found.pq == expected.pq);
  CHECK(found.qq == expected.qq);
  CHECK(found.determinant == expected.determinant);
}

void check(const Bar& bar, Expr mass) {
  Steps steps;
  PostponedBlock block(bar, "I", steps);
  const Reference reference = schur_complement(bar);
  CHECK(block.inverse() == pow(reference.inertia, -1));
  CHECK(block.left_to_end() == bar.inertia / reference.inertia);
  check_equal(block.divided(), reference.block);
  block.add_mass(mass);
  const PlaneBlock& before = reference.block;
  check_equal(block.divided(), PlaneBlock::of(before.pp + mass, before.pq, before.qq + mass));
}

TEST_CASE("numerators over one denominator are the Schur complement over the turn of a bar") {
  Numbers n;
  const Expr none = n.number(0);
  for (int i = 0; i < 100; ++i) {
    const PlaneBlock end = PlaneBlock::of(n.positive(), n.random(), n.positive());
    const PlaneVector offset{n.random(), n.positive()};
    INFO(i);
    check({offset, end, n.positive(), {none, none}}, n.positive());              // masses at its ends
    check({offset, end, none, {none, none}}, n.positive());                      // and nothing else
    check({offset, end, n.positive(), {n.random(), n.random()}}, n.positive());  // a mass centre anywhere
    check({{none, n.positive()}, end, -n.number(Rational(1) / 6), {none, none}}, n.positive());
  }
}

TEST_CASE("a bar is led by its end where its masses at the ends leave none to its turn, or less") {
  Numbers n;
  Steps steps;
  const Expr none = n.number(0);
  const PlaneBlock end = PlaneBlock::of(n.positive(), n.random(), n.positive());
  const auto is_led = [&](Expr inertia, Expr first) {
    return PostponedBlock({{none, n.number(1)}, end, inertia, {none, first}}, "I", steps).is_led_by_end();
  };
  CHECK(is_led(n.number(Rational(-1) / 6), none));
  CHECK_FALSE(is_led(n.number(Rational(1) / 6), none));
  CHECK(is_led(none, none));  // without mass of its own
  CHECK_FALSE(is_led(none, n.number(1)));
  CHECK_FALSE(is_led(n.number(Rational(-1) / 6), n.number(1)));
}

}  // namespace
