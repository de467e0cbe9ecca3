// Attitudes by three angles about axes of the body: matrix and angular velocity of angles, and back.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_EULER_ANGLES_HPP
#define GAUSS_INTEGRATE_EULER_ANGLES_HPP

#include <array>
#include <cmath>
#include <cstddef>

namespace gauss::integrate {

template <class Scalar>
using Vector3 = std::array<Scalar, 3>;

/// From body to space; [row][column].
template <class Scalar>
using Rotation = std::array<Vector3<Scalar>, 3>;

template <class Scalar>
Rotation<Scalar> product(const Rotation<Scalar>& a, const Rotation<Scalar>& b) {
  Rotation<Scalar> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return result;
}

/// Of a quaternion of unit length, scalar part first, as models have it.
template <class Scalar>
Rotation<Scalar> rotation_of(const std::array<Scalar, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// `EulerSequence<'z', 'x', 'z'>` is `{euler: zxz}` of a model: R = R_z(a_0) R_x(a_1) R_z(a_2). Its pole is where the first axis and the last are one: of
/// sin a_1 = 0 if they have one name, else of cos a_1 = 0.
template <char first, char second, char third>
struct EulerSequence {
  static_assert(first >= 'x' && first <= 'z' && second >= 'x' && second <= 'z' && third >= 'x' && third <= 'z',
                "three letters out of x, y, z are expected");
  static_assert(first != second && second != third, "turns about one axis after each other are one turn");

  static constexpr std::size_t i = first - 'x', j = second - 'x', k = third - 'x';
  static constexpr bool is_proper = i == k;
  /// The axis that is neither the first nor the second.
  static constexpr std::size_t m = 3 - i - j;
  /// 1 where i, j, m are in the order of x, y, z, x, ..., else -1.
  static constexpr int sign = (i + 1) % 3 == j ? 1 : -1;

  template <class Scalar>
  static Rotation<Scalar> rotation(const Vector3<Scalar>& angles) {
    return product(product(turn(i, angles[0]), turn(j, angles[1])), turn(k, angles[2]));
  }

  /// |sin| or |cos| of the second angle, from which it follows how well rates are determined.
  template <class Scalar>
  static Scalar distance_from_pole(const Rotation<Scalar>& r) {
    return is_proper ? std::hypot(r[i][j], r[i][m]) : std::hypot(r[i][i], r[i][j]);
  }

  /// Away from the pole. The first and the last are within half a turn, the second is in [0, pi] or [-pi/2, pi/2].
  template <class Scalar>
  static Vector3<Scalar> angles(const Rotation<Scalar>& r) {
    const Scalar s(sign), across = distance_from_pole(r);
    if constexpr (is_proper) {
      return {std::atan2(r[j][i], -s * r[m][i]), std::atan2(across, r[i][i]), std::atan2(r[i][j], s * r[i][m])};
    } else {
      return {std::atan2(-s * r[j][k], r[k][k]), std::atan2(s * r[i][k], across), std::atan2(-s * r[i][j], r[i][i])};
    }
  }

  /// In the axes of space.
  template <class Scalar>
  static Vector3<Scalar> angular_velocity(const Vector3<Scalar>& angles, const Vector3<Scalar>& rates) {
    const Axes<Scalar> axes(angles);
    Vector3<Scalar> result;
    for (std::size_t x = 0; x < 3; ++x)
      result[x] = axes.of_first[x] * rates[0] + axes.of_second[x] * rates[1] + axes.of_third[x] * rates[2];
    return result;
  }

  /// Away from the pole.
  template <class Scalar>
  static Vector3<Scalar> rates(const Vector3<Scalar>& angles, const Vector3<Scalar>& angular_velocity) {
    const Axes<Scalar> axes(angles);
    // The second axis is normal to the others, which are not to each other.
    const Scalar along = angular_velocity[i], c = axes.of_third[i];
    const Scalar third_rate = (inner(angular_velocity, axes.of_third) - c * along) / (1 - c * c);
    return {along - c * third_rate, inner(angular_velocity, axes.of_second), third_rate};
  }

 private:
  /// Of the three turns, in space.
  template <class Scalar>
  struct Axes {
    explicit Axes(const Vector3<Scalar>& angles) {
      const Rotation<Scalar> after_first = turn(i, angles[0]);
      const Rotation<Scalar> after_second = product(after_first, turn(j, angles[1]));
      for (std::size_t x = 0; x < 3; ++x) {
        of_first[x] = Scalar(x == i ? 1 : 0);
        of_second[x] = after_first[x][j];
        of_third[x] = after_second[x][k];
      }
    }
    Vector3<Scalar> of_first, of_second, of_third;
  };

  template <class Scalar>
  static Scalar inner(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  template <class Scalar>
  static Rotation<Scalar> turn(std::size_t axis, const Scalar& angle) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    Rotation<Scalar> result{};
    result[axis][axis] = 1;
    result[next][next] = result[last][last] = std::cos(angle);
    result[last][next] = std::sin(angle);
    result[next][last] = -result[last][next];
    return result;
  }
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_EULER_ANGLES_HPP
