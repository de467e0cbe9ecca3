#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "gauss/integrate/explicit_stepper.hpp"
#include "sim/drive/fixed.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

template <class S>
Made<S> make_rk4(const Problem<S>& problem) {
  using Stepper = gauss::integrate::Rk4<MotionModel<S>>;
  constexpr long k_stages = 4;
  return std::make_unique<Fixed<S, Stepper>>(problem.model, problem.start, problem.t, problem.settings.step,
                                             problem.settings.projection != Projection::off, k_stages);
}

template Made<double> make_rk4(const Problem<double>&);
template Made<long double> make_rk4(const Problem<long double>&);

}  // namespace gausssim
