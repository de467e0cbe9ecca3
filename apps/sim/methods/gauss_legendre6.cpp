#include "gauss/integrate/gauss_legendre.hpp"
#include "sim/methods/make_fixed.hpp"

namespace gausssim {

template <class S>
Made<S> make_gauss_legendre6(const Problem<S>& problem) {
  return make_fixed<S, gauss::integrate::GaussLegendre<MotionModel<S>, 3>>(problem);
}

template Made<double> make_gauss_legendre6(const Problem<double>&);
template Made<long double> make_gauss_legendre6(const Problem<long double>&);

}  // namespace gausssim
