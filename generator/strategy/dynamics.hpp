#pragma once
// The linear problem that Gauss's principle leaves for the free accelerations (theory, sections 3 and 4).

#include <functional>
#include <optional>

#include "kinematics/covariant.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// What unknowns are called in emitted code: <prefix><acceleration>_<label>.
struct NamesOfUnknowns {
  std::string prefix;
  std::string acceleration = "a";
  std::string multiplier = "lambda";
};

/// Of a metric: rows that are combinations of earlier ones in every configuration, whatever form their entries have.
using DependentRows = std::function<std::vector<std::size_t>(const Matrix& metric)>;

struct Solution;

/// The least δ in the mass metric along `moving` with b δ + residual = 0, at the configuration that symbols stand for: the problem
/// that Gauss's principle poses for accelerations, of a system at rest that nothing acts on.
struct Change {
  std::vector<std::size_t> moving;  ///< speeds
  std::vector<std::size_t> rows;    ///< constraints
  Vector residuals;                 ///< of these rows
  std::string prefix;               ///< of names
};

/// minimise Z over a:  g a = f + bᵀ λ,  b a + b_drift = 0.
struct Dynamics {
  const kinematics::Kinematics* kinematics = nullptr;
  const support::Lazy<kinematics::Covariant>* covariant = nullptr;
  std::vector<std::string> labels;       ///< of free speeds
  std::vector<std::string> constraints;  ///< names
  support::LazyList<Matrix> g;           ///< n×n
  support::LazyList<Vector> f;           ///< Q_α - bias_α - g_αi c̈^i
  Matrix b;                              ///< l×n, b_μα = β_μα
  Vector b_drift;                        ///< Θ_μ + β_μi c̈^i
  NamesOfUnknowns names;
  /// Part of the response of a constraint alone (its diagonal entry of S) at which it follows from the others, beside rounding: the square of the
  /// model's rank_tolerance.
  ir::Rational least_response = 0;
  DependentRows dependent_rows;
  /// Of what depends on parameters alone, with those of the model; infinite where it has no value. May be empty.
  std::function<double(ir::Expr)> at_parameters;
  std::function<Vector()> inertias_of_links;  ///< n, the diagonal of g; may be none
  std::function<std::optional<Solution>(const Change&, Steps&)>
      change_of_links;  ///< least_change_of_links; may be none

  std::size_t n() const { return labels.size(); }
  std::size_t l() const { return constraints.size(); }
};

/// For problems over the block of g of some speeds at other places: what depends on each other here does so there. `dynamics` has to
/// last as long.
DependentRows dependent_rows_over(const Dynamics& dynamics, const std::vector<std::size_t>& speeds);

/// The diagonal of g, where there are links without its other entries.
Vector inertias(const Dynamics& dynamics);

/// The rows of g, then those of b: what inertia and constraints say together of the accelerations.
Matrix g_above_b(const Dynamics& dynamics);

/// `metric_steps`: where g and f are named once somebody asks for them; it has to last as long.
Dynamics build_dynamics(const kinematics::Kinematics& kinematics, const support::Lazy<kinematics::Covariant>& covariant,
                        DependentRows dependent_rows, Steps& steps, Steps& metric_steps);

}  // namespace gaussgen::strategy
