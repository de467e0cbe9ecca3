#pragma once
// One for each method; each in a file of its own, since the steppers of Odeint take compilers long.

#include <memory>

#include "sim/methods/methods.hpp"

namespace gausssim {

template <class S>
struct Problem {
  const MotionModel<S>& model;
  const Numbers<S>& start;
  S t;
  const MethodSettings<S>& settings;
};

template <class S>
using Made = std::unique_ptr<Integrator<S>>;

template <class S>
Made<S> make_prince87(const Problem<S>& problem);
template <class S>
Made<S> make_fehlberg78(const Problem<S>& problem);
template <class S>
Made<S> make_dopri5(const Problem<S>& problem);
template <class S>
Made<S> make_cash_karp54(const Problem<S>& problem);
/// Null where the engine has no series of the model.
template <class S>
Made<S> make_taylor(const Problem<S>& problem);
template <class S>
Made<S> make_rk4(const Problem<S>& problem);

}  // namespace gausssim
