#pragma once

#include <type_traits>

#include "sim/drive/adaptive.hpp"
#include "sim/drive/odeint_numbers.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

namespace detail {

template <class S, template <class, class> class Method, class Array>
Made<S> made_adaptive(const Problem<S>& problem) {
  using Result = Adaptive<S, Method<Array, S>, Array>;
  return std::make_unique<Result>(problem.model, problem.start, problem.t, settings_of(problem));
}

}  // namespace detail

/// `Method` of arrays and numbers. Small models in double, whose functions cost as little as a loop does, have arrays of a size that compilers know.
template <class S, template <class, class> class Method>
Made<S> make_adaptive(const Problem<S>& problem) {
  if constexpr (std::is_same_v<S, double>) {
    const std::size_t size = problem.start.size();
    if (size <= 4) return detail::made_adaptive<S, Method, InPlace<S, 4>>(problem);
    if (size <= 8) return detail::made_adaptive<S, Method, InPlace<S, 8>>(problem);
    if (size <= 12) return detail::made_adaptive<S, Method, InPlace<S, 12>>(problem);
  }
  return detail::made_adaptive<S, Method, Numbers<S>>(problem);
}

}  // namespace gausssim
