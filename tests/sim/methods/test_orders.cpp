// What methods claim of themselves: the order of those with steps of one length, and errors that follow the tolerance of the others.
#include "orders.hpp"

using namespace orders;
using gausssim::MethodInfo;
using gausssim::methods;

namespace {

/// So many that the error is that of the order, and above rounding.
long steps_for(int order) { return order == 2 ? 800 : order == 4 ? 200 : order == 6 ? 64 : 48; }

bool is_built_in(const MethodInfo& method) { return method.missing.empty(); }

}  // namespace

TEST_CASE("each method with steps of one length has the order that it claims") {
  int measured = 0;
  for (const MethodInfo& method : methods()) {
    if (!method.takes_step) continue;
    INFO(method.name);
    CHECK(order_in_kepler<double>(method.name, 2, steps_for(method.order)) == Approx(method.order).margin(0.25));
    CHECK(order_in_kepler<long double>(method.name, 2, steps_for(method.order)) == Approx(method.order).margin(0.25));
    ++measured;
  }
  CHECK(measured == 7);
}

TEST_CASE("errors of each method with a tolerance are proportional to it, over six decades") {
  int measured = 0;
  for (const MethodInfo& method : methods()) {
    if (method.takes_step || !is_built_in(method)) continue;
    INFO(method.name);
    // Few steps of a high order are no proportion yet, and those of a low order are many.
    const bool is_low = method.order <= 3;
    const double decades = decades_for_each<double>(method.name, is_low ? 1e-3 : 1e-4, is_low ? 1e-8 : 1e-10);
    CHECK(decades > 0.75);
    CHECK(decades < 1.3);
    ++measured;
  }
  CHECK(measured >= 5);
}

TEST_CASE("long double takes over where double ends") {
  for (const MethodInfo& method : methods()) {
    if (method.takes_step || !method.has_long_double || !is_built_in(method) || method.order < 8) continue;
    INFO(method.name);
    MethodSettings<long double> settings;
    settings.projection = Projection::off;
    settings.tolerance = 1e-17L;
    CHECK(error_of<problems::Kepler<long double>>(method.name, settings, 6.0L) < 1e-15L);
  }
}
