#pragma once
// Errors of methods by their steps and tolerances.

#include <cmath>
#include <string>

#include "catch_shim.hpp"
#include "problems.hpp"

namespace orders {

using gausssim::MethodSettings;
using gausssim::MotionModel;
using gausssim::Projection;

template <class Problem, class S>
S error_of(const std::string& method, const MethodSettings<S>& settings, S end) {
  std::string why;
  const MotionModel<S> model(Problem::functions());
  const auto integrator = make_integrator(method, model, Problem::at(0), S(0), settings, why);
  INFO(method << ": " << why);
  REQUIRE(integrator != nullptr);
  REQUIRE(integrator->advance_to(end));
  CHECK(integrator->time() == end);
  return problems::distance(integrator->state(), Problem::at(end));
}

/// By halving the step.
template <class Problem, class S>
double order_in(const std::string& method, S end, long steps) {
  MethodSettings<S> settings;
  settings.projection = Projection::off;
  settings.step = end / S(steps);
  const S coarse = error_of<Problem>(method, settings, end);
  settings.step /= 2;
  return static_cast<double>(std::log2(coarse / error_of<Problem>(method, settings, end)));
}

/// Decades of the error for each decade of the tolerance, from `loose` to `tight`.
template <class S>
double decades_for_each(const std::string& method, S loose, S tight) {
  MethodSettings<S> settings;
  settings.projection = Projection::off;
  const S end = 20;
  settings.tolerance = loose;
  const S large = error_of<problems::Kepler<S>>(method, settings, end);
  settings.tolerance = tight;
  const S small = error_of<problems::Kepler<S>>(method, settings, end);
  UNSCOPED_INFO(method << ": " << large << " at " << loose << ", " << small << " at " << tight);
  return static_cast<double>(std::log10(large / small) / std::log10(loose / tight));
}

}  // namespace orders
