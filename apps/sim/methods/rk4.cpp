#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "gauss/integrate/explicit_stepper.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_rk4(const Problem<S>& problem) {
  constexpr long k_stages = 4;
  return make_fixed<S, gauss::integrate::Rk4<MotionModel<S>>>(problem, k_stages);
}

template Made<float> make_rk4(const Problem<float>&);
template Made<double> make_rk4(const Problem<double>&);
template Made<long double> make_rk4(const Problem<long double>&);

}  // namespace gausssim
