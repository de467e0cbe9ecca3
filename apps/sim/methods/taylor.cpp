#include "sim/drive/quad.hpp"
#include "sim/drive/series.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

template <class S>
Made<S> make_taylor(const Problem<S>& problem) {
  const Functions<S>& functions = problem.model.functions();
  if (!functions.series) return nullptr;
  const typename Series<S>::Settings settings{
      problem.settings.tolerance,  problem.settings.projection != Projection::off && functions.projection,
      problem.settings.most_steps, problem.settings.ends,
      problem.settings.order,      problem.settings.longest_step};
  return std::make_unique<Series<S>>(functions.series, problem.model.shared_functions(), problem.start, problem.t,
                                     settings);
}

template Made<float> make_taylor(const Problem<float>&);
template Made<double> make_taylor(const Problem<double>&);
template Made<long double> make_taylor(const Problem<long double>&);
template Made<Quad> make_taylor(const Problem<Quad>&);

}  // namespace gausssim
