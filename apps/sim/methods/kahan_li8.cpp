#include "gauss/integrate/symmetric_composition.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_kahan_li8(const Problem<S>& problem) {
  return make_fixed<S, gauss::integrate::SymmetricComposition<MotionModel<S>>>(problem, 17);
}

template Made<double> make_kahan_li8(const Problem<double>&);
template Made<long double> make_kahan_li8(const Problem<long double>&);

}  // namespace gausssim
