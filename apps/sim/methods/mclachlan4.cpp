#include "gauss/integrate/nystrom_stepper.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_mclachlan4(const Problem<S>& problem) {
  return make_fixed<S, gauss::integrate::McLachlan4<MotionModel<S>>>(problem, 5);
}

template Made<double> make_mclachlan4(const Problem<double>&);
template Made<long double> make_mclachlan4(const Problem<long double>&);

}  // namespace gausssim
