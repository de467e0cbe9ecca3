#pragma once

#include "gauss/simulate/report.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

/// Of methods with an estimate of their error. `To`: the number type that the steps are computed in, if it is another class for the same numbers.
template <class S, class To = S>
gauss::simulate::Settings<To> settings_of(const Problem<S>& problem) {
  gauss::simulate::Settings<To> settings;
  settings.tolerance = To(problem.settings.tolerance);
  settings.longest_step = To(problem.settings.longest_step);
  settings.most_steps = problem.settings.most_steps;
  settings.ends = problem.settings.ends;
  settings.crosses_lost_digits = problem.settings.crosses_lost_digits;
  settings.project = problem.model.projects();
  return settings;
}

}  // namespace gausssim
