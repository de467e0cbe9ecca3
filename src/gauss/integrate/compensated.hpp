// Sums of very many increments, without the rounding of each; and angles that stay within a turn.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_COMPENSATED_HPP
#define GAUSS_INTEGRATE_COMPENSATED_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>

#include "gauss/integrate/state_arrays.hpp"

namespace gauss::integrate {

/// 2 pi as the sum of three parts, of which the first two have so few digits that products with the number of turns are exact.
template <class Scalar>
struct PartsOfTurn {
  static constexpr bool are_known = false;
};
template <>
struct PartsOfTurn<double> {
  static constexpr bool are_known = true;
  static constexpr double upper = 0x1.921fb54400000p+2, middle = 0x1.0b4611a600000p-32, lower = 0x1.3198a2e037073p-67;
};
template <>
struct PartsOfTurn<float> {
  static constexpr bool are_known = true;
  static constexpr float upper = 0x1.922p+2F, middle = -0x1.2afp-16F, lower = 0x1.0b4612p-32F;
};

/// A number as the sum of `value` and a `rest` below its last digit: twice the digits (Dekker, Numerische Mathematik 18 (1971) 224-242).
template <class Scalar>
struct Compensated {
  Scalar value = 0;
  Scalar rest = 0;

  /// Of any size; what both lose is below epsilon squared.
  void add(const Scalar& increment) {
    const Scalar sum = value + increment;
    const Scalar part = sum - value;
    rest += (value - (sum - part)) + (increment - part);
    value = sum + rest;
    rest -= value - sum;
  }

  void add_product(const Scalar& a, const Scalar& b) {
    add(a * b);
    if constexpr (std::is_floating_point_v<Scalar>) rest += std::fma(a, b, -(a * b));
  }

  /// Into (-pi, pi), up to rounding, by whole turns, as long as they are fewer than 2^19 in double, of each of which 1e-32 rad are lost, and than 2^11
  /// in float, with 5e-18 rad.
  void wrap() {
    using Parts = PartsOfTurn<Scalar>;
    static_assert(Parts::are_known, "the parts of 2 pi are those of double and float");
    const Scalar turns = std::nearbyint(value / (Parts::upper + Parts::middle));
    if (turns == 0) return;
    add(-turns * Parts::upper);
    add(-turns * Parts::middle);
    add(-turns * Parts::lower);
  }
};

/// Components of a state that a stepper sums up, step after step. `Sums` holds a Compensated<Scalar> for each, `Flags` a bool: arrays, or containers that
/// grow to the size of the state.
template <class Sums, class Flags>
class CompensatedSums {
 public:
  using Scalar = decltype(Sums::value_type::value);

  /// What somebody else has changed since has no rest.
  template <class Values>
  void begin(const Values& values) {
    fit(sums_, std::size(values));
    fit(is_angle_, std::size(values));
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (!(values[i] == sums_[i].value)) sums_[i] = {values[i], 0};
  }

  /// rate[i] h, added to each component.
  template <class Rates, class Values>
  void advance(const Rates& rate, const Scalar& h, Values& values) {
    for (std::size_t i = 0; i < sums_.size(); ++i) add(i, rate[i], h, values);
  }
  /// The same of one component.
  template <class Values>
  void add(std::size_t i, const Scalar& rate, const Scalar& h, Values& values) {
    sums_[i].add_product(h, rate);
    if constexpr (PartsOfTurn<Scalar>::are_known) {
      if (is_angle_[i]) sums_[i].wrap();
    }
    values[i] = sums_[i].value;
  }

  /// Component i is an angle, of which whole turns do not matter.
  void wrap(std::size_t i) {
    if (is_angle_.size() <= i) fit(is_angle_, i + 1);
    is_angle_[i] = true;
  }

  const Scalar& rest(std::size_t i) const { return sums_[i].rest; }

 private:
  Sums sums_{};
  Flags is_angle_{};
};

template <class Scalar, std::size_t n>
using CompensatedState = CompensatedSums<std::array<Compensated<Scalar>, n>, std::array<bool, n>>;

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_COMPENSATED_HPP
