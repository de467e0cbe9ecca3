#include "lower/latex.hpp"

#include "catch_shim.hpp"
#include "ir/expr.hpp"
#include "lower/latex_name.hpp"

using namespace gaussgen;
using ir::Expr;
using lower::latex_name;

TEST_CASE("names become Greek letters, indices and upright words", "[lower]") {
  CHECK(latex_name("chi") == "\\chi");
  CHECK(latex_name("m1") == "m_{1}");
  CHECK(latex_name("R_max") == "R_{\\mathrm{max}}");
  CHECK(latex_name("theta2_in") == "\\theta_{2,\\mathrm{in}}");
  CHECK(latex_name("amplitude") == "\\mathit{amplitude}");
  CHECK(latex_name("wx") == "\\omega_{x}");
  CHECK(latex_name("2") == "2");
}

TEST_CASE("what a user writes cannot act on LaTeX or Markdown", "[lower]") {
  CHECK(lower::latex_text("\\input{x} 50% of $a_b^c$ & #1 ~") ==
        "\\textbackslash{}input\\{x\\} 50\\% of \\$a\\_b\\textasciicircum{}c\\$ \\& \\#1 \\textasciitilde{}");
  CHECK(lower::markdown_text("a*b <i>\n# $x$") == "a\\*b \\<i\\> \\# \\$x\\$");
}

TEST_CASE("quotients, powers and signs print as mathematics", "[lower]") {
  ir::Graph graph;
  const auto symbol = [&](const char* name) {
    return Expr(graph, graph.use(graph.declare(ir::SymbolClass::configuration, name)));
  };
  const Expr a = symbol("a");
  const Expr b = symbol("b");
  const Expr theta = symbol("theta");
  const auto text = [&](Expr e) {
    return lower::latex(graph, e.id(), [&](ir::SymbolId id) { return latex_name(graph.symbol(id).name); });
  };
  const support::Rational half = support::Rational(1) / 2;
  CHECK(text(a / b) == "\\frac{a}{b}");
  CHECK(text((a - b) / (a + b)) == "\\frac{a - b}{a + b}");
  CHECK(text(half * (a * b)) == "\\frac{a\\,b}{2}");
  CHECK(text(-(a * (a + b))) == "-a\\,\\left(a + b\\right)");
  CHECK(text(pow(a + b, 2)) == "\\left(a + b\\right)^{2}");
  CHECK(text(pow(call(ir::Function::sin, theta), 2)) == "\\sin^{2}{\\theta}");
  CHECK(text(call(ir::Function::cos, a - b)) == "\\cos\\left(a - b\\right)");
  CHECK(text(pow(a, half)) == "\\sqrt{a}");
  CHECK(text(pow(a + b, -2)) == "\\frac{1}{\\left(a + b\\right)^{2}}");
}

TEST_CASE("choices and tables print as on paper", "[lower]") {
  ir::Graph graph;
  const auto symbol = [&](const char* name) {
    return Expr(graph, graph.use(graph.declare(ir::SymbolClass::configuration, name)));
  };
  const Expr a = symbol("a");
  const Expr b = symbol("b");
  const Expr one(graph, graph.constant(1));
  auto points = std::make_shared<support::Table>();
  points->name = "motor_torque";
  points->pieces = {{0, {1, 2}}};
  const ir::TableId table = graph.declare(points);
  const auto text = [&](Expr e) {
    return lower::latex(graph, e.id(), [&](ir::SymbolId id) { return latex_name(graph.symbol(id).name); });
  };
  const auto two = [&](ir::Function f, Expr x, Expr y) { return Expr(graph, graph.call(f, {x.id(), y.id()})); };
  const auto cases = [&](Expr condition, Expr x, Expr y) {
    return Expr(graph, graph.call(ir::Function::piecewise, {condition.id(), x.id(), y.id()}));
  };
  CHECK(text(call(ir::Function::abs, a - b)) == "\\left|a - b\\right|");
  CHECK(text(pow(call(ir::Function::abs, a), 3)) == "\\left|a\\right|^{3}");
  CHECK(text(call(ir::Function::sign, a)) == "\\operatorname{sgn}{a}");
  CHECK(text(two(ir::Function::max, a, b)) == "\\max\\left(a, b\\right)");
  CHECK(text(cases(less(a, b), a, cases(at_most(b, one), b, one))) ==
        "\\begin{cases} a & a < b \\\\ b & b \\le 1 \\\\ 1 & \\text{else} \\end{cases}");
  CHECK(text(a * cases(less(a, b), a, b)) ==
        "a\\,\\left(\\begin{cases} a & a < b \\\\ b & \\text{else} \\end{cases}\\right)");
  CHECK(text({graph, graph.look_up(table, 1, a.id())}) == "\\operatorname{motor\\_torque}'{a}");
}
