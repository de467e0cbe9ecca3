// The size of terms (strategy/term_size.hpp) against rounding itself: the same expressions in double and in long double.

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "strategy/term_size.hpp"

namespace {

using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;
using gaussgen::ir::Expr;
using gaussgen::ir::Function;
using gaussgen::ir::Graph;
using gaussgen::ir::Rational;
using gaussgen::ir::SymbolClass;
using gaussgen::ir::SymbolId;
using gaussgen::strategy::TermSize;

/// Two coordinates, a parameter and time.
struct Case {
  Graph graph;
  SymbolId x = graph.declare(SymbolClass::configuration, "x"), y = graph.declare(SymbolClass::configuration, "y"),
           a = graph.declare(SymbolClass::parameter, "a"), t = graph.declare(SymbolClass::time, "t");

  Expr use(SymbolId id) { return {graph, graph.use(id)}; }

  /// Not exact, as a difference of two such numbers is.
  Expr gap() { return Rational(4) / 3 * use(x) - Rational(1) / 3 * use(y) - use(a); }

  template <class T>
  T at(Expr e, const std::vector<double>& values) {
    Evaluator<T> evaluator(graph, Arithmetic<T>());
    const SymbolId symbols[] = {x, y, a, t};
    for (std::size_t i = 0; i < 4; ++i) evaluator.bind(symbols[i], T(values[i]));
    return evaluator(e.id()).value();
  }
};

using Build = std::function<Expr(Case&)>;

/// The largest |e in double - e| / (ε size) over states with coordinates near `far`, and a as far.
double worst(const Build& build, double far) {
  Case in;
  const Expr e = build(in), size = TermSize(in.graph)(e);
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> near(0.5, 2);
  double result = 0;
  for (int k = 0; k < 1000; ++k) {
    const std::vector<double> values{far + near(engine), far + near(engine), far, near(engine)};
    const long double exact = in.at<long double>(e, values);
    const double rounding = static_cast<double>(std::abs(in.at<double>(e, values) - exact));
    const double sized = in.at<double>(size, values);
    CHECK(sized >= std::abs(static_cast<double>(exact)) * (1 - 1e-9));
    result = std::fmax(result, rounding / (0x1p-53 * sized));
  }
  return result;
}

}  // namespace

TEST_CASE("rounding of an expression is a few units of the size of its terms, wherever they cancel") {
  const std::vector<Build> builds{
      [](Case& c) { return pow(c.use(c.x) - c.use(c.a), 2) + pow(c.use(c.y) - c.use(c.a), 2); },
      [](Case& c) { return c.use(c.x) * c.use(c.y) - pow(c.use(c.a), 2); },
      [](Case& c) { return c.gap() * (c.use(c.x) - c.use(c.a)) * c.use(c.t); },
      [](Case& c) { return pow(pow(c.use(c.x), 2) - pow(c.use(c.a), 2), Rational(1) / 2) - c.use(c.y); },
      [](Case& c) { return pow(c.use(c.x) - c.use(c.a), -2) - c.use(c.t); },
      [](Case& c) { return c.use(c.a) * call(Function::sin, c.use(c.t)) - c.use(c.x); },
      [](Case& c) { return call(Function::cos, c.use(c.a) * c.use(c.t)) - c.use(c.t); },
      [](Case& c) { return call(Function::exp, c.gap()) - c.use(c.t); },
      [](Case& c) { return call(Function::atan, c.gap()) * (c.use(c.y) - c.use(c.x)); },
      [](Case& c) {
        return (c.use(c.x) - c.use(c.a)).named("reach") * c.use(c.y) + call(Function::abs, c.use(c.x) - c.use(c.y));
      },
      [](Case& c) {
        return select(less(c.use(c.x), c.use(c.y)), c.use(c.x) - c.use(c.a), pow(c.use(c.y), 2) - pow(c.use(c.a), 2));
      },
  };
  for (std::size_t i = 0; i < builds.size(); ++i) {
    for (const double far : {0.0, 1.0, 1e3, 1e6, 1e9}) {
      INFO("expression " << i << ", " << far << " off");
      CHECK(worst(builds[i], far) < 8);
    }
  }
}

TEST_CASE("of a square of a difference, the size follows the difference and not the square of its terms") {
  Case in;
  const Expr square = pow(in.use(in.x) - in.use(in.a), 2);
  CHECK(in.at<double>(TermSize(in.graph)(square), {1e6 + 1, 0, 1e6, 0}) == Approx(1 + 2 * (2e6 + 1)));
}

TEST_CASE("what only parameters make large is computed from parameters alone") {
  Case in;
  const Expr e = in.use(in.a) * call(Function::cos, in.use(in.x)) - call(Function::sin, in.use(in.y));
  CHECK(TermSize(in.graph)(e) == call(Function::abs, in.use(in.a)) + Expr(in.graph, in.graph.constant(1)));
}
