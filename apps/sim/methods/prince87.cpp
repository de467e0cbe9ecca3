#include "sim/methods/make_adaptive.hpp"

namespace gausssim {

template <class S>
Made<S> make_prince87(const Problem<S>& problem) {
  return make_adaptive<S, gauss::integrate::PrinceDormand87>(problem);
}

template Made<float> make_prince87(const Problem<float>&);
template Made<double> make_prince87(const Problem<double>&);
template Made<long double> make_prince87(const Problem<long double>&);

}  // namespace gausssim
