#pragma once

#include "sim/drive/adaptive.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

template <class S, class Method>
Made<S> make_adaptive(const Problem<S>& problem) {
  gauss::simulate::Settings<S> settings;
  settings.tolerance = problem.settings.tolerance;
  settings.longest_step = problem.settings.longest_step;
  settings.most_steps = problem.settings.most_steps;
  settings.project = problem.settings.projection != Projection::off && problem.model.functions().projection;
  return std::make_unique<Adaptive<S, Method>>(problem.model, problem.start, problem.t, settings);
}

}  // namespace gausssim
