#pragma once

#include "gauss/simulate/report.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

/// Of methods with an estimate of their error.
template <class S>
gauss::simulate::Settings<S> settings_of(const Problem<S>& problem) {
  gauss::simulate::Settings<S> settings;
  settings.tolerance = problem.settings.tolerance;
  settings.longest_step = problem.settings.longest_step;
  settings.most_steps = problem.settings.most_steps;
  settings.project = problem.model.projects();
  return settings;
}

}  // namespace gausssim
