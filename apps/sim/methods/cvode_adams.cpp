#include "sim/methods/cvode.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

Made<double> make_cvode_adams(const Problem<double>& problem) {
  return std::make_unique<Cvode>(problem.model, problem.start, problem.t, settings_of(problem),
                                 gauss::simulate::Multistep::adams);
}

}  // namespace gausssim
