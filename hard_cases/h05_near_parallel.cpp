// Gradients of two constraints that are nearly parallel: the Schur complement has the square of their condition number.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "near_parallel.hpp"
#include "registry.hpp"
#include "wide.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::near_parallel;

constexpr int k_speeds = 6, k_rows = 3, k_trials = 50;
constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

struct Problem {
  double force[k_speeds], mass[k_speeds], row[k_rows][k_speeds], drift[k_rows];
};

/// The last row makes an angle of about `angle` with the first.
Problem problem(double angle, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Problem p{};
  for (double& m : p.mass) m = std::exp(normal(engine));
  for (double& f : p.force) f = normal(engine);
  for (auto& row : p.row) {
    for (double& entry : row) entry = normal(engine);
  }
  for (double& d : p.drift) d = normal(engine);
  // Across the first row, in the metric of the masses, and as long.
  double along = 0, squares = 0, own = 0;
  for (int i = 0; i < k_speeds; ++i) {
    along += p.row[0][i] * p.row[2][i] / p.mass[i];
    squares += p.row[0][i] * p.row[0][i] / p.mass[i];
  }
  for (int i = 0; i < k_speeds; ++i) p.row[2][i] -= along / squares * p.row[0][i];
  for (int i = 0; i < k_speeds; ++i) own += p.row[2][i] * p.row[2][i] / p.mass[i];
  const double scale = angle * std::sqrt(squares / own);
  for (int i = 0; i < k_speeds; ++i) p.row[2][i] = p.row[0][i] + scale * p.row[2][i];
  p.drift[2] = p.drift[0] + angle * p.drift[2];
  return p;
}

template <class S>
struct Answer {
  S acceleration[k_speeds];
  gauss::StatusOf<S> status;
};

template <class S>
Answer<S> emitted(const Problem& p) {
  model::Parameters<S> parameters;
  constexpr auto members = model::parameter_members<S>;
  // In the order of the model: masses, forces, rows, drifts.
  int next = 0;
  for (const double m : p.mass) parameters.*members[next++] = m;
  for (const double f : p.force) parameters.*members[next++] = f;
  for (const auto& row : p.row) {
    for (const double entry : row) parameters.*members[next++] = entry;
  }
  for (const double d : p.drift) parameters.*members[next++] = d;
  const model::State<S> state{};
  model::Derivative<S> derivative{};
  Answer<S> answer{};
  answer.status = rhs(S(0), state, model::Inputs<S>{}, prepare(parameters), derivative);
  for (int i = 0; i < k_speeds; ++i) answer.acceleration[i] = derivative.values[k_speeds + i];
  return answer;
}

/// By S = b g^-1 b^T, as the multiplier form has it, and elimination without pivots.
void by_schur_complement(const Problem& p, double (&a)[k_speeds]) {
  double s[k_rows][k_rows + 1];
  for (int i = 0; i < k_rows; ++i) {
    s[i][k_rows] = -p.drift[i];
    for (int k = 0; k < k_speeds; ++k) s[i][k_rows] -= p.row[i][k] * p.force[k] / p.mass[k];
    for (int j = 0; j < k_rows; ++j) {
      s[i][j] = 0;
      for (int k = 0; k < k_speeds; ++k) s[i][j] += p.row[i][k] * p.row[j][k] / p.mass[k];
    }
  }
  for (int i = 0; i < k_rows; ++i) {
    for (int j = i + 1; j < k_rows; ++j) {
      const double factor = s[j][i] / s[i][i];
      for (int k = i; k <= k_rows; ++k) s[j][k] -= factor * s[i][k];
    }
  }
  double lambda[k_rows];
  for (int i = k_rows - 1; i >= 0; --i) {
    lambda[i] = s[i][k_rows];
    for (int j = i + 1; j < k_rows; ++j) lambda[i] -= s[i][j] * lambda[j];
    lambda[i] /= s[i][i];
  }
  for (int k = 0; k < k_speeds; ++k) {
    a[k] = p.force[k];
    for (int i = 0; i < k_rows; ++i) a[k] += p.row[i][k] * lambda[i];
    a[k] /= p.mass[k];
  }
}

double error(const double (&a)[k_speeds], const Answer<Wide>& exact) {
  return relative_error(a, exact.acceleration, k_speeds);
}

}  // namespace

std::vector<Figure> near_parallel(const Scope&) {
  std::vector<Figure> figures;
  std::mt19937_64 engine(5);
  int silent = 0, silent_naive = 0, beyond = 0;
  for (const double angle : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16}) {
    const bool is_asked = angle >= 1e-8;
    double naive = 0, ours = 0, seconds_naive = 0, seconds_ours = 0;
    for (int trial = 0; trial < k_trials; ++trial) {
      const Problem p = problem(angle, engine);
      const Answer<Wide> exact = emitted<Wide>(p);
      Stopwatch of_ours;
      const Answer<double> found = emitted<double>(p);
      seconds_ours += of_ours.seconds();
      Stopwatch of_naive;
      double schur[k_speeds];
      by_schur_complement(p, schur);
      seconds_naive += of_naive.seconds();
      const double missed = error(found.acceleration, exact);
      if (is_asked) {
        grow(naive, error(schur, exact));
        grow(ours, found.status == gauss::Status::ok ? missed : k_breaks_down);
      } else {
        ++beyond;
        const double bar = 100 * k_epsilon / angle;
        if (!(error(schur, exact) <= bar)) ++silent_naive;
        const bool is_right = missed <= bar;
        bool is_finite = true;
        for (const double a : found.acceleration) is_finite = is_finite && std::isfinite(a);
        if (!is_finite || (found.status == gauss::Status::ok && !is_right)) ++silent;
      }
    }
    if (!is_asked) continue;
    char id[32];
    std::snprintf(id, sizeof id, "H05.%.0e", angle);
    const double bar = 100 * k_epsilon / angle;
    // Far from parallel, nothing is lost.
    const std::optional<double> shown = naive > bar ? std::optional(naive) : std::nullopt;
    figures.push_back(
        {id, "relative error of accelerations, 50 problems", "1", shown, ours, bar, seconds_naive, seconds_ours});
  }
  figures.push_back({"H05.beyond", "of " + std::to_string(beyond) + " below 1e-8, wrong or not finite without a status",
                     "1", static_cast<double>(silent_naive), static_cast<double>(silent), 0});
  return figures;
}

}  // namespace hard_cases
