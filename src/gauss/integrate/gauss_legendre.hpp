// Collocation at Gauss's points: implicit, symmetric in time, symplectic, for any model (speeds, quaternions, constraints).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_GAUSS_LEGENDRE_HPP
#define GAUSS_INTEGRATE_GAUSS_LEGENDRE_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/compensated.hpp"
#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

/// Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, tables II.7.3 and II.7.4: order 2 * stages.
template <class Scalar, int stages>
struct GaussLegendreTableau {
  static_assert(stages >= 1 && stages <= 3, "one to three stages");
  Scalar a[stages][stages];
  Scalar b[stages];
  Scalar c[stages];

  GaussLegendreTableau() {
    using std::sqrt;
    const Scalar one = 1;
    if constexpr (stages == 1) {
      a[0][0] = c[0] = one / 2;
      b[0] = one;
    } else if constexpr (stages == 2) {
      const Scalar d = sqrt(Scalar(3)) / 6;
      set({{one / 4, one / 4 - d}, {one / 4 + d, one / 4}}, {one / 2, one / 2}, {one / 2 - d, one / 2 + d});
    } else {
      const Scalar s = sqrt(Scalar(15));
      set({{one * 5 / 36, one * 2 / 9 - s / 15, one * 5 / 36 - s / 30},
           {one * 5 / 36 + s / 24, one * 2 / 9, one * 5 / 36 - s / 24},
           {one * 5 / 36 + s / 30, one * 2 / 9 + s / 15, one * 5 / 36}},
          {one * 5 / 18, one * 4 / 9, one * 5 / 18}, {one / 2 - s / 10, one / 2, one / 2 + s / 10});
    }
  }

 private:
  void set(const Scalar (&rows)[stages][stages], const Scalar (&weights)[stages], const Scalar (&nodes)[stages]) {
    for (int i = 0; i < stages; ++i) {
      std::copy_n(rows[i], stages, a[i]);
      b[i] = weights[i];
      c[i] = nodes[i];
    }
  }
};

/// Stages are solved by fixed-point iteration to rounding, which takes h times the fastest rate below about 1; it needs no derivatives. The state is summed
/// with what rounding left of earlier steps, so a long run loses no more than a short one, as long as nobody else changes the state.
template <class Model, int stages>
class GaussLegendre {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  static constexpr int order = 2 * stages;

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    sums_.begin(state.values);
    fit(size_, std::size(state.values));
    for (std::size_t i = 0; i < size_.size(); ++i) size_[i] = std::max(size_[i], std::abs(state.values[i]));
    iterations_of_last_step_ = 0;
    StepResult result = start(model, t, h, state);
    if (!result.is_taken()) return result;
    Scalar last = std::numeric_limits<Scalar>::max();
    for (int iteration = 0; iteration < k_most_iterations && result.is_taken(); ++iteration) {
      result = result_of(evaluate(model, t, h, state));
      const Scalar change = improve(h, state);
      // Rounding keeps the last digits moving: what no longer shrinks and is small has arrived.
      if (change == 0 || (change >= last && change <= k_arrived)) {
        if (result.is_taken()) add_up(h, state);
        return result;
      }
      if (!(change <= std::numeric_limits<Scalar>::max())) break;
      last = change;
    }
    // Also where the model has no rates at a guess: what is wrong with it there is no trouble of the motion.
    return {StepOutcome::not_converged, result.status};
  }

  /// Component i of the state is an angle on which the model depends by its sine and cosine alone: it is kept within a turn, with all the digits
  /// that sums have, where an angle of 1e11 rad has five decimals left.
  void wrap(std::size_t i) { sums_.wrap(i); }

  /// Each takes one evaluation of the model per stage; one more begins the step.
  int iterations_of_last_step() const { return iterations_of_last_step_; }
  long calls_of_last_step() const { return 1 + static_cast<long>(stages) * iterations_of_last_step_; }

 private:
  static constexpr int k_most_iterations = 60;
  /// Of a component's size.
  static constexpr Scalar k_arrived = 64 * std::numeric_limits<Scalar>::epsilon();

  /// Stages on the tangent.
  StepResult start(const Model& model, const Scalar& t, const Scalar& h, const State& state) {
    auto rates = Arrays::rates(model);
    const StepResult result = result_of(model.derivative(t, state, rates));
    for (int s = 0; s < stages; ++s) {
      fit(shift_[s], size_.size());
      for (std::size_t i = 0; i < size_.size(); ++i) shift_[s][i] = tableau_.c[s] * h * rates.values[i];
    }
    return result;
  }

  Status evaluate(const Model& model, const Scalar& t, const Scalar& h, const State& state) {
    Status trouble = Status::ok;
    for (int s = 0; s < stages; ++s) {
      State at = state;
      for (std::size_t i = 0; i < size_.size(); ++i) at.values[i] = state.values[i] + (shift_[s][i] + sums_.rest(i));
      const Status status = model.derivative(t + tableau_.c[s] * h, at, rates_[s]);
      if (is_motion_known(trouble) && status != Status::ok) trouble = status;
    }
    ++iterations_of_last_step_;
    return trouble;
  }

  /// Z_s = h sum_j a_sj f(y + Z_j); returns the largest change, relative to the size of the component.
  Scalar improve(const Scalar& h, const State& state) {
    Scalar largest = 0;
    for (int s = 0; s < stages; ++s) {
      for (std::size_t i = 0; i < size_.size(); ++i) {
        Scalar sum = 0;
        for (int j = 0; j < stages; ++j) sum += tableau_.a[s][j] * rates_[j].values[i];
        const Scalar better = h * sum;
        const Scalar size = std::max({size_[i], std::abs(state.values[i]), std::abs(better)});
        const Scalar change = std::abs(better - shift_[s][i]);
        if (change > 0) largest = std::max(largest, change / size);
        if (!(change == change)) return std::numeric_limits<Scalar>::infinity();
        shift_[s][i] = better;
      }
    }
    return largest;
  }

  /// Weights add up to 1, so differences of rates are weighted: a constant rate is summed exactly, whatever the weights round to.
  void add_up(const Scalar& h, State& state) {
    constexpr int k_middle = stages / 2;
    auto mean = zeros_like(size_);
    for (std::size_t i = 0; i < size_.size(); ++i) {
      const Scalar& middle = rates_[k_middle].values[i];
      Scalar sum = 0;
      for (int j = 0; j < stages; ++j) sum += tableau_.b[j] * (rates_[j].values[i] - middle);
      mean[i] = middle + sum;
    }
    sums_.advance(mean, h, state.values);
  }

  using Arrays = StateArrays<Model>;
  using Array = typename Arrays::Array;

  GaussLegendreTableau<Scalar, stages> tableau_;
  typename Model::Derivative rates_[stages]{};
  Array shift_[stages]{};
  CompensatedSums<typename Arrays::template Of<Compensated<Scalar>>, typename Arrays::template Of<bool>> sums_;
  Array size_{};  ///< largest so far
  int iterations_of_last_step_ = 0;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_GAUSS_LEGENDRE_HPP
