#include "slips.hpp"

#include <algorithm>
#include <array>

#include "description.hpp"
#include "gauss/simulate/simulation.hpp"
#include "linear.hpp"

namespace sphere {

namespace {

constexpr std::size_t n = euler::n_v;  // chi, zeta, phi, psi, theta
constexpr std::size_t l = 2;
constexpr std::array<std::size_t, l> k_dependent{3, 1};  // psi, zeta: those of the paper
constexpr std::array<std::size_t, n - l> k_independent{0, 2, 4};

euler::Parameters<double> parameters_of_section_9() {
  euler::Parameters<double> parameters;
  const as_printed::Parameters<double> source;
  parameters.m = source.m;
  parameters.r = source.r;
  parameters.R = source.R;
  parameters.g = source.g;
  return parameters;
}

/// The state of section 9: its coordinates and free rates are those of the printed model; the dependent rates are those of the
/// correct constraints.
euler::State<double> state_of_section_9(const euler::Parameters<double>& p) {
  as_printed::State<double> printed;
  initial_state(as_printed::prepare(as_printed::Parameters<double>{}), printed);
  euler::State<double> state;
  std::copy(std::begin(printed.values), std::end(printed.values), std::begin(state.values));
  const double u = state.psi() - state.chi();
  state.psi_dot() = -(p.R - p.r) / p.r * state.chi_dot() - state.phi_dot() * std::cos(state.theta());
  state.zeta_dot() =
      p.r * state.theta_dot() * std::sin(u) - p.r * state.phi_dot() * std::sin(state.theta()) * std::cos(u);
  return state;
}

/// What Gauss's principle is about, taken from generated functions other than rhs: Z(a) = a·g a / 2 - f·a + …, and the rows
/// b a + drift = 0.
struct Problem {
  Matrix g, b;
  Vector f, drift;
};

Problem problem_at(const euler::State<double>& state, const euler::Prepared<double>& prepared) {
  Problem problem{Matrix(n, Vector(n)), Matrix(l, Vector(n)), Vector(n), Vector(l)};
  euler::MassMatrix<double> metric;
  mass_matrix(0.0, state, prepared, metric);
  const auto Z = [&](const euler::Derivative<double>& candidate) {
    euler::Compulsion<double> value;
    compulsion(0.0, state, {}, prepared, candidate, value);
    return value.Z;
  };
  const auto rows = [&](const euler::Derivative<double>& candidate) {
    euler::Residuals<double> value;
    residuals(0.0, state, {}, prepared, candidate, value);
    return Vector(std::begin(value.acceleration), std::end(value.acceleration));
  };
  const auto unit = [](std::size_t a, double size) {
    euler::Derivative<double> candidate{};
    candidate.values[euler::n_q + a] = size;
    return candidate;
  };
  problem.drift = rows({});
  for (std::size_t a = 0; a < n; ++a) {
    std::copy_n(metric.g[a], n, problem.g[a].begin());
    // Z is a quadratic function, so its central difference is exact.
    problem.f[a] = (Z(unit(a, -1)) - Z(unit(a, 1))) / 2;
    const Vector row = rows(unit(a, 1));
    for (std::size_t mu = 0; mu < l; ++mu) problem.b[mu][a] = row[mu] - problem.drift[mu];
  }
  return problem;
}

/// (3.4): g a - b^T lambda = f beside b a = -drift.
Vector with_multipliers(const Problem& problem) {
  Matrix A(n + l, Vector(n + l));
  Vector right(n + l);
  for (std::size_t a = 0; a < n; ++a) {
    std::copy(problem.g[a].begin(), problem.g[a].end(), A[a].begin());
    right[a] = problem.f[a];
  }
  for (std::size_t mu = 0; mu < l; ++mu) {
    for (std::size_t a = 0; a < n; ++a) {
      A[n + mu][a] = problem.b[mu][a];
      A[a][n + mu] = -problem.b[mu][a];
    }
    right[n + mu] = -problem.drift[mu];
  }
  Vector a = solve(A, right);
  a.resize(n);
  return a;
}

/// (3.6)-(3.7) with c = sign * b_mu^-1 b_p, beside b a = -drift.
Vector by_elimination(const Problem& problem, double sign) {
  Matrix b_dependent(l, Vector(l));
  for (std::size_t mu = 0; mu < l; ++mu) {
    for (std::size_t j = 0; j < l; ++j) b_dependent[mu][j] = problem.b[mu][k_dependent[j]];
  }
  Matrix A;
  Vector right;
  for (const std::size_t p : k_independent) {
    const Vector c = solve(b_dependent, {problem.b[0][p], problem.b[1][p]});
    Vector row = problem.g[p];
    double value = problem.f[p];
    for (std::size_t j = 0; j < l; ++j) {
      for (std::size_t a = 0; a < n; ++a) row[a] += sign * c[j] * problem.g[k_dependent[j]][a];
      value += sign * c[j] * problem.f[k_dependent[j]];
    }
    A.push_back(row);
    right.push_back(value);
  }
  for (std::size_t mu = 0; mu < l; ++mu) {
    A.push_back(problem.b[mu]);
    right.push_back(-problem.drift[mu]);
  }
  return solve(A, right);
}

double largest_difference(const Vector& x, const Vector& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = worse(largest, std::abs(x[i] - y[i]));
  return largest;
}

/// Either Euler model from the state given.
template <class Model, class State = typename Model::template State<double>>
RollingSlip::Variant roll(const typename Model::template Prepared<double>& prepared, const State& start, double R,
                          double r) {
  const auto model = gauss::integrate::bind_model<Model>(prepared, typename Model::template Inputs<double>{});
  gauss::simulate::Simulation simulation(model, start);
  const double Omega = ClosedForm({1, r, R, 1, start.chi_dot(), 0, 0}).frequency();
  std::vector<double> constant_if_harmonic;
  RollingSlip::Variant result{contact_speed(start, R, r), 0, 0, 0};
  constexpr int k_samples = 50;
  for (int k = 0; k <= k_samples; ++k) {
    if (!simulation.advance_to(RollingSlip::k_window * k / k_samples)) break;
    const State state = simulation.state();
    typename Model::template Derivative<double> derivative;
    model.derivative(simulation.time(), state, derivative);
    constant_if_harmonic.push_back(derivative.zeta_ddot() + Omega * Omega * state.zeta());
    result.contact_speed = worse(result.contact_speed, contact_speed(state, R, r));
  }
  const auto ends = std::minmax_element(constant_if_harmonic.begin(), constant_if_harmonic.end());
  result.change = *ends.second - *ends.first;
  simulation.advance_to(RollingSlip::k_duration);
  result.end = simulation.time();
  return result;
}

}  // namespace

EliminationSlip elimination_sign() {
  const euler::Parameters<double> parameters = parameters_of_section_9();
  const Problem problem = problem_at(state_of_section_9(parameters), prepare(parameters));
  const Vector reference = with_multipliers(problem);
  return {largest_difference(by_elimination(problem, 1), reference),
          largest_difference(by_elimination(problem, -1), reference)};
}

RollingSlip rolling_along() {
  const euler::Parameters<double> p = parameters_of_section_9();
  const auto prepared = as_printed::prepare(as_printed::Parameters<double>{});
  as_printed::State<double> start;
  initial_state(prepared, start);
  return {roll<AsPrintedModel>(prepared, start, p.R, p.r),
          roll<EulerModel>(prepare(p), state_of_section_9(p), p.R, p.r)};
}

ReactionSlip normal_reaction() {
  const euler::Parameters<double> p;
  const auto prepared = prepare(p);
  euler::State<double> start;
  initial_state(prepared, start);
  euler::Reactions<double> found;
  reactions(0.0, start, {}, prepared, found);
  const double square = start.chi_dot() * start.chi_dot();
  return {-p.m * p.R * square, -p.m * (p.R - p.r) * square, found.rho.generalized};
}

}  // namespace sphere
