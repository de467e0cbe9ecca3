#pragma once

#include "sim/drive/adaptive.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

template <class S, class Method>
Made<S> make_adaptive(const Problem<S>& problem) {
  return std::make_unique<Adaptive<S, Method>>(problem.model, problem.start, problem.t, settings_of(problem));
}

}  // namespace gausssim
