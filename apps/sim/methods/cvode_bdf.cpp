#include "sim/methods/cvode.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

Made<double> make_cvode_bdf(const Problem<double>& problem) {
  return std::make_unique<Cvode>(problem.model, problem.start, problem.t, settings_of(problem),
                                 gauss::simulate::Multistep::bdf);
}

}  // namespace gausssim
