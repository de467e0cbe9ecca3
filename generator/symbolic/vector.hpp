#pragma once
// Vectors and matrices of expressions: three-dimensional ones, and square ones of any size.

#include <ginac/ginac.h>

#include <array>
#include <cstddef>
#include <vector>

#include "support/index.hpp"

namespace gaussgen::symbolic {

using GiNaC::ex;

using Vector3 = std::array<ex, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< rows
using Matrix = std::vector<std::vector<ex>>;

/// A matrix whose rows and columns have an index type each, so that blocks cannot be mixed up.
template <class RowIndex, class ColumnIndex>
using Table = support::Indexed<RowIndex, support::Indexed<ColumnIndex, ex>>;

template <class IndexType>
using Row = support::Indexed<IndexType, ex>;

template <class RowIndex, class ColumnIndex>
Table<RowIndex, ColumnIndex> zero_table(std::size_t rows, std::size_t columns) {
  return {rows, Row<ColumnIndex>(columns, ex(0))};
}

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(const ex& factor, const Vector3& a);
ex dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 multiply(const Matrix3& m, const Vector3& v);
Matrix3 multiply(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& m);
Vector3 unit_vector(std::size_t axis);

/// Applies f to every component.
template <class F>
Vector3 each(const Vector3& v, F f) {
  return {f(v[0]), f(v[1]), f(v[2])};
}

}  // namespace gaussgen::symbolic
