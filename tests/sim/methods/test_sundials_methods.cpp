// The methods of SUNDIALS: the order of each table that is offered, stiff models, whose Jacobian it is.
#include <arkode/arkode_erkstep.h>

#include "orders.hpp"
#include "sim/methods/arkode_tables.hpp"

namespace {

using gausssim::Arkode;
using gausssim::ArkodeTable;
using gausssim::make_integrator;
using gausssim::MethodSettings;
using gausssim::Projection;
using problems::Driven;
using problems::Kepler;
using problems::Relaxation;
using Model = gausssim::MotionModel<double>;

/// ARKODE's tables in steps of one length, over 2 s.
template <class On>
double error_after(const ArkodeTable& table, int steps) {
  gauss::simulate::Settings<double> settings;
  settings.tolerance = 1e-14;  // of Newton's method
  settings.project = false;
  Arkode run(Model(On::functions()), On::at(0), 0, settings, table, 2.0 / steps);
  REQUIRE(run.advance_to(2));
  CHECK(run.progress().steps >= steps);
  CHECK(run.progress().steps <= steps + 1);
  return problems::distance(run.state(), On::at(2));
}

template <class On>
double order(const ArkodeTable& table, int steps) {
  return std::log2(error_after<On>(table, steps) / error_after<On>(table, 2 * steps));
}

int steps_for(int order) {
  return order == 2 ? 800 : order == 3 ? 400 : order == 4 ? 200 : order == 5 ? 100 : order == 6 ? 50 : 24;
}

gausssim::Progress<double> relaxed(const std::string& method, bool has_jacobian, double& error) {
  auto functions = Relaxation<double>::functions();
  if (!has_jacobian) functions->jacobian = {};
  MethodSettings<double> settings;
  settings.tolerance = 1e-6;
  settings.projection = Projection::off;
  std::string why;
  const auto integrator = make_integrator(method, Model(functions), Relaxation<double>::at(0), 0.0, settings, why);
  INFO(method << ": " << why);
  REQUIRE(integrator != nullptr);
  CHECK(integrator->advance_to(10));
  error = problems::distance(integrator->state(), Relaxation<double>::at(10));
  return integrator->progress();
}

}  // namespace

TEST_CASE("each table of ARKODE that is offered has the order that it claims") {
  for (const auto& named : gausssim::arkode_tables()) {
    const int steps = steps_for(named.order);
    const double in_place = order<Kepler<double>>(named.table, steps);
    const double in_time = order<Driven<double>>(named.table, steps / 2);
    CAPTURE(named.method, in_place, in_time);
    CHECK(in_place == Approx(named.order).margin(0.3));
    CHECK(in_time == Approx(named.order).margin(0.3));
    CHECK(gausssim::find_method(named.method)->order == named.order);
  }
}

namespace {

int rates(sunrealtype t, N_Vector y, N_Vector result, void*) {
  void* arguments[] = {&t, N_VGetArrayPointer(y), N_VGetArrayPointer(result)};
  return Driven<double>::rates(nullptr, arguments);
}

/// By ERKStep, the other module of ARKODE with these tables.
double erkstep_error(ARKODE_ERKTableID table, int steps) {
  gauss::integrate::sundials::Workspace work(2);
  N_Vector y = work.state.get();
  const auto start = Driven<double>::at(0);
  std::copy(start.begin(), start.end(), N_VGetArrayPointer(y));
  void* erk = ERKStepCreate(rates, 0, y, work.context.get());
  ERKStepSetTableNum(erk, table);
  ERKStepSetFixedStep(erk, 2.0 / steps);
  ERKStepSetStopTime(erk, 2);
  double t = 0;
  CHECK(ERKStepEvolve(erk, 2, y, &t, ARK_NORMAL) >= 0);
  ERKStepFree(&erk);
  const double* const values = N_VGetArrayPointer(y);
  return problems::distance(gausssim::Numbers<double>(values, values + 2), Driven<double>::at(2));
}

double erkstep_order(ARKODE_ERKTableID table) {
  return std::log2(erkstep_error(table, 100) / erkstep_error(table, 200));
}

}  // namespace

TEST_CASE(
    "ERKStep of SUNDIALS 6.4.1 loses the order of tables that ARKStep keeps: why explicit methods go by ARKStep") {
  if (SUNDIALS_VERSION_MINOR != 4) return;
  const double verner = erkstep_order(ARKODE_VERNER_8_5_6), ark548 = erkstep_order(ARKODE_ARK548L2SA_ERK_8_4_5),
               sayfy = erkstep_order(ARKODE_SAYFY_ABURUB_6_3_4);
  CAPTURE(verner, ark548, sayfy);
  CHECK(verner < 4);
  CHECK(ark548 < 4);
  CHECK(sayfy < 3);
  CHECK(order<Driven<double>>({ARKODE_DIRK_NONE, ARKODE_SAYFY_ABURUB_6_3_4}, 100) == Approx(4).margin(0.3));
}

TEST_CASE(
    "stiff methods take few calls for what decays a million times faster than it moves, with and without a Jacobian") {
  for (const auto& method : gausssim::methods()) {
    if (!method.is_stiff) continue;
    INFO(method.name);
    double error = 1;
    const auto emitted = relaxed(method.name, true, error);
    CHECK(error < 1e-3);
    CHECK(emitted.calls < 100'000);  // of explicit ones: twelve for each three millionths of a second
    CHECK(emitted.jacobians > 0);
    const auto differences = relaxed(method.name, false, error);
    CHECK(error < 1e-3);
    CHECK(differences.jacobians == 0);
    CHECK(differences.calls < 100'000);
  }
}

// With the matrix of a step of another length, ARKODE left errors of thousands of tolerances: see arkode.cpp.
TEST_CASE("stiff methods keep their accuracy at each of many times at which a step is cut off to arrive") {
  using problems::Pulled;
  for (const auto& method : gausssim::methods()) {
    if (!method.is_stiff) continue;
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8}) {
      MethodSettings<double> settings;
      settings.tolerance = tolerance;
      settings.projection = Projection::off;
      std::string why;
      const auto integrator =
          make_integrator(method.name, Model(Pulled<double>::functions()), Pulled<double>::at(0), 0.0, settings, why);
      REQUIRE(integrator != nullptr);
      double largest = 0;
      for (int k = 1; k <= 500; ++k) {
        REQUIRE(integrator->advance_to(0.02 * k));
        largest = std::max(largest, problems::distance(integrator->state(), Pulled<double>::at(0.02 * k)));
      }
      const long steps = integrator->progress().steps;
      CAPTURE(method.name, tolerance, largest, steps);
      CHECK(largest < 50 * tolerance);
      CHECK(steps < 50'000);
    }
  }
}
