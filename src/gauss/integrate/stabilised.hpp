// A model whose constraints pull themselves back to zero (Baumgarte): an option beside projection, which needs no gains.
// SPDX-License-Identifier: MIT
//
// Instead of  d phi/dt = 0  a row asks for  d phi/dt + 2 alpha phi + beta^2 f = 0,  where phi = df/dt for an equation of positions f, and without the
// last term for a constraint of velocities. Accelerations depend on what rows ask for in a linear way, so they change by the d of
//
//     g d = b^T mu,   b d + 2 alpha phi + beta^2 f = 0,
//
// whatever has found them. It is as small as the violations, and needs few of its digits.
#ifndef GAUSS_INTEGRATE_STABILISED_HPP
#define GAUSS_INTEGRATE_STABILISED_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "gauss/constrained.hpp"
#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

/// In 1 by the unit of time. With beta = alpha a violation f decays as exp(-alpha t) (1 + alpha t), one of velocities alone as exp(-2 alpha t).
template <class Scalar>
struct Gains {
  Gains(const Scalar& of_speeds, const Scalar& of_positions) : alpha(of_speeds), beta(of_positions) {}
  Scalar alpha, beta;
};

namespace detail {

template <class Residuals, class = void>
struct PositionRows : std::integral_constant<int, 0> {};
template <class Residuals>
struct PositionRows<Residuals, std::void_t<decltype(Residuals::position)>>
    : std::integral_constant<int, static_cast<int>(std::extent_v<decltype(Residuals::position)>)> {};

template <class Result, class = void>
struct HasMetric : std::false_type {};
template <class Result>
struct HasMetric<Result, std::void_t<decltype(Result::g)>> : std::true_type {};

template <class Result, class = void>
struct HasRows : std::false_type {};
template <class Result>
struct HasRows<Result, std::void_t<decltype(Result::b)>> : std::true_type {};

}  // namespace detail

/// `Residuals` is the emitted struct. `Metric` is the emitted LinearSystem of a header that has one, which takes one call; of any other the emitted MassMatrix:
/// the rows b are then found by residuals of n + 1 candidate accelerations. Lengths of quaternions are no rows: they are for projection, or a
/// stepper that keeps them. Reactions are no business of gains: `reactions` is that of the model itself.
template <class Base, class Residuals, class Metric>
class Stabilised : public ModelDecorator<Stabilised<Base, Residuals, Metric>, Base> {
  using Decorator = ModelDecorator<Stabilised<Base, Residuals, Metric>, Base>;

 public:
  using Decorator::n_q, Decorator::n_v;
  using typename Decorator::Derivative;
  using typename Decorator::Scalar;
  using typename Decorator::State;
  using typename Decorator::Status;
  static_assert(std::is_same_v<Status, gauss::Status>, "lanes of a batch may have different ranks");
  static_assert(detail::HasMetric<Metric>::value,
                "the emitted LinearSystem or MassMatrix is expected: generate the model with the output `mass_matrix`");
  static constexpr int n = static_cast<int>(n_v);
  static constexpr int l = static_cast<int>(std::extent_v<decltype(Residuals::velocity)>);
  static constexpr int n_positions = detail::PositionRows<Residuals>::value;
  /// Which row each equation of positions is, counted from 0 as in the `constraint_table` of the header.
  using Rows = std::array<int, static_cast<std::size_t>(n_positions)>;

  /// All rows are equations of positions, or none is. `usual_rank` as `mobility` tells it: the number of rows where none follows from the others.
  Stabilised(Base base, const Gains<Scalar>& gains, int usual_rank)
      : Stabilised(std::move(base), gains, usual_rank, all_rows()) {
    static_assert(n_positions == l || n_positions == 0,
                  "equations of positions stand beside constraints of velocities: say which rows they are");
  }
  Stabilised(Base base, const Gains<Scalar>& gains, int usual_rank, const Rows& rows_of_positions)
      : base_(std::move(base)), gains_(gains), rule_(rule_of(usual_rank)), rows_(rows_of_positions) {}

  Status derivative(const Scalar& t, const State& state, Derivative& result) const {
    const Status moved = base_.derivative(t, state, result);
    if (!is_motion_known(moved)) return moved;
    Pull pull;
    const Status filled = fill(t, state, pull);
    LinearSolution<Scalar, n, l> added;
    gauss::solve(pull, rule_, added);
    for (std::size_t i = 0; i < n_v; ++i) result.values[n_q + i] += added.accelerations[i];
    return Math<Scalar>::worse(moved, Math<Scalar>::worse(filled, added.motion));
  }

  template <class Result>
  Status derivatives(const Scalar&, const State&, Result&) const {
    static_assert(!std::is_same_v<Result, Result>,
                  "the emitted Jacobian knows of no gains: take ByDifferences with a stabilised model");
    return Status{};
  }
  const Base& base() const { return base_; }

 private:
  /// As emitted: see gauss::solve.
  struct Pull {
    Scalar g[n][n], f[n], b[l][n], reach[l][n], drift[l];
    Scalar of_positions[l] = {};  ///< nobody asks: rule_of
    Scalar off[l] = {};
    Scalar drift_error[l] = {};
  };

  static Rows all_rows() {
    Rows rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<int>(i);
    return rows;
  }

  // What violations ask of rows that follow from others need not agree: it is error.
  static RankRule<Scalar> rule_of(int usual_rank) {
    RankRule<Scalar> rule =
        n_positions > 0 ? rank_on_positions<Scalar>(usual_rank) : rank_of_velocities<Scalar>(usual_rank);
    rule.is_agreement_known = true;
    rule.follows_positions = rule.follows_positions && detail::HasRows<Metric>::value;
    return rule;
  }

  Status fill(const Scalar& t, const State& state, Pull& pull) const {
    Derivative candidate{};
    Residuals at_rest;
    const Status violated = residuals(t, state, base_.inputs(t, state), base_.prepared(), candidate, at_rest);
    for (int i = 0; i < n; ++i) pull.f[i] = Scalar(0);
    for (int mu = 0; mu < l; ++mu) pull.drift[mu] = 2 * gains_.alpha * at_rest.velocity[mu];
    if constexpr (n_positions > 0) {
      for (std::size_t i = 0; i < rows_.size(); ++i)
        pull.drift[rows_[i]] += gains_.beta * gains_.beta * at_rest.position[i];
    }
    const Status found = fill_rows(t, state, at_rest, pull);
    return Math<Scalar>::worse(violated, found);
  }

  Status fill_rows(const Scalar& t, const State& state, const Residuals& at_rest, Pull& pull) const {
    Metric metric;
    Status status{};
    if constexpr (detail::HasRows<Metric>::value) {
      status = linear_system(t, state, base_.inputs(t, state), base_.prepared(), metric);
      copy(metric.b, pull.b);
      copy(metric.reach, pull.reach);
      std::copy_n(metric.off, l, pull.off);
    } else {
      status =
          Math<Scalar>::worse(mass_matrix(t, state, base_.prepared(), metric), difference(t, state, at_rest, pull.b));
      for (int mu = 0; mu < l; ++mu)
        for (int i = 0; i < n; ++i) pull.reach[mu][i] = gauss::detail::absolute<Scalar>(pull.b[mu][i]);
    }
    copy(metric.g, pull.g);
    return status;
  }

  /// dphi/dt is linear in the accelerations, with the rows as factors.
  Status difference(const Scalar& t, const State& state, const Residuals& at_rest, Scalar (&b)[l][n]) const {
    Status status{};
    for (int i = 0; i < n; ++i) {
      Derivative candidate{};
      candidate.values[n_q + static_cast<std::size_t>(i)] = Scalar(1);
      Residuals moved;
      status =
          Math<Scalar>::worse(status, residuals(t, state, base_.inputs(t, state), base_.prepared(), candidate, moved));
      for (int mu = 0; mu < l; ++mu) b[mu][i] = moved.acceleration[mu] - at_rest.acceleration[mu];
    }
    return status;
  }

  template <std::size_t rows>
  static void copy(const Scalar (&from)[rows][static_cast<std::size_t>(n)],
                   Scalar (&to)[rows][static_cast<std::size_t>(n)]) {
    for (std::size_t i = 0; i < rows; ++i)
      for (int j = 0; j < n; ++j) to[i][j] = from[i][j];
  }

  Base base_;
  Gains<Scalar> gains_;
  RankRule<Scalar> rule_;
  Rows rows_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_STABILISED_HPP
