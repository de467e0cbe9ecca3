// Sums that lose digits as they are written.

#include "passes/cancellation.hpp"

#include <string>
#include <utility>
#include <vector>

#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "ir/print.hpp"
#include "ir/verify.hpp"
#include "values.hpp"

using namespace gausstest;
using gaussgen::ir::Rational;
using gaussgen::passes::Request;

namespace {

struct Sum {
  Graph graph;
  Expr x = declare(graph, SymbolClass::configuration, "x");
  Expr y = declare(graph, SymbolClass::configuration, "y");
  Expr L = declare(graph, SymbolClass::parameter, "L");
  Expr one{graph, graph.constant(1)};

  Expr cosine(Expr of) { return call(Function::cos, of); }

  NodeId kept(Expr sum) { return gaussgen::passes::keep_digits(graph, {{sum.id()}, {}, {}}).outputs[0]; }

  /// Rewritten, to the same value in a hundred digits, and once only.
  void check_changes(Expr sum) {
    const NodeId after = kept(sum);
    INFO(gaussgen::ir::print(graph, sum.id()) << " -> " << gaussgen::ir::print(graph, after));
    CHECK(after != sum.id());
    for (unsigned seed = 0; seed < 20; ++seed) CHECK(difference(graph, {sum.id()}, {after}, seed) < 1e-90);
    CHECK(gaussgen::ir::violations(graph, {after}).empty());
    CHECK(kept({graph, after}) == after);
  }

  void check_stays(Expr sum) {
    INFO(gaussgen::ir::print(graph, sum.id()));
    CHECK(kept(sum) == sum.id());
  }
};

}  // namespace

TEST_CASE("sums whose terms cancel in pairs get another form of the same value") {
  Sum s;
  const Expr L = s.L, x = s.x, one = s.one;
  const Rational half = Rational(1) / 2;
  CHECK(s.kept(one - s.cosine(x)) == (2 * pow(call(Function::sin, half * x), 2)).id());
  for (const Expr sum :
       {one - s.cosine(x), one + s.cosine(x), L - L * s.cosine(x), L * s.cosine(x) - L,
        L - L * s.cosine(x) + s.y - s.y * s.cosine(s.y), 2 * L - L * s.cosine(x) - L * s.cosine(s.y),
        3 * one - 2 * s.cosine(x) - s.cosine(s.y), 2 * one + s.cosine(x) + s.cosine(s.y), call(Function::cosh, x) - one,
        call(Function::exp, x) - one, one - call(Function::exp, -x), pow(L * L + x * x, half) - L,
        s.y * pow(L * L + x * x, half) - L * s.y, one - x * x, 4 * x * x - 9 * L * L, s.cosine(x + L) - s.cosine(x),
        call(Function::sin, x + L) - call(Function::sin, x)}) {
    s.check_changes(sum);
  }
}

TEST_CASE("each rule can be left out by its name, and no other one is then") {
  Sum s;
  const Rational half = Rational(1) / 2;
  const Expr square = pow(s.L * s.L + s.x * s.x, half);
  const std::vector<std::pair<const char*, Expr>> sums{{"cosines", s.one - s.cosine(s.x)},
                                                       {"exponentials", call(Function::exp, s.x) - s.one},
                                                       {"exponentials", call(Function::cosh, s.x) - s.one},
                                                       {"logarithms", call(Function::log, s.one + s.x)},
                                                       {"roots", square - s.L},
                                                       {"squares", s.one - s.x * s.x},
                                                       {"angles", s.cosine(s.x + s.L) - s.cosine(s.x)}};
  for (const auto& [rule, sum] : sums) {
    for (const std::string& other : gaussgen::passes::digit_rules()) {
      INFO(rule << " without " << other);
      const NodeId after = gaussgen::passes::keep_digits_except(s.graph, {{sum.id()}, {}, {}}, {other}).outputs[0];
      CHECK((after == sum.id()) == (other == rule));
    }
  }
}

TEST_CASE("a logarithm of one more than a number, and a product of conjugates, get one too") {
  Sum s;
  s.check_changes(call(Function::log, s.one + s.x));
  const NodeId product = s.kept((s.one - s.cosine(s.x)) * (s.one + s.cosine(s.x)));
  CHECK(product == pow(call(Function::sin, s.x), 2).id());
}

TEST_CASE("sums that do not cancel as a whole stay, as another form would take calls for nothing") {
  Sum s;
  const Expr L = s.L, x = s.x, y = s.y;
  for (const Expr sum : {L - L * s.cosine(x) + y, s.cosine(x) - s.cosine(x + y), s.cosine(x) - s.cosine(y), L + x,
                         pow(L * L + x * x, Rational(1) / 2) - y, 2 * s.one - s.cosine(x),
                         2 * s.one - 3 * s.cosine(x) + s.cosine(y), 3 * L - L * s.cosine(x) - L * s.cosine(y),
                         pow(L * L + x * x, Rational(1) / 2) + 2 * s.one, x * x - 2 * y * y}) {
    s.check_stays(sum);
  }
}
