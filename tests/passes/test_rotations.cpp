// Sines and cosines of sums by rotation from those of the parts.

#include "passes/rotations.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "ir/cost.hpp"
#include "ir/traverse.hpp"
#include "ir/verify.hpp"
#include "values.hpp"

using namespace gausstest;
using gaussgen::ir::Rational;
using gaussgen::passes::Request;

namespace {

/// Angles a, b, … and what is asked for of them.
struct Program {
  Expr angle(const std::string& name, SymbolClass symbol_class = SymbolClass::configuration) {
    return declare(graph, symbol_class, name);
  }

  void ask_sine(Expr x) { outputs.push_back(call(Function::sin, x).id()); }
  void ask(Expr x) {
    ask_sine(x);
    outputs.push_back(call(Function::cos, x).id());
  }

  Request rotated() { return gaussgen::passes::rotate_angles(graph, {outputs, {}, {}}); }

  int calls_left() { return calls(rotated().outputs); }
  int calls(const std::vector<NodeId>& of) { return count_operations(graph, of).functions; }

  Graph graph;
  std::vector<NodeId> outputs;
};

/// One after the other: each rotation is a product in a sum.
int rotations_in(const Graph& graph, NodeId root) {
  std::unordered_map<std::uint32_t, int> height;
  for (const NodeId id : gaussgen::ir::post_order(graph, {root})) {
    int most = 0;
    for (const NodeId child : graph[id].children) most = std::max(most, height.at(child.index));
    height[id.index] = most + (graph[id].kind == gaussgen::ir::Kind::product ? 1 : 0);
  }
  return height.at(root.index);
}

}  // namespace

TEST_CASE("a sum or a difference of two angles whose sines and cosines are there takes no call") {
  for (const int sign : {1, -1}) {
    Program program;
    const Expr a = program.angle("a"), b = program.angle("b");
    for (const Expr x : {a, b, a + sign * b}) program.ask(x);
    CHECK(program.calls(program.outputs) == 6);
    CHECK(program.calls_left() == 4);
    // Two rotations of a value each: 4 multiplications, 2 additions; the sum of the angles is not needed any more.
    CHECK(count_operations(program.graph, program.rotated().outputs).total() == 4 + 6);
  }
}

TEST_CASE("so does one of three parts, the double of an angle, and one with an angle of parameters") {
  Program three;
  const Expr a = three.angle("a"), b = three.angle("b"), c = three.angle("c");
  for (const Expr x : {a, b, c, a + b - c}) three.ask(x);
  CHECK(three.calls_left() == 6);

  Program twice;
  const Expr x = twice.angle("x");
  twice.ask(x);
  twice.ask(2 * x);
  CHECK(twice.calls_left() == 2);

  Program tilted;
  const Expr y = tilted.angle("y"), tilt = tilted.angle("tilt", SymbolClass::parameter);
  tilted.ask(y);
  tilted.ask(y + tilt);
  CHECK(tilted.calls_left() == 2);  // those of the tilt are computed in prepare
}

TEST_CASE("names do not hide what a sum is made of") {
  Program program;
  const Expr a = program.angle("a"), b = program.angle("b"), c = program.angle("c");
  const Expr first = (a + b).named("first");
  for (const Expr x : {a, b, c, first, first + c}) program.ask(x);
  CHECK(program.calls_left() == 6);
}

TEST_CASE("an angle is called where its parts are not there, or would have to be called for it") {
  Program apart;
  const Expr a = apart.angle("a"), b = apart.angle("b"), c = apart.angle("c");
  for (const Expr x : {a, b + c, a + b}) apart.ask(x);
  CHECK(apart.rotated().outputs == apart.outputs);

  // Three more cosines cost more than a sine.
  Program halves;
  const Expr x = halves.angle("x"), y = halves.angle("y"), z = halves.angle("z");
  for (const Expr s : {x, y, z, x + y + z}) halves.ask_sine(s);
  CHECK(halves.rotated().outputs == halves.outputs);
}

TEST_CASE("no angle stands behind more than two rotations") {
  Program program;
  std::vector<Expr> links;
  Expr sum = program.angle("t0");
  program.ask(sum);
  for (int i = 1; i < 7; ++i) {
    const Expr link = program.angle("t" + std::to_string(i));
    program.ask(link);
    program.ask(sum = sum + link);
  }
  int most = 0;
  for (const NodeId value : program.rotated().outputs) most = std::max(most, rotations_in(program.graph, value));
  CHECK(most == 2);
  CHECK(program.calls_left() < 2 * (7 + 3));
}

TEST_CASE("values stay what they are, and a second run changes nothing") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Program program;
    std::mt19937 source(seed);
    std::uniform_int_distribution<int> coefficient(-2, 2), kind(0, 2);
    std::vector<Expr> angles;
    for (const char* name : {"a", "b", "c", "d"}) angles.push_back(program.angle(name));
    angles.push_back(call(Function::sin, angles[0] + angles[1]));
    for (int i = 0; i < 12; ++i) {
      Expr sum = angles[static_cast<std::size_t>(i) % angles.size()];
      for (const Expr angle : angles) sum = sum + coefficient(source) * (kind(source) == 0 ? angle.named("n") : angle);
      kind(source) == 0 ? program.ask_sine(sum) : program.ask(sum);
    }
    for (const Expr angle : angles) program.ask(angle);
    const Request once = program.rotated();
    INFO("seed " << seed);
    CHECK(program.calls(once.outputs) < program.calls(program.outputs));
    CHECK(difference(program.graph, program.outputs, once.outputs, seed) < 1e-35);
    CHECK(gaussgen::ir::violations(program.graph, once.outputs).empty());
    CHECK(gaussgen::passes::rotate_angles(program.graph, once).outputs == once.outputs);
  }
}

TEST_CASE("an error is that of a change of the parts in their last digits, also where the sum is next to zero") {
  Program program;
  const Expr a = program.angle("a"), b = program.angle("b");
  for (const Expr x : {a, b, a - b}) program.ask(x);
  const Request rotated = program.rotated();
  gaussgen::evaluate::Evaluator<double> values(program.graph, gaussgen::evaluate::Arithmetic<double>());
  std::mt19937 source(1986);
  std::uniform_real_distribution<double> angle(-3, 3), exponent(-18, 0);
  for (int i = 0; i < 1000; ++i) {
    const double x = angle(source) * std::pow(10, exponent(source));
    const double y = i % 2 == 0 ? x : x * (1 + 1e-3 * angle(source));
    values.bind({0}, x);
    values.bind({1}, y);
    const double found = *values(rotated.outputs[4]);
    const double exact = std::sin(x - y);  // the difference is exact
    REQUIRE(std::abs(found - exact) <= 2 * 2.3e-16 * (std::abs(x) + std::abs(y)));
    if (x == y) REQUIRE(found == 0);
  }
}
