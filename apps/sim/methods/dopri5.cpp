#include "sim/methods/dopri5.hpp"

namespace gausssim {

template <class S>
Made<S> make_dopri5(const Problem<S>& problem) {
  return make_adaptive<S, Dopri5>(problem);
}

template Made<float> make_dopri5(const Problem<float>&);
template Made<double> make_dopri5(const Problem<double>&);
template Made<long double> make_dopri5(const Problem<long double>&);

}  // namespace gausssim
