// What methods claim of themselves: the order of those with steps of one length, and errors that follow the tolerance of the others.
#include "orders.hpp"

using namespace orders;
using gausssim::MethodInfo;
using gausssim::methods;

namespace {

/// So few that the error is above rounding, in double, and so many that it is that of the order.
long steps_for(int order) { return order == 2 ? 800 : order == 4 ? 200 : order == 6 ? 64 : 20; }

bool is_built_in(const MethodInfo& method) { return method.missing.empty(); }

}  // namespace

TEST_CASE("each method with steps of one length has the order that it claims") {
  int measured = 0;
  for (const MethodInfo& method : methods()) {
    if (!method.takes_step) continue;
    const long steps = steps_for(method.order);
    const double in_double = order_in<problems::Kepler<double>>(method.name, 2.0, steps);
    const double in_long_double = order_in<problems::Kepler<long double>>(method.name, 2.0L, 2 * steps);
    CAPTURE(method.name, in_double, in_long_double);
    CHECK(in_double == Approx(method.order).margin(0.25));
    CHECK(in_long_double == Approx(method.order).margin(0.25));
    if (!method.is_separable) {
      const double in_time = order_in<problems::Driven<double>>(method.name, 2.0, steps / 2);
      CAPTURE(in_time);
      CHECK(in_time == Approx(method.order).margin(0.25));
    }
    ++measured;
  }
  CHECK(measured == 7);
}

// Series are functions of a plugin, which models by hand do not have: ctest -R taylor_stepping measures their orders, and sim.cli.run their errors.
static bool is_of_plugins(const MethodInfo& method) { return method.name == "taylor"; }

// The error of a step of order q is as h^(q+1), and that of the motion as h^q: for a decade of the tolerance the motion has q/(q+1) of one more.
TEST_CASE("errors of each method with a tolerance follow it over decades") {
  int measured = 0;
  for (const MethodInfo& method : methods()) {
    if (method.takes_step || !is_built_in(method) || is_of_plugins(method)) continue;
    // Few steps of a high order are no proportion yet, and those of a low order are many.
    const bool is_low = method.order <= 3;
    const double decades = decades_for_each<double>(method.name, is_low ? 1e-3 : 1e-4, is_low ? 1e-8 : 1e-10);
    CAPTURE(method.name, decades);
    CHECK(decades > (is_low ? 0.6 : 0.62));
    // Its estimate is of order 5, and the error of order 9.
    CHECK(decades < (method.name == "radau" ? 9 / 6.0 + 0.3 : 1.3));
    ++measured;
  }
  CHECK(measured >= 5);
}

TEST_CASE("long double takes over where double ends") {
  for (const MethodInfo& method : methods()) {
    if (method.takes_step || !method.has_long_double || !is_built_in(method) || method.order < 8) continue;
    if (is_of_plugins(method)) continue;
    INFO(method.name);
    MethodSettings<long double> settings;
    settings.projection = Projection::off;
    settings.tolerance = 1e-17L;
    CHECK(error_of<problems::Kepler<long double>>(method.name, settings, 6.0L) < 1e-15L);
  }
}
