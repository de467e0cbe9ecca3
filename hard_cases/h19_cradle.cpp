// Impacts at one instant: five balls in a row that touch. Taken one after the other, the result depends on which is first in the file.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "registry.hpp"
#include "simulated.hpp"

namespace hard_cases {

namespace {

constexpr std::size_t k_balls = 5;
using Velocities = std::array<double, k_balls>;

/// Each contact once, in this order: equal masses exchange their velocities where they approach.
Velocities one_after_the_other(const std::array<std::size_t, k_balls - 1>& order) {
  Velocities v{1, 0, 0, 0, 0};
  for (const std::size_t contact : order)
    if (v[contact] > v[contact + 1]) std::swap(v[contact], v[contact + 1]);
  return v;
}

Velocities end_of(const Simulated& run) {
  Velocities v{};
  for (std::size_t i = 0; i < k_balls; ++i)
    v[i] = run.exit_code == 0 ? run.last("x" + std::to_string(i + 1) + "_dot") : k_breaks_down;
  return v;
}

double difference(const Velocities& a, const Velocities& b) {
  double most = 0;
  for (std::size_t i = 0; i < k_balls; ++i) grow(most, a[i] - b[i]);
  return most;
}

}  // namespace

std::vector<Figure> cradle(const Scope&) {
  const double naive = difference(one_after_the_other({0, 1, 2, 3}), one_after_the_other({3, 2, 1, 0}));
  const Simulated first = simulated("hard_cases/models/regimes/cradle.yaml", "--duration 3");
  const Simulated turned = simulated("hard_cases/models/regimes/cradle_permuted.yaml", "--duration 3");
  double momentum = first.exit_code == 0 ? 0 : k_breaks_down, energy = momentum;
  const auto column = first.table.find("t");
  for (std::size_t k = 0; column != first.table.end() && k < column->second.size(); ++k) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < k_balls; ++i) {
      const double v = first.table.at("x" + std::to_string(i + 1) + "_dot")[k];
      sum += v;
      squares += v * v;
    }
    grow(momentum, sum - 1);
    grow(energy, squares - 1);
  }
  // All gaps at once, by Moreau's law: -3/5 of its velocity for the first, 2/5 for each of the others.
  const double law = difference(end_of(first), {-0.6, 0.4, 0.4, 0.4, 0.4});
  return {
      {"H19.order", "velocities behind the impact, entries in another order (naive: one contact after the other)",
       "m/s", naive, difference(end_of(first), end_of(turned)), 1e-13, 0, first.seconds + turned.seconds},
      {"H19.law", "velocities beside the law for all that touch", "m/s", std::nullopt, law, 1e-13, 0, first.seconds},
      {"H19.momentum", "momentum over its size", "1", std::nullopt, momentum, 1e-13, 0, first.seconds},
      {"H19.energy", "energy over its size, restitution 1", "1", std::nullopt, energy, 1e-12, 0, first.seconds}};
}

}  // namespace hard_cases
