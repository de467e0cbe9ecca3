#include "gauss/integrate/radau.hpp"

#include "sim/drive/adaptive.hpp"
#include "sim/drive/odeint_numbers.hpp"
#include "sim/methods/makers.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

template <class S>
Made<S> make_radau(const Problem<S>& problem) {
  // Arrays as long as the state: the costs of a step go with its third power.
  using Result = Adaptive<S, gauss::integrate::RadauIIA<Numbers<S>, S>, Numbers<S>>;
  return std::make_unique<Result>(problem.model, problem.start, problem.t, settings_of(problem));
}

template Made<float> make_radau(const Problem<float>&);
template Made<double> make_radau(const Problem<double>&);
template Made<long double> make_radau(const Problem<long double>&);

}  // namespace gausssim
