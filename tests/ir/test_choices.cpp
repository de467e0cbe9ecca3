// abs, sign, min, max, piecewise and tables in the graph: what is decided at once, simplified, differentiated.

#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "ir/differentiate.hpp"
#include "ir/expr.hpp"
#include "ir/print.hpp"
#include "ir/substitute.hpp"
#include "ir/verify.hpp"

namespace {

using namespace gaussgen::ir;
using gaussgen::support::Table;

/// 1 + 2 u up to 3, then 7 - u^2 with u = x - 3.
std::shared_ptr<const Table> some_table(const std::string& name) {
  auto table = std::make_shared<Table>();
  table->name = name;
  table->pieces = {{0, {1, 2, 0}}, {3, {7, 0, -1}}};
  table->derivatives = 1;
  return table;
}

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  SymbolId y_id = graph.declare(SymbolClass::configuration, "y");
  TableId table_id = graph.declare(some_table("k"));
  Expr x{graph, graph.use(x_id)};
  Expr y{graph, graph.use(y_id)};
  Expr number(const Rational& value) { return {graph, graph.constant(value)}; }
  Expr two(Function function, Expr a, Expr b) { return {graph, graph.call(function, {a.id(), b.id()})}; }
  Expr cases(Expr condition, Expr a, Expr b) {
    return {graph, graph.call(Function::piecewise, {condition.id(), a.id(), b.id()})};
  }
  Expr table(Expr at, int order = 0) { return {graph, graph.look_up(table_id, order, at.id())}; }
  Expr pole() { return pow(x - x, -1); }
  std::string text(Expr a) const {
    CHECK(violations(graph, {a.id()}).empty());
    return print(graph, a.id());
  }
};

TEST_CASE_METHOD(Fixture, "comparisons leave signs to what is there before", "[ir]") {
  const Expr m(graph, graph.use(graph.declare(SymbolClass::parameter, "m")));
  for (const Function function : {Function::less, Function::at_most}) {
    CHECK(two(function, -x, m) == two(function, -m, x));
    CHECK(two(function, number(2), -x) == two(function, x, number(-2)));
    CHECK_FALSE(two(function, -x, m) == two(function, x, -m));
    CHECK_FALSE(two(function, -x, y) == two(function, -y, x));
  }
}

TEST_CASE_METHOD(Fixture, "numbers are chosen at once, exactly", "[ir]") {
  CHECK(text(call(Function::abs, number(Rational(-2) / 3))) == "2/3");
  CHECK(text(call(Function::sign, number(-5))) == "-1");
  CHECK(text(call(Function::sign, number(0))) == "0");
  CHECK(text(two(Function::min, number(1), number(2))) == "1");
  CHECK(text(two(Function::max, number(1), number(2))) == "2");
  CHECK(text(two(Function::max, x, x)) == "x");
  CHECK(text(cases(less(number(1), number(2)), x, pole())) == "x");
  CHECK(text(cases(at_most(number(2), number(1)), pole(), y)) == "y");
  CHECK(text(cases(less(x, y), x, x)) == "x");
  CHECK(text(table(number(4))) == "6");
  CHECK(text(table(number(-1))) == "-1");
  CHECK(text(table(number(3), 1)) == "0");
}

TEST_CASE_METHOD(Fixture, "what no rounding unit of any type of numbers changes is decided at once", "[ir]") {
  const Expr epsilon{graph, graph.use(graph.declare(SymbolClass::epsilon, "epsilon"))};
  CHECK(text(at_most(number(9) - 324 * epsilon, number(0))) == "0");
  CHECK(text(less(number(0), number(9) - 324 * epsilon)) == "1");
  CHECK(text(at_most(-epsilon, epsilon)) == "1");
  // Of few digits, or of none that count.
  CHECK(text(at_most(number(1) - 324 * epsilon, number(0))) != "0");
  CHECK(text(less(number(0), epsilon)) != "1");
  CHECK(text(at_most(number(9) - 324 * epsilon, x)) != "0");
}

TEST_CASE_METHOD(Fixture, "of several conditions those that never hold are left out, and one that always holds decides",
                 "[ir]") {
  const Expr one = less(x, y), other = less(y, x), never = less(number(1), number(0)),
             always = less(number(0), number(1));
  const auto any = [&](const std::vector<Expr>& conditions) {
    std::vector<NodeId> ids;
    for (const Expr condition : conditions) ids.push_back(condition.id());
    return text({graph, graph.call(Function::any, ids)});
  };
  CHECK(any({one, never, other}) == any({one, other}));
  CHECK(any({never, one}) == text(one));
  CHECK(any({never, never}) == "0");
  CHECK(any({one, always, other}) == "1");
}

TEST_CASE_METHOD(Fixture, "signs leave abs and sign, and squares of sizes are squares", "[ir]") {
  CHECK(text(call(Function::abs, -x)) == "abs(x)");
  CHECK(text(call(Function::abs, y - x)) == text(call(Function::abs, x - y)));
  CHECK(text(call(Function::sign, -x)) == "-sign(x)");
  CHECK(text(pow(call(Function::abs, x + y), 2)) == "(x + y)^2");
  CHECK(text(call(Function::abs, x) * call(Function::abs, x)) == "x^2");
  CHECK(text(pow(call(Function::abs, x), -4)) == "x^(-4)");
  CHECK(text(pow(call(Function::abs, x), 3)) == "abs(x)^3");
  CHECK(text(call(Function::abs, call(Function::abs, x))) == "abs(x)");
  CHECK(text(call(Function::abs, pow(x, 2))) == "x^2");
  CHECK(text(pow(call(Function::sign, x), 2)) == "sign(x)^2");
}

TEST_CASE_METHOD(Fixture, "each is differentiated on the side on which it is", "[ir]") {
  CHECK(text(partial(call(Function::abs, x * y), x_id)) == "y*sign(x*y)");
  CHECK(text(partial(call(Function::sign, x * y), x_id)) == "0");
  CHECK(text(partial(two(Function::min, x, y), x_id)) == "piecewise(at_most(x, y), 1, 0)");
  CHECK(text(partial(two(Function::max, x, y), y_id)) == "piecewise(at_most(y, x), 0, 1)");
  CHECK(text(partial(cases(less(x, y), pow(x, 2), y), x_id)) == "piecewise(less(x, y), 2*x, 0)");
  CHECK(text(partial(cases(less(x, y), x, x + y), x_id)) == "1");
  CHECK(text(partial(table(2 * x), x_id)) == "2*k'(2*x)");
  CHECK(text(partial(partial(table(x), x_id), x_id)) == "k''(x)");
  CHECK(text(partial(partial(partial(table(x), x_id), x_id), x_id)) == "0");
}

TEST_CASE_METHOD(Fixture, "what may not be chosen may have no value, a condition has one", "[ir]") {
  CHECK_FALSE(graph.is_undefined(cases(less(x, y), x, pole()).id()));
  CHECK(graph.is_undefined(cases(less(pole(), y), x, y).id()));
  CHECK(graph.is_undefined(call(Function::abs, pole()).id()));
  CHECK(graph.is_undefined(two(Function::min, x, pole()).id()));
  CHECK(graph.is_undefined(table(pole()).id()));
  CHECK(graph.is_undefined(table(pole(), 3).id()));
}

TEST_CASE_METHOD(Fixture, "tables keep apart by table and derivative, and survive substitution", "[ir]") {
  const TableId other = graph.declare(some_table("h"));
  CHECK(table(x) == table(x));
  CHECK_FALSE(table(x) == table(x, 1));
  CHECK_FALSE(table(x).id() == graph.look_up(other, 0, x.id()));
  const auto order = [&](NodeId a, NodeId b) { return graph.compare(a, b); };
  CHECK(order(table(x).id(), graph.look_up(other, 0, x.id())) < 0);
  CHECK(order(table(x).id(), table(x, 1).id()) < 0);
  CHECK(order(table(x, 1).id(), table(x).id()) > 0);
  Substitution put(graph);
  put.replace(x_id, y + y);
  CHECK(text(put(table(x, 1) + cases(less(x, y), x, y))) == "piecewise(less(2*y, y), 2*y, y) + k'(2*y)");
}

TEST_CASE_METHOD(Fixture, "comparisons cost nothing, a table what Horner's rule takes", "[ir]") {
  CHECK(operations(graph, {cases(less(x, y), call(Function::abs, x), two(Function::min, x, y)).id()}) == 0);
  CHECK(operations(graph, {table(x).id()}) == 5);
  CHECK(operations(graph, {table(x, 1).id()}) == 3);
}

TEST_CASE_METHOD(Fixture, "a choice by anything but a comparison is a violation", "[ir]") {
  CHECK_FALSE(violations(graph, {graph.call(Function::piecewise, {x.id(), y.id(), graph.constant(1)})}).empty());
}

}  // namespace
