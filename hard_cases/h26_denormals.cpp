// A motion that decays through the smallest numbers there are, which some processors are slow with.

#include <algorithm>
#include <cmath>

#include "decaying.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Decaying, gauss::decaying);

namespace {

constexpr int k_blocks = 100, k_steps = 2000, k_repetitions = 9;

struct Decay {
  double slowest = k_breaks_down;  ///< block of steps, by the median
  int denormal = 0;                ///< blocks that end with a denormal number, not 0
};

/// Each block's shortest time of several runs, since other programs only make it longer.
Decay decay() {
  const auto prepared = Decaying::prepare(gauss::decaying::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<Decaying>(prepared, gauss::decaying::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  const gauss::decaying::State<double> start{{1e-280, -2e-280, 0, 0}};
  std::vector<double> times(k_blocks, k_breaks_down);
  Decay result;
  for (int repetition = 0; repetition < k_repetitions; ++repetition) {
    gauss::simulate::FixedStep<Model, gauss::integrate::Rk4<Model>> run(model, start, 2e-4);
    result.denormal = 0;
    for (double& time : times) {
      Stopwatch stopwatch;
      if (!run.advance(k_steps)) return {};
      time = std::min(time, stopwatch.seconds());
      if (std::fpclassify(run.state().values[0]) == FP_SUBNORMAL) ++result.denormal;
    }
  }
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  result.slowest = result.denormal > 0 ? sorted.back() / sorted[k_blocks / 2] : k_breaks_down;
  return result;
}

}  // namespace

std::vector<Figure> denormals(const Scope&) {
  Stopwatch stopwatch;
  const Decay found = decay();
  return {{"H26.slowest", "slowest 2000 steps of a decay through denormal numbers, by the median", "1", std::nullopt,
           found.slowest, 3, 0, stopwatch.seconds(), std::to_string(found.denormal) + " of 100 blocks end with one"}};
}

}  // namespace hard_cases
