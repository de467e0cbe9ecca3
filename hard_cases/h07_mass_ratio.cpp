// A chain of four rods in coordinates of space, of which the last is 1e3 to 1e12 times as heavy as the others, or as light.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "heavy_chain.hpp"
#include "registry.hpp"
#include "wide.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::heavy_chain;

template <class S>
struct Answer {
  model::Derivative<S> derivative{};
  model::Reactions<S> reactions{};
  gauss::Status status;
};

template <class S>
Answer<S> emitted(const double* y, double ratio) {
  model::Parameters<S> parameters;
  parameters.ratio = ratio;
  model::State<S> state;
  for (int i = 0; i < model::n_q + model::n_v; ++i) state.values[i] = y[i];
  Answer<S> answer;
  answer.status =
      rhs_and_reactions(S(0), state, model::Inputs<S>{}, prepare(parameters), answer.derivative, answer.reactions);
  return answer;
}

}  // namespace

std::vector<Figure> mass_ratio(const Scope&) {
  std::vector<Figure> figures;
  for (const double ratio : {1e3, 1e6, 1e9, 1e12, 1e-3, 1e-6, 1e-9, 1e-12}) {
    double worst = 0, worst_force = 0;
    for (int trial = 0; trial < 50; ++trial) {
      // On the constraints: angles and rates are chosen, places follow.
      double y[model::n_q + model::n_v] = {};
      double x = 0, z = 0, x_dot = 0, z_dot = 0;
      for (int k = 0; k < 4; ++k) {
        const double angle = 0.8 * std::sin(1.7 * trial + k), rate = 2 * std::cos(2.3 * trial + 3 * k), half = 0.35;
        const double c = std::cos(angle), s = std::sin(angle);
        for (int end = 0; end < 2; ++end) {
          // theta turns about y: down the rod is (-sin theta, -cos theta) in (x, z).
          x -= half * s;
          z -= half * c;
          x_dot -= half * c * rate;
          z_dot += half * s * rate;
          if (end == 1) continue;
          const double values[] = {z, x, angle, z_dot, x_dot, rate};
          for (int i = 0; i < 3; ++i) {
            y[3 * k + i] = values[i];
            y[12 + 3 * k + i] = values[3 + i];
          }
        }
      }
      const Answer<double> found = emitted<double>(y, ratio);
      const Answer<Wide> exact = emitted<Wide>(y, ratio);
      if (found.status != gauss::Status::ok) worst = k_breaks_down;
      grow(worst, relative_error(found.derivative.values + 12, exact.derivative.values + 12, 12));
      // The force on the first rod by the pins, along its own coordinates.
      const auto* force = &found.reactions.pin_1_x.generalized[0];
      const auto* exact_force = &exact.reactions.pin_1_x.generalized[0];
      grow(worst_force, relative_error(force, exact_force, 12));
    }
    char id[32];
    std::snprintf(id, sizeof id, "H07.%.0e", ratio);
    figures.push_back({id, "error of accelerations, 50 states", "1", std::nullopt, worst, 1e-13});
    figures.push_back(
        {std::string(id) + ".force", "error of the force of the first pin", "1", std::nullopt, worst_force, 1e-13});
  }
  return figures;
}

}  // namespace hard_cases
