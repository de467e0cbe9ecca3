#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

template <class S>
Made<S> make_dopri5(const Problem<S>& problem) {
  using Array = Numbers<S>;
  return make_adaptive<S, boost::numeric::odeint::runge_kutta_dopri5<Array, S, Array, S>>(problem);
}

template Made<float> make_dopri5(const Problem<float>&);
template Made<double> make_dopri5(const Problem<double>&);
template Made<long double> make_dopri5(const Problem<long double>&);

}  // namespace gausssim
