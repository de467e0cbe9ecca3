#pragma once
// Integrates an emitted model from sample to sample.

#include "catch_shim.hpp"
#include "gauss/simulate/simulation.hpp"
#include "reference.hpp"

namespace physics {

/// `check(sample, t, state)` at the time `t` of each sample.
template <class Model, class Check>
void follow(const reference::Json& samples, const typename Model::template Prepared<double>& prepared,
            const typename Model::template Inputs<double>& inputs, const typename Model::template State<double>& start,
            Check&& check) {
  const auto model = gauss::integrate::bind_model<Model>(prepared, inputs);
  gauss::simulate::Simulation simulation(model, start);
  for (const reference::Json& sample : samples) {
    const double t = reference::number(sample["t"]);
    INFO("t = " << t);
    const bool arrives = simulation.advance_to(t);
    const auto& report = simulation.report();
    INFO(gauss::simulate::name(report.outcome) << ", " << name(report.status) << ", " << report.steps << " steps and "
                                               << report.rejected << " rejected");
    REQUIRE(arrives);
    check(sample, t, simulation.state());
  }
}

/// To this, runs at the default tolerance agree with the closed forms; components of order 1 to 100.
constexpr double k_margin = 2e-10;

inline Approx close_to(const reference::Json& value, double scale = 1) {
  return Approx(reference::number(value)).epsilon(0).margin(k_margin * scale);
}

}  // namespace physics
