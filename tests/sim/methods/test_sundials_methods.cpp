// The methods of SUNDIALS: the order of each table that is offered, stiff models, whose Jacobian it is.
#include "orders.hpp"
#include "sim/methods/arkode_tables.hpp"

namespace {

using gausssim::Arkode;
using gausssim::ArkodeTable;
using problems::Kepler;
using problems::Relaxation;
using Model = MotionModel<double>;

/// ARKODE's tables in steps of one length, over 2 s.
double error_after(const ArkodeTable& table, int steps) {
  gauss::simulate::Settings<double> settings;
  settings.tolerance = 1e-14;  // of Newton's method
  settings.project = false;
  Arkode run(Model(Kepler<double>::functions()), Kepler<double>::at(0), 0, settings, table, 2.0 / steps);
  REQUIRE(run.advance_to(2));
  CHECK(run.progress().steps >= steps);
  CHECK(run.progress().steps <= steps + 1);
  return problems::distance(run.state(), Kepler<double>::at(2));
}

double order(const ArkodeTable& table, int steps) {
  return std::log2(error_after(table, steps) / error_after(table, 2 * steps));
}

int steps_for(int order) { return order == 2 ? 800 : order == 3 ? 400 : order == 4 ? 200 : order == 5 ? 100 : 40; }

gausssim::Progress<double> relaxed(const std::string& method, bool has_jacobian, double& error) {
  auto functions = Relaxation<double>::functions();
  if (!has_jacobian) functions->jacobian = {};
  MethodSettings<double> settings;
  settings.tolerance = 1e-6;
  settings.projection = Projection::off;
  std::string why;
  const auto integrator =
      make_integrator(method, Model(functions), Relaxation<double>::at(0), 0.0, settings, why);
  INFO(method << ": " << why);
  REQUIRE(integrator != nullptr);
  CHECK(integrator->advance_to(10));
  error = problems::distance(integrator->state(), Relaxation<double>::at(10));
  return integrator->progress();
}

}  // namespace

TEST_CASE("each table of ARKODE that is offered has the order that it claims") {
  for (const auto& named : gausssim::arkode_tables()) {
    INFO(named.method);
    CHECK(order(named.table, steps_for(named.order)) == Approx(named.order).margin(0.3));
    CHECK(gausssim::find_method(named.method)->order == named.order);
  }
}

TEST_CASE("tables of ARKODE 6.4.1 that are not offered do not have the order of their names") {
  const auto of = [](ARKODE_ERKTableID id) { return order({ARKODE_DIRK_NONE, id}, 100); };
  CHECK(of(ARKODE_VERNER_8_5_6) < 4);
  CHECK(of(ARKODE_ARK548L2SA_ERK_8_4_5) < 4);
  CHECK(of(ARKODE_SAYFY_ABURUB_6_3_4) < 3);
}

TEST_CASE("stiff methods take few steps for what decays a million times faster than it moves, with and without a Jacobian") {
  for (const auto& method : gausssim::methods()) {
    if (!method.is_stiff) continue;
    INFO(method.name);
    double error = 1;
    const auto emitted = relaxed(method.name, true, error);
    CHECK(error < 1e-3);
    CHECK(emitted.steps < 5000);
    CHECK(emitted.jacobians > 0);
    const auto differences = relaxed(method.name, false, error);
    CHECK(error < 1e-3);
    CHECK(differences.jacobians == 0);
    CHECK(differences.calls > emitted.calls);
  }
}
