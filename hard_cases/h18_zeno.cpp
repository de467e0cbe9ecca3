// A ball that bounces infinitely often in a finite time, and then is at rest.

#include <cmath>

#include "registry.hpp"
#include "simulated.hpp"

namespace hard_cases {

namespace {

constexpr const char* k_ball = "scenes/models/bouncing_ball.yaml";
constexpr double k_g = 9.81, k_e = 0.9, k_end = 10;

/// Steps of one length, and the velocity turned round where the ball is below the floor: how far below it is at the worst.
double deepest(double& seconds) {
  const Stopwatch watch;
  constexpr double k_step = 1e-3;
  double z = 1, v = 0, depth = 0;
  for (double t = 0; t < k_end; t += k_step) {
    z += k_step * v - 0.5 * k_step * k_step * k_g;
    v -= k_step * k_g;
    if (z < 0) v = k_e * std::abs(v);
    depth = std::fmax(depth, -z);
  }
  seconds = watch.seconds();
  return depth;
}

}  // namespace

std::vector<Figure> zeno(const Scope&) {
  double seconds = 0;
  const double naive = deepest(seconds);
  const Simulated run = simulated(k_ball, "--duration 10 --samples 1001 --tolerance 1e-12");
  double rest = k_breaks_down, hits = 0, depth = run.exit_code == 0 ? 0 : k_breaks_down;
  for (const Happening& one : run.events) {
    if (one.what == "floor hits") hits += 1;
    if (one.what == "floor closed") rest = one.t;
  }
  if (const auto z = run.table.find("z"); z != run.table.end())
    for (const double value : z->second) grow(depth, std::fmin(value, 0.0));
  const double exact = std::sqrt(2 / k_g) * (1 + k_e) / (1 - k_e);
  return {{"H18.rest", "time at which a ball with e = 0.9 that falls from 1 m is at rest, beside 8.578949 s", "s",
           std::nullopt, std::abs(rest - exact), 1e-6, 0, run.seconds},
          {"H18.depth", "how far below the floor it is (naive: steps of 1 ms that turn the velocity round)", "m", naive,
           depth, 1e-12, seconds, run.seconds},
          {"H18.count", "impacts of the infinitely many that are computed", "1", std::nullopt, hits, 300}};
}

}  // namespace hard_cases
