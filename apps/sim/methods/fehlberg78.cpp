#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

template <class S>
Made<S> make_fehlberg78(const Problem<S>& problem) {
  using Array = Numbers<S>;
  return make_adaptive<S, boost::numeric::odeint::runge_kutta_fehlberg78<Array, S, Array, S>>(problem);
}

template Made<double> make_fehlberg78(const Problem<double>&);
template Made<long double> make_fehlberg78(const Problem<long double>&);

}  // namespace gausssim
