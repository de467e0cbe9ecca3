// A block that friction holds, for a thousand seconds: a law of slip that is 0 at rest lets it creep.

#include <algorithm>
#include <cmath>
#include <string>

#include "registry.hpp"
#include "simulated.hpp"

namespace hard_cases {

namespace {

constexpr const char* k_block = "scenes/models/block_on_incline.yaml";
constexpr double k_g = 9.81, k_mu = 0.5;
const double k_slope = std::acos(-1.0) / 9;  // 20 degrees

/// mu m g cos(alpha) tanh(v/v_s) against slip: how far it is after so many seconds. Steps of Euler are stable below 2 v_s/(mu g cos(alpha)).
double creep(double v_s, double duration, double& seconds) {
  const Stopwatch watch;
  const double step = 0.5 * v_s / (k_mu * k_g * std::cos(k_slope));
  double x = 0, v = 0;
  for (double t = 0; t < duration; t += step) {
    x += step * v;
    v += step * k_g * (std::sin(k_slope) - k_mu * std::cos(k_slope) * std::tanh(v / v_s));
  }
  seconds = watch.seconds();
  return x;
}

double farthest(const Simulated& run) {
  double most = run.exit_code == 0 && !run.table.empty() ? 0 : k_breaks_down;
  for (const char* column : {"x", "z", "x_dot", "z_dot"}) {
    const auto found = run.table.find(column);
    if (found == run.table.end()) return k_breaks_down;
    for (const double value : found->second) grow(most, value);
  }
  return most;
}

/// Friction of tan(alpha) less or more a part of it, for 10 s.
Simulated beside_threshold(const char* part) {
  return simulated(k_block, std::string("--duration 10 --samples 2 --set 'mu=tan(pi/9)*(1 + ") + part + ")'");
}

}  // namespace

std::vector<Figure> stick(const Scope&) {
  double seconds = 0;
  const double naive = creep(1e-3, 1000, seconds);
  const Simulated held = simulated(k_block, "--duration 1000");
  const Simulated more = beside_threshold("1e-9"), less = beside_threshold("-1e-9");
  const double way = 1e-9 * k_g * std::sin(k_slope) * 50;  // (sin - mu cos) g t^2/2
  const bool slides = less.exit_code == 0 && std::abs(less.last("x") / way - 1) < 1e-6;
  return {
      {"H16.stick", "way of a block on 20 degrees, mu 0.5, in 1000 s (naive: tanh(v/v_s), v_s 1 mm/s)", "m", naive,
       farthest(held), 0, seconds, held.seconds},
      {"H16.begins", "of 2 runs with mu 1e-9 of it above and below tan(alpha), those that do not stay or slide", "1",
       std::nullopt, (farthest(more) == 0 ? 0.0 : 1.0) + (slides ? 0.0 : 1.0), 0, 0, more.seconds + less.seconds}};
}

}  // namespace hard_cases
