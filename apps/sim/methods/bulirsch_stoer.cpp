#include "sim/methods/bulirsch_stoer.hpp"

#include "sim/methods/settings.hpp"

namespace gausssim {

template <class S>
Made<S> make_bulirsch_stoer(const Problem<S>& problem) {
  return std::make_unique<BulirschStoer<S>>(problem.model, problem.start, problem.t, settings_of(problem));
}

template Made<double> make_bulirsch_stoer(const Problem<double>&);
template Made<long double> make_bulirsch_stoer(const Problem<long double>&);

}  // namespace gausssim
