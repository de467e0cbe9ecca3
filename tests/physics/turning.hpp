#pragma once
// Vectors and rotations, for tests that compare descriptions of one state.

#include <array>
#include <cmath>

namespace physics {

struct Vec : std::array<double, 3> {};

inline Vec cross(const Vec& a, const Vec& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
inline Vec operator+(const Vec& a, const Vec& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Vec operator/(const Vec& a, double b) { return {{a[0] / b, a[1] / b, a[2] / b}}; }

/// Body to space, scalar first.
struct Quaternion {
  double w, x, y, z;

  Vec turned(const Vec& a) const {
    const Vec v{{x, y, z}};
    const Vec once = cross(v, a), twice = cross(v, once);
    return {{a[0] + 2 * (w * once[0] + twice[0]), a[1] + 2 * (w * once[1] + twice[1]),
             a[2] + 2 * (w * once[2] + twice[2])}};
  }
  Vec back(const Vec& a) const { return Quaternion{w, -x, -y, -z}.turned(a); }
};

inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quaternion about_x(double angle) { return {std::cos(angle / 2), std::sin(angle / 2), 0, 0}; }
inline Quaternion about_y(double angle) { return {std::cos(angle / 2), 0, std::sin(angle / 2), 0}; }
inline Quaternion about_z(double angle) { return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; }

}  // namespace physics
