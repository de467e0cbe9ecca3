#pragma once

#include "sim/drive/fixed.hpp"
#include "sim/drive/odeint_numbers.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

/// `calls_in_a_step`: of rates, for methods that take the same number each time.
template <class S, class Stepper>
Made<S> make_fixed(const Problem<S>& problem, long calls_in_a_step = 0) {
  return std::make_unique<Fixed<S, Stepper>>(problem.model, problem.start, problem.t, problem.settings.step,
                                             settings_of(problem), calls_in_a_step);
}

}  // namespace gausssim
