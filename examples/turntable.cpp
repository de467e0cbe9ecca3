// A ball rolls on a table that turns: generated code, simulated, with the force of the table beside the motion.

#include <cstdio>

#include "gauss/simulate/simulation.hpp"
#include "sphere_turntable.hpp"

namespace ball = gauss::sphere_turntable;
GAUSS_MODEL(Ball, gauss::sphere_turntable);  // the emitted namespace as a type, for templates

int main() {
  const ball::Parameters<double> parameters;  // the values of the model file; change them here
  const ball::Prepared<double> prepared = ball::prepare(parameters);
  const ball::Inputs<double> inputs{};
  ball::State<double> start;
  if (ball::initial_state(prepared, start) != gauss::Status::ok) return 1;

  // Each step is projected: the ball rolls without slip, and its quaternion stays of unit length, for as long as you like.
  gauss::simulate::Simulation simulation(gauss::integrate::bind_model<Ball>(prepared, inputs), start);

  std::puts("  t [s]    x [m]    y [m]  F_x [N]  F_y [N]  F_z [N]   force of the table on the ball");
  for (int k = 0; k <= 16; ++k) {
    const double t = 0.5 * k;
    if (!simulation.advance_to(t)) {
      std::printf("stopped at t = %g s: %s\n", simulation.time(), name(simulation.report().outcome));
      return 1;
    }
    const ball::State<double> state = simulation.state();
    ball::ReactionForces<double> forces;
    const gauss::Status status = reaction_forces(t, state, inputs, prepared, forces);
    if (status != gauss::Status::ok) {
      std::printf("no forces at t = %g s: %s\n", t, name(status));
      return 1;
    }
    const double(&force)[3] = forces.on_ball.force;
    std::printf("%7.2f %8.4f %8.4f %8.4f %8.4f %8.4f\n", t, state.x(), state.y(), force[0], force[1], force[2]);
  }
}
