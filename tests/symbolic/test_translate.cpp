#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "support/assert.hpp"
#include "symbolic/choices.hpp"
#include "symbolic/rational.hpp"

using namespace gaussgen;

namespace {

GiNaC::ex velocity(const std::string& expression) {
  const model::Model model = oracle::model_of_text(R"(
gauss: 1
name: one
parameters: {m: {value: 0.1}}
coordinates: {q: {}, p: {}}
particles: {it: {mass: m, position: [q, p, 0]}}
constraints: {row: {velocity: ")" + expression + R"("}}
)");
  const symbolic::Chart chart(model);
  GiNaC::exmap numbers;
  for (const auto& [name, symbol] : chart.symbols()) numbers[symbol] = name == "q" ? 2 : (name == "p" ? 3 : 5);
  return chart(std::get<model::VelocityLaw>(model.constraints[0].law).phi).subs(numbers);
}

}  // namespace

TEST_CASE("decimals stay exact rationals", "[symbolic]") {
  CHECK(velocity("dot(q)*0.1").is_equal(GiNaC::numeric(1, 2)));
  CHECK(velocity("dot(q) + 1e-3").is_equal(GiNaC::numeric(5001, 1000)));
  const support::Rational value = support::Rational(-22) / 7;
  CHECK(symbolic::rational(GiNaC::ex_to<GiNaC::numeric>(symbolic::number(value))) == value);
  CHECK_THROWS_AS(symbolic::rational(GiNaC::numeric(0.5)), support::InternalError);
}

TEST_CASE("sums, differences, quotients and powers mean what they say", "[symbolic]") {
  CHECK(velocity("dot(q) - q/p").is_equal(GiNaC::numeric(13, 3)));
  CHECK(velocity("dot(q)*q^3 - (p - q)^-2").is_equal(39));
  CHECK(velocity("-dot(q)^2").is_equal(-25));
  CHECK(velocity("dot(q)*sqrt(q^2 - p + 3)").is_equal(10));
  CHECK(velocity("dot(q)*(p - p)^0").is_equal(5));
}

TEST_CASE("dot is the total time derivative", "[symbolic]") {
  CHECK(velocity("dot(q*p)").is_equal(25));
  CHECK(velocity("dot(q^2*t)").is_equal(4 * 5 * 5 + 4));
}

TEST_CASE("choices stay whole, and are differentiated case by case", "[symbolic]") {
  const GiNaC::realsymbol x("x"), y("y");
  CHECK(symbolic::abs_of(-x).is_equal(symbolic::abs_of(-x)));
  CHECK(GiNaC::ex(symbolic::abs_of(x * y)).diff(x).is_equal(y * symbolic::sign_of(x * y)));
  CHECK(GiNaC::ex(symbolic::sign_of(x)).diff(x).is_zero());
  // The logarithm is not multiplied by 0 where it is not chosen.
  const GiNaC::ex guarded = symbolic::case_less(0, x, x * GiNaC::log(x), y);
  CHECK(guarded.diff(x).is_equal(symbolic::case_less(0, x, 1 + GiNaC::log(x), 0)));
  CHECK(guarded.diff(y).is_equal(symbolic::case_less(0, x, 0, 1)));
  CHECK(GiNaC::ex(symbolic::min_of(x, y)).diff(x).is_equal(symbolic::case_at_most(x, y, 1, 0)));
  CHECK(GiNaC::ex(symbolic::max_of(x, y)).diff(x).is_equal(symbolic::case_at_most(y, x, 1, 0)));
  CHECK(GiNaC::ex(symbolic::table_at(3, 0, x * x)).diff(x).is_equal(2 * x * symbolic::table_at(3, 1, x * x)));
}
