// What is corrected after each step, and what is refused.
#include <cmath>

#include "catch_shim.hpp"
#include "problems.hpp"

namespace {

using gausssim::make_integrator;
using gausssim::MethodSettings;
using gausssim::Projection;
using problems::Bob;
using problems::Kepler;
using Model = gausssim::MotionModel<double>;
using Array = gausssim::Numbers<double>;

struct Misses {
  double position, speed, energy;
};

Misses misses_after_ten(const std::string& method, Projection how) {
  MethodSettings<double> settings;
  settings.projection = how;
  settings.step = 0.02;
  settings.tolerance = 1e-5;
  std::string why;
  const Model model(Bob<double>::functions());
  const auto integrator = make_integrator(method, model, Bob<double>::start(), 0.0, settings, why);
  INFO(method << ": " << why);
  REQUIRE(integrator != nullptr);
  REQUIRE(integrator->advance_to(10));
  const Model::State end{integrator->state()};
  Model::Energy energy;
  model.energy(10, end, energy);
  const Array& y = end.values;
  return {std::abs(std::hypot(y[0], y[1]) - 1), std::abs(y[0] * y[2] + y[1] * y[3]),
          std::abs(energy.total - -0.6 * 9.81)};
}

std::string why_refused(const std::string& method, const Model& model, const Array& start, Projection how) {
  MethodSettings<double> settings;
  settings.projection = how;
  std::string why;
  const auto integrator = make_integrator(method, model, start, 0.0, settings, why);
  if (integrator == nullptr) return why;
  CHECK_FALSE(integrator->advance_to(1));
  CHECK(integrator->time() == 0);
  return integrator->progress().why;
}

constexpr double k_rounding = 1e-13, k_drift = 1e-9;

}  // namespace

TEST_CASE("each level of projection holds what it is of, and leaves the rest to drift") {
  for (const char* const method : {"rk4", "prince87", "bulirsch_stoer", "arkode_dormand_prince", "cvode_bdf"}) {
    if (!gausssim::find_method(method)->missing.empty()) continue;
    INFO(method);
    const Misses off = misses_after_ten(method, Projection::off);
    CHECK(off.position > k_drift);
    CHECK(off.speed > k_drift);
    const Misses full = misses_after_ten(method, Projection::full);
    CHECK(full.position < k_rounding);
    CHECK(full.speed < k_rounding);
    CHECK(full.energy > k_drift);
    const Misses positions = misses_after_ten(method, Projection::positions);
    CHECK(positions.position < k_rounding);
    CHECK(positions.speed > k_drift);
    const Misses velocities = misses_after_ten(method, Projection::velocities);
    CHECK(velocities.position > k_drift);
    CHECK(velocities.speed < k_rounding);
    const Misses energy = misses_after_ten(method, Projection::energy);
    CHECK(energy.position < k_rounding);
    CHECK(energy.speed < k_rounding);
    CHECK(energy.energy < full.energy / 10);
  }
}

TEST_CASE("what the model lacks for a projection is said, and nothing is integrated") {
  const Model free(Kepler<double>::functions());
  const Array start = Kepler<double>::at(0);
  CHECK_THAT(why_refused("rk4", free, start, Projection::positions), Catch::Contains("no equations of positions"));
  CHECK_THAT(why_refused("rk4", free, start, Projection::velocities), Catch::Contains("no constraints"));
  auto damped = Bob<double>::functions();
  damped->energy_layout.is_conserved = false;
  CHECK_THAT(why_refused("rk4", Model(damped), Bob<double>::start(), Projection::energy),
             Catch::Contains("may change"));
}

TEST_CASE("symplectic methods say so where accelerations depend on speeds") {
  const Model bob(Bob<double>::functions());
  int refused = 0;
  for (const auto& method : gausssim::methods()) {
    if (!method.is_separable) continue;
    INFO(method.name);
    CHECK_THAT(why_refused(method.name, bob, Bob<double>::start(), Projection::full),
               Catch::Contains("coordinates alone"));
    ++refused;
  }
  CHECK(refused == 3);
}

TEST_CASE("an implicit step that is too long says so") {
  MethodSettings<double> settings;
  settings.step = 3;
  std::string why;
  const Model bob(Bob<double>::functions());
  const auto integrator = make_integrator("gauss_legendre4", bob, Bob<double>::start(), 0.0, settings, why);
  REQUIRE(integrator != nullptr);
  CHECK_FALSE(integrator->advance_to(3));
  CHECK_THAT(integrator->progress().why, Catch::Contains("too long"));
}

TEST_CASE("a method that is not there, or not in this number type, is refused with a reason") {
  const Model bob(Bob<double>::functions());
  CHECK_THAT(why_refused("euler", bob, Bob<double>::start(), Projection::full), Catch::Contains("no method 'euler'"));
  const gausssim::MotionModel<long double> wide(Bob<long double>::functions());
  for (const auto& method : gausssim::methods()) {
    if (method.has_long_double && method.missing.empty()) continue;
    std::string why;
    const auto made =
        make_integrator(method.name, wide, Bob<long double>::start(), 0.0L, MethodSettings<long double>{}, why);
    CHECK(made == nullptr);
    CHECK_THAT(why, Catch::Contains(method.missing.empty() ? "in double" : "not built in"));
  }
}
