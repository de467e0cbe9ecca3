#include "symbolic/vector.hpp"

namespace gaussgen::symbolic {

Vector3 operator+(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector3 operator-(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector3 operator*(const ex& factor, const Vector3& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

ex dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 multiply(const Matrix3& m, const Vector3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  const Matrix3 columns = transposed(b);
  return transposed({multiply(a, columns[0]), multiply(a, columns[1]), multiply(a, columns[2])});
}

Matrix3 transposed(const Matrix3& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  }
  return result;
}

Vector3 unit_vector(std::size_t axis) {
  Vector3 v{0, 0, 0};
  v[axis] = 1;
  return v;
}

}  // namespace gaussgen::symbolic
