#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

template <class S>
Made<S> make_cash_karp54(const Problem<S>& problem) {
  using Array = Numbers<S>;
  return make_adaptive<S, boost::numeric::odeint::runge_kutta_cash_karp54<Array, S, Array, S>>(problem);
}

template Made<double> make_cash_karp54(const Problem<double>&);
template Made<long double> make_cash_karp54(const Problem<long double>&);

}  // namespace gausssim
