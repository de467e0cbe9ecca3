#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

// A template, not an alias: g++ 12 takes aliases of one name for the same in all files.
template <class Array, class S>
struct Fehlberg78 : boost::numeric::odeint::runge_kutta_fehlberg78<Array, S, Array, S> {};

template <class S>
Made<S> make_fehlberg78(const Problem<S>& problem) {
  return make_adaptive<S, Fehlberg78>(problem);
}

template Made<double> make_fehlberg78(const Problem<double>&);
template Made<long double> make_fehlberg78(const Problem<long double>&);

}  // namespace gausssim
