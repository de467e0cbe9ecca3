#include "gauss/integrate/gauss_legendre.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_gauss_legendre2(const Problem<S>& problem) {
  return make_fixed<S, gauss::integrate::GaussLegendre<MotionModel<S>, 1>>(problem);
}

template Made<double> make_gauss_legendre2(const Problem<double>&);
template Made<long double> make_gauss_legendre2(const Problem<long double>&);

}  // namespace gausssim
