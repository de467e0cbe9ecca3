#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

// A template, not an alias: g++ 12 takes aliases of one name for the same in all files.
template <class Array, class S>
struct Dopri5 : boost::numeric::odeint::runge_kutta_dopri5<Array, S, Array, S> {};

template <class S>
Made<S> make_dopri5(const Problem<S>& problem) {
  return make_adaptive<S, Dopri5>(problem);
}

template Made<float> make_dopri5(const Problem<float>&);
template Made<double> make_dopri5(const Problem<double>&);
template Made<long double> make_dopri5(const Problem<long double>&);

}  // namespace gausssim
