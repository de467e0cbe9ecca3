// A pendulum in x and y swings for a thousand seconds in steps of 5 ms, with its bar and its energy kept; `long_swing` prints what corrections did.
#include <cmath>
#include <cstdio>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_cartesian.hpp"

GAUSS_MODEL(Pendulum, gauss::pendulum_cartesian);

int main() {
  namespace integrate = gauss::integrate;
  const auto prepared = Pendulum::prepare(gauss::pendulum_cartesian::Parameters<double>{});
  const auto model = integrate::bind_model<Pendulum>(prepared, gauss::pendulum_cartesian::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  using Energy = gauss::pendulum_cartesian::Energy<double>;

  gauss::pendulum_cartesian::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return 1;

  // From the inside out: a step, back onto the constraint, back to the energy of the start.
  using Stepper = integrate::EnergyKept<integrate::Projected<integrate::Rk4<Model>>, Energy>;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, 0.005);
  std::printf("     t      bar off     energy off\n");
  for (int line = 1; line <= 10; ++line) {
    if (!run.advance(20'000)) {
      std::printf("at %g s: %s\n", run.time(), name(run.last().outcome));
      return 1;
    }
    Energy energy;
    model.energy(run.time(), run.state(), energy);
    const double bar = std::hypot(run.state().x(), run.state().y()) - 1;
    std::printf("%6.0f s %9.1e m %12.1e J\n", run.time(), bar, energy.total - run.stepper().level());
  }
  const auto& projected = run.stepper().inner().correction();
  const auto& kept = run.stepper().correction();
  std::printf("largest correction: %.1e m or m/s by projection, %.1e of the speeds for the energy\n", projected.largest,
              kept.largest);
  std::printf("%ld steps were left alone, where the bob was too slow to make up for the energy\n", kept.left_alone);
}
