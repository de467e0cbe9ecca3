#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "support/assert.hpp"
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
