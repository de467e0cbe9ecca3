// An attitude by Euler angles in one of two charts, whichever is away from its pole.
// SPDX-License-Identifier: MIT
//
// The attitude is  R_euler(angles) C.  In the first chart C is 1, in the second a quarter turn about the axis p of the body that comes after the last one of
// the sequence (x after z). Where the axis of the last turn points along that of the first, which is the pole of one chart, a quarter turn
// makes it normal to it: the pole of one chart is as far from that of the other as can be, and two are enough. The angular velocity stays as it is, and
// rates follow from it.
#ifndef GAUSS_INTEGRATE_EULER_CHART_HPP
#define GAUSS_INTEGRATE_EULER_CHART_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "gauss/integrate/euler_angles.hpp"

namespace gauss::integrate {

/// Components of a state: the three angles in the order of their turns, and their rates.
struct EulerPlaces {
  std::array<std::size_t, 3> angles, rates;
};

/// The model is one and the same in both charts: bodies whose moments of inertia about all axes through the mass centre are equal, and which nothing but
/// rolling touches. Forces, constraints and held coordinates depend on angular velocity, and on none of the angles.
struct SameInBothCharts {};

/// The chart that is in force, and states in it.
template <class State, class Sequence>
class EulerChart {
 public:
  using Scalar = std::remove_all_extents_t<decltype(State::values)>;

  /// The axis of the body about which C turns: 0 is x.
  static constexpr std::size_t p = (Sequence::k + 1) % 3;
  /// Rates are that much faster than the body turns, and their rounding with them; above 0.7 both charts could be too near.
  static constexpr double k_limit = 0.5;
  static constexpr double k_behind = 1.57079632679489661923;  ///< rad, of the second chart

  explicit EulerChart(const EulerPlaces& places, const Scalar& limit = Scalar(k_limit))
      : places_(places), limit_(limit) {}

  /// Sets angles and rates, in the chart that is the better one there; for a start, at any attitude. `attitude` is that of the body, the angular
  /// velocity in the axes of space.
  void place(const Rotation<Scalar>& attitude, const Vector3<Scalar>& angular_velocity, State& state) {
    is_turned_ = is_near_pole(attitude);
    write(is_turned_ ? before_turn(attitude) : attitude, angular_velocity, state);
  }

  /// Writes the state in the other chart where |sin| (of sequences such as zyx: |cos|) of the second angle is below the limit; false: it is not.
  bool change(State& state) {
    const Rotation<Scalar> written = Sequence::rotation(angles(state));
    if (!is_near_pole(written)) return false;
    is_turned_ = !is_turned_;
    write(is_turned_ ? before_turn(written) : turned(written), angular_velocity(state), state);
    return true;
  }

  /// Takes whole turns off angles of more than `most` rad, half a turn at least; false: there are none. The rounding of many turns would move the axes by which rates are an angular
  /// velocity.
  bool wrap(const Scalar& most, State& state) const {
    constexpr double k_turn = 6.28318530717958647693;
    bool is_changed = false;
    for (const std::size_t place : places_.angles) {
      Scalar& angle = state.values[place];
      if (!(std::abs(angle) > most)) continue;
      angle -= Scalar(k_turn) * std::round(angle / Scalar(k_turn));
      is_changed = true;
    }
    return is_changed;
  }

  /// Of the body.
  Rotation<Scalar> attitude(const State& state) const {
    const Rotation<Scalar> written = Sequence::rotation(angles(state));
    return is_turned_ ? turned(written) : written;
  }

  /// In the axes of space.
  Vector3<Scalar> angular_velocity(const State& state) const {
    return Sequence::angular_velocity(angles(state), at(places_.rates, state));
  }

  /// Whether C is the quarter turn, and not 1.
  bool is_turned() const { return is_turned_; }
  Rotation<Scalar> behind() const {
    const Rotation<Scalar> one = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    return is_turned_ ? turned(one) : one;
  }

 private:
  bool is_near_pole(const Rotation<Scalar>& written) const { return Sequence::distance_from_pole(written) < limit_; }

  void write(const Rotation<Scalar>& written, const Vector3<Scalar>& angular_velocity, State& state) const {
    const Vector3<Scalar> angles = Sequence::angles(written);
    const Vector3<Scalar> rates = Sequence::rates(angles, angular_velocity);
    for (std::size_t i = 0; i < 3; ++i) {
      state.values[places_.angles[i]] = angles[i];
      state.values[places_.rates[i]] = rates[i];
    }
  }

  static Vector3<Scalar> at(const std::array<std::size_t, 3>& places, const State& state) {
    return {state.values[places[0]], state.values[places[1]], state.values[places[2]]};
  }
  Vector3<Scalar> angles(const State& state) const { return at(places_.angles, state); }

  /// R C, without rounding.
  static Rotation<Scalar> turned(const Rotation<Scalar>& r) { return columns(r, 1, -1); }
  /// R C^T
  static Rotation<Scalar> before_turn(const Rotation<Scalar>& r) { return columns(r, -1, 1); }
  static Rotation<Scalar> columns(const Rotation<Scalar>& r, int first, int second) {
    constexpr std::size_t next = (p + 1) % 3, last = (p + 2) % 3;
    Rotation<Scalar> result = r;
    for (std::size_t x = 0; x < 3; ++x) {
      result[x][next] = Scalar(first) * r[x][last];
      result[x][last] = Scalar(second) * r[x][next];
    }
    return result;
  }

  EulerPlaces places_;
  Scalar limit_;
  bool is_turned_ = false;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_EULER_CHART_HPP
