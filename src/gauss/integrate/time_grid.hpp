// Times of steps of one length. Adding up steps loses a rounding error with each: 0.8 ms after 1e8 steps of 0.01 s, and in float the
// time stands still at 3e5 s.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_TIME_GRID_HPP
#define GAUSS_INTEGRATE_TIME_GRID_HPP

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace gauss::integrate {

/// start + k step, k a whole number.
template <class Scalar>
class TimeGrid {
 public:
  TimeGrid(const Scalar& start, const Scalar& step)
      : start_(start), step_(step), long_step_(std::ldexp(Scalar(1), k_bits) * step) {}

  /// Within one unit in the last place of the exact value, for k >= 0 where start is 0 or has the sign of step.
  Scalar at(std::int64_t k) const {
    // k may have more digits than Scalar: its upper digits go with a longer step, which is exact.
    const std::int64_t upper = k >> k_bits;
    const std::int64_t lower = k - (upper << k_bits);
    return plus(static_cast<Scalar>(upper), long_step_, plus(static_cast<Scalar>(lower), step_, start_));
  }

  const Scalar& start() const { return start_; }
  const Scalar& step() const { return step_; }

 private:
  static constexpr int k_bits = std::numeric_limits<Scalar>::digits < 53 ? std::numeric_limits<Scalar>::digits - 1 : 52;

  static Scalar plus(const Scalar& count, const Scalar& step, const Scalar& sum) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      return std::fma(count, step, sum);
    } else {
      return count * step + sum;
    }
  }

  Scalar start_;
  Scalar step_;
  Scalar long_step_;  ///< 2^k_bits steps
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_TIME_GRID_HPP
