// A chain of four rods in coordinates of space, of which the last or the first is 1e3 to 1e12 times as heavy as the others, or as light.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "heavy_chain.hpp"
#include "heavy_tree.hpp"
#include "registry.hpp"
#include "wide.hpp"
#include "without_rank.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::heavy_chain;

/// Masses of the first and of the last rod over that of the others.
struct Ends {
  double first, last;
};

template <class S>
struct Answer {
  model::Derivative<S> derivative{};
  model::Reactions<S> reactions{};
  gauss::StatusOf<S> status;
};

template <class S>
Answer<S> emitted(const double* y, const Ends& ends) {
  model::Parameters<S> parameters;
  parameters.first = ends.first;
  parameters.ratio = ends.last;
  model::State<S> state;
  for (int i = 0; i < model::n_q + model::n_v; ++i) state.values[i] = y[i];
  Answer<S> answer;
  answer.status =
      rhs_and_reactions(S(0), state, model::Inputs<S>{}, prepare(parameters), answer.derivative, answer.reactions);
  return answer;
}

constexpr double k_bar = 1e-13;
constexpr int k_rods = 4, k_speeds = 3 * k_rods, k_rows = 2 * k_rods;

/// On the constraints: angles and rates are chosen, places follow.
void place(int trial, double (&y)[2 * k_speeds]) {
  double x = 0, z = 0, x_dot = 0, z_dot = 0;
  for (int k = 0; k < k_rods; ++k) {
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
        y[k_speeds + 3 * k + i] = values[3 + i];
      }
    }
  }
}

/// The whole system by elimination, and the force of the first pin as what momentum needs beside the weights: sum of M a - Q.
void by_elimination(const model::State<double>& state, const model::Prepared<double>& prepared, double (&a)[k_speeds],
                    double (&force)[2]) {
  model::LinearSystem<double> system{};
  (void)linear_system(0.0, state, {}, prepared, system);
  double x[k_speeds + k_rows];
  eliminate_all<k_speeds, k_rows>(system, x);
  std::copy_n(x, k_speeds, a);
  force[0] = force[1] = 0;
  for (int k = 0; k < k_rods; ++k) {
    for (int i = 0; i < 2; ++i) {
      const int row = 3 * k + i;
      force[i] -= system.f[row];
      for (int j = 0; j < k_speeds; ++j) force[i] += system.g[row][j] * a[j];
    }
  }
}

struct Errors {
  double ours = 0, naive = 0, ours_force = 0, naive_force = 0;
  double seconds_ours = 0, seconds_naive = 0;
};

void measure(int trial, const Ends& ends, Errors& errors) {
  double y[2 * k_speeds];
  place(trial, y);
  Stopwatch of_ours;
  const Answer<double> found = emitted<double>(y, ends);
  errors.seconds_ours += of_ours.seconds();
  const Answer<Wide> exact = emitted<Wide>(y, ends);
  const Wide* accelerations = exact.derivative.values + k_speeds;
  if (found.status != gauss::Status::ok) errors.ours = k_breaks_down;
  grow(errors.ours, relative_error(found.derivative.values + k_speeds, accelerations, k_speeds));
  const double found_force[] = {found.reactions.pin_1_z.multiplier, found.reactions.pin_1_x.multiplier};
  const Wide exact_force[] = {exact.reactions.pin_1_z.multiplier, exact.reactions.pin_1_x.multiplier};
  grow(errors.ours_force, relative_error(found_force, exact_force, 2));

  model::Parameters<double> parameters;
  parameters.first = ends.first;
  parameters.ratio = ends.last;
  model::State<double> state;
  std::copy_n(y, 2 * k_speeds, state.values);
  double a[k_speeds], force[2];
  Stopwatch of_naive;
  by_elimination(state, prepare(parameters), a, force);
  errors.seconds_naive += of_naive.seconds();
  grow(errors.naive, relative_error(a, accelerations, k_speeds));
  grow(errors.naive_force, relative_error(force, exact_force, 2));
}

/// The naive form where it misses the bar: where masses are alike it does not.
Figure figure(const std::string& id, const char* quantity, double bar, double naive, double ours,
              const Errors& errors) {
  return {id,
          quantity,
          "1",
          naive > bar ? std::optional(naive) : std::nullopt,
          ours,
          bar,
          errors.seconds_naive,
          errors.seconds_ours,
          naive > bar ? "naive: all rows by elimination, sum of M a - Q" : "",
          {}};
}

namespace tree = gauss::heavy_tree;

template <class S>
gauss::StatusOf<S> in_a_tree(int trial, double ratio, S (&a)[k_rods]) {
  tree::Parameters<S> parameters;
  parameters.ratio = ratio;
  tree::State<S> state;
  for (int k = 0; k < k_rods; ++k) {
    state.values[k] = 0.8 * std::sin(1.7 * trial + k) - (k > 0 ? 0.8 * std::sin(1.7 * trial + k - 1) : 0);
    state.values[k_rods + k] = 2 * std::cos(2.3 * trial + 3 * k) - (k > 0 ? 2 * std::cos(2.3 * trial + 3 * k - 3) : 0);
  }
  tree::Derivative<S> derivative{};
  const auto status = rhs(S(0), state, tree::Inputs<S>{}, prepare(parameters), derivative);
  std::copy_n(derivative.values + k_rods, k_rods, a);
  return status;
}

/// In angles the light rods are what is left of sums with the heavy one: as many digits are lost as it is heavier, and the status says so at last.
Figure of_tree(double ratio) {
  double error = 0, seconds = 0;
  int refused = 0;
  for (int trial = 0; trial < 50; ++trial) {
    double a[k_rods];
    Wide exact[k_rods];
    Stopwatch watch;
    const gauss::Status status = in_a_tree(trial, ratio, a);
    seconds += watch.seconds();
    (void)in_a_tree(trial, ratio, exact);
    if (status == gauss::Status::ok) {
      grow(error, relative_error(a, exact, k_rods));
    } else {
      ++refused;
    }
  }
  char id[32];
  std::snprintf(id, sizeof id, "H07.tree.%.0e", ratio);
  const std::string note = refused == 0 ? "" : "of 50 states " + std::to_string(refused) + " have singular_mass_matrix";
  const double bar = std::max(k_bar, 10 * ratio * 2.2e-16);
  return {id,    "error of accelerations, the same rods in relative angles, 50 states",
          "1",   std::nullopt,
          error, bar,
          0,     seconds,
          note,  {}};
}

}  // namespace

std::vector<Figure> mass_ratio(const Scope&) {
  std::vector<Figure> figures;
  for (const bool is_first : {false, true}) {
    for (const double ratio : {1e3, 1e6, 1e9, 1e12, 1e-3, 1e-6, 1e-9, 1e-12}) {
      Errors errors;
      const Ends ends = is_first ? Ends{ratio, 1} : Ends{1, ratio};
      for (int trial = 0; trial < 50; ++trial) measure(trial, ends, errors);
      char id[32];
      std::snprintf(id, sizeof id, "H07.%s%.0e", is_first ? "first." : "", ratio);
      figures.push_back(figure(id,
                               is_first ? "error of accelerations, first rod so many times as heavy, 50 states"
                                        : "error of accelerations, last rod so many times as heavy, 50 states",
                               k_bar, errors.naive, errors.ours, errors));
      figures.push_back(figure(std::string(id) + ".force",
                               "error of the force of the first pin (naive: sum of M a - Q)", k_bar, errors.naive_force,
                               errors.ours_force, errors));
    }
  }
  for (const double ratio : {1e3, 1e6, 1e9, 1e12, 1e-3, 1e-6, 1e-9, 1e-12}) figures.push_back(of_tree(ratio));
  return figures;
}

}  // namespace hard_cases
