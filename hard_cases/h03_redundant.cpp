// Constraints of which one follows from the others: four legs of a table. What carries is not unique; what is returned is the least.

#include <algorithm>
#include <cmath>

#include "registry.hpp"
#include "table.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::table;

constexpr double k_a = 0.6, k_b = 0.4;
constexpr double k_x[] = {k_a, -k_a, -k_a, k_a}, k_y[] = {k_b, k_b, -k_b, -k_b};

/// S = b g^-1 b^T of the four legs for a unit metric, by elimination without pivots: the fourth leg is 0/0, or rounding.
double by_schur_complement(double weight, double x, double y) {
  double s[4][5];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) s[i][j] = 1 + k_x[i] * k_x[j] + k_y[i] * k_y[j];
    s[i][4] = weight * (1 + k_x[i] * x + k_y[i] * y);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const double factor = s[j][i] / s[i][i];
      for (int k = i; k < 5; ++k) s[j][k] -= factor * s[i][k];
    }
  }
  const double last = s[3][4] / s[3][3];
  const double least = weight * (0.25 + x * k_x[3] / (4 * k_a * k_a) + y * k_y[3] / (4 * k_b * k_b));
  const double error = std::abs(last / least - 1);
  return std::isfinite(error) ? error : k_breaks_down;
}

}  // namespace

std::vector<Figure> redundant(const Scope&) {
  model::Parameters<double> parameters;
  double naive = 0, ours = 0;
  int unmarked = 0;
  for (int i = 0; i < 100; ++i) {
    parameters.x_c = 0.4 * std::sin(0.7 * i);
    parameters.y_c = 0.3 * std::cos(1.3 * i);
    const auto prepared = model::prepare(parameters);
    model::State<double> state{};
    model::Reactions<double> reactions{};
    model::Derivative<double> derivative{};
    if (rhs(0.0, state, {}, prepared, derivative) != gauss::Status::ok) ++unmarked;
    if (model::reactions(0.0, state, {}, prepared, reactions) != gauss::Status::dependent_constraints) ++unmarked;
    const double weight = parameters.m * parameters.g;
    const double legs[] = {reactions.leg_A.multiplier, reactions.leg_B.multiplier, reactions.leg_C.multiplier,
                           reactions.leg_D.multiplier};
    // Equilibrium, whatever the share: sum, and moments about both axes.
    double sum = -weight, about_y = -weight * parameters.x_c, about_x = -weight * parameters.y_c;
    for (int k = 0; k < 4; ++k) {
      sum += legs[k];
      about_y += legs[k] * k_x[k];
      about_x += legs[k] * k_y[k];
    }
    for (const double left : {sum, about_x, about_y}) grow(ours, left / weight);
    for (const double a : derivative.values) grow(ours, a);
    grow(naive, by_schur_complement(weight, parameters.x_c, parameters.y_c));
  }
  std::vector<Figure> figures = said_twice();
  figures.push_back({"H03.table", "error of a table's equilibrium on four legs, of the weight", "1", naive, ours, 1e-13,
                     0, 0, "naive: share of a leg"});
  figures.push_back({"H03.marked", "of 200 calls, reactions not marked as not unique, or a motion that is", "1",
                     std::nullopt, static_cast<double>(unmarked), 0});
  return figures;
}

}  // namespace hard_cases
