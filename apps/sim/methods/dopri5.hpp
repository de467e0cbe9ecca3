#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

// A template, not an alias: g++ 12 takes aliases of one name for the same in all files.
template <class Array, class S>
struct Dopri5 : boost::numeric::odeint::runge_kutta_dopri5<Array, S, Array, S> {};

}  // namespace gausssim
