// Painleve's rod: above a friction of 4/3 there is no motion that its contact would allow, and below there is one.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "registry.hpp"
#include "simulated.hpp"

namespace hard_cases {

namespace {

constexpr const char* k_rod = "hard_cases/models/regimes/painleve_rod.yaml";
constexpr double k_g = 9.81;

/// The lower tip slides along the floor; 1/A is what its vertical acceleration gets of the reaction, and N = (g - theta'^2 cos(theta))/A, l = m = 1.
double inverse_mass(double theta, double mu) {
  return 1 + 3 * std::sin(theta) * (std::sin(theta) - mu * std::cos(theta));
}

/// What N has to be for the tip to stay on the floor, m l^2/3 about the mass centre.
double reaction(double theta, double rate, double mu) {
  return (k_g - rate * rate * std::cos(theta)) / inverse_mass(theta, mu);
}

/// N and the gap are both 0 or more, and one of them is 0; N is that of the equations of Newton and Euler.
double residual(const Simulated& run, double mu) {
  const auto& table = run.table;
  for (const char* column : {"z", "theta", "theta_dot", "modes.friction", "reactions.floor.multiplier"})
    if (table.count(column) == 0) return k_breaks_down;
  const auto& slides = table.at("modes.friction");
  double most = slides.size() > 10 ? 0 : k_breaks_down;
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const double theta = table.at("theta")[k], pressed = table.at("reactions.floor.multiplier")[k];
    const double gap = table.at("z")[k] - std::cos(theta);
    grow(most, std::min(pressed, 0.0));
    grow(most, std::min(gap, 0.0));
    grow(most, std::min(pressed, gap));
    // While it slides forwards.
    if (slides[k] == 2) grow(most, pressed / reaction(theta, table.at("theta_dot")[k], mu) - 1);
  }
  return run.exit_code == 0 ? most : k_breaks_down;
}

}  // namespace

std::vector<Figure> painleve(const Scope&) {
  // Where A is below 0, equations of motion have the floor pull the rod down.
  double naive = 0, unnamed = 0, seconds = 0;
  for (const char* mu : {"1.5", "2", "3"}) {
    const double A = inverse_mass(0.46, std::atof(mu));
    if (A < 0) naive += 1;
    const Simulated run = simulated(k_rod, std::string("--duration 1 --set mu=") + mu);
    const bool is_named = run.exit_code == 5 && run.said.find("leave no motion") != std::string::npos;
    if (!is_named || !run.is_finite()) unnamed += 1;
    seconds += run.seconds;
  }
  double worst = 0, seconds_below = 0;
  for (const double mu : {0.3, 1.0, 1.3}) {
    const Simulated run =
        simulated(k_rod, "--duration 0.2 --samples 101 --outputs state,reactions,modes --set mu=" + std::to_string(mu));
    grow(worst, residual(run, mu));
    seconds_below += run.seconds;
  }
  return {{"H17.named",
           "of 3 runs above its critical friction, those that do not say that there is no motion (naive: reactions "
           "below 0)",
           "1", naive, unnamed, 0, 0, seconds},
          {"H17.below",
           "reaction and gap below it, which are 0 or more, and not both more; reaction beside Newton and Euler", "1",
           std::nullopt, worst, 1e-12, 0, seconds_below}};
}

}  // namespace hard_cases
