#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

// A template, not an alias: g++ 12 takes aliases of one name for the same in all files.
template <class Array, class S>
struct CashKarp54 : boost::numeric::odeint::runge_kutta_cash_karp54<Array, S, Array, S> {};

template <class S>
Made<S> make_cash_karp54(const Problem<S>& problem) {
  return make_adaptive<S, CashKarp54>(problem);
}

template Made<double> make_cash_karp54(const Problem<double>&);
template Made<long double> make_cash_karp54(const Problem<long double>&);

}  // namespace gausssim
