#include "gauss/integrate/nystrom_stepper.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_verlet(const Problem<S>& problem) {
  return make_fixed<S, gauss::integrate::Verlet<MotionModel<S>>>(problem, 1);
}

template Made<double> make_verlet(const Problem<double>&);
template Made<long double> make_verlet(const Problem<long double>&);

}  // namespace gausssim
