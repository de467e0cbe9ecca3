#pragma once
// Vectors of three expressions and rotations, in one frame at a time.

#include <array>

#include "ir/expr.hpp"

namespace gaussgen::ir {

using Vector3 = std::array<Expr, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< rows

inline Vector3 zero3(Graph& graph) {
  const Expr zero(graph, graph.constant(0));
  return {zero, zero, zero};
}

inline Vector3 unit_vector(Graph& graph, std::size_t axis) {
  Vector3 result = zero3(graph);
  result[axis] = {graph, graph.constant(1)};
  return result;
}

inline Matrix3 identity3(Graph& graph) { return {unit_vector(graph, 0), unit_vector(graph, 1), unit_vector(graph, 2)}; }

inline bool is_zero(const Vector3& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector3 operator-(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }
inline Vector3 operator*(Expr factor, const Vector3& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector3 column(const Matrix3& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

inline Matrix3 transposed(const Matrix3& m) { return {column(m, 0), column(m, 1), column(m, 2)}; }

}  // namespace gaussgen::ir
