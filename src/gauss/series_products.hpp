// Sums over lower orders in recurrences of power series, for all products of a function at once.
// SPDX-License-Identifier: MIT-0
//
// A coefficient of order k of a product is  a_0 b_k + a_k b_0 + sum_{j=1}^{k-1} a_j b_{k-j}.  The sum knows lower orders only, so those of all
// products are there before the first coefficient of order k is: one column for each. Columns are lanes, which compilers put into
// registers without a new order of any sum.
#ifndef GAUSS_SERIES_PRODUCTS_HPP
#define GAUSS_SERIES_PRODUCTS_HPP

#include "gauss/math.hpp"

namespace gauss {

namespace detail {

constexpr int order_within(int order, int most) noexcept { return order < 1 ? 1 : order < most ? order : most; }

/// Of `count` columns from `first` on. What was stored last is read last.
template <int count, class S, int rows, int columns>
GAUSS_INLINED void add_crosswise(const S (&left)[rows][columns], const S (&right)[rows][columns], int k, int first,
                                 S (&sums)[columns]) {
  S sum[count];
  for (int m = 0; m < count; ++m) sum[m] = S(0);
  for (int j = 2; j < k - 1; ++j) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + left[j][first + m] * right[k - j][first + m];
  }
  if (k > 2) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + left[1][first + m] * right[k - 1][first + m];
  }
  if (k > 1) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + left[k - 1][first + m] * right[1][first + m];
  }
  for (int m = 0; m < count; ++m) sums[first + m] = sum[m];
}

/// Likewise of squares, whose terms come in pairs.
template <int count, class S, int rows, int columns>
GAUSS_INLINED void add_squares(const S (&roots)[rows][columns], int k, int first, S (&sums)[columns]) {
  S sum[count];
  for (int m = 0; m < count; ++m) sum[m] = S(0);
  for (int j = (k - 1) / 2; j > 0; --j) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + roots[j][first + m] * roots[k - j][first + m];
  }
  for (int m = 0; m < count; ++m) sum[m] = sum[m] + sum[m];
  if (k % 2 == 0) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + roots[k / 2][first + m] * roots[k / 2][first + m];
  }
  for (int m = 0; m < count; ++m) sums[first + m] = sum[m];
}

/// Columns that are summed at the same time: four registers of four doubles hide the time of an addition. Of numbers that are registers themselves, as many
/// as leave some for what is read.
template <class S>
inline constexpr int k_columns_at_once = std::is_arithmetic_v<S> ? 16 : 12;

/// Rows are padded to whole registers, which numbers that are no such lanes do not need.
template <class S>
constexpr int columns_to_sum(int used, int padded) noexcept {
  return std::is_arithmetic_v<S> ? padded : used;
}

/// sums[m] = sum_{j=1}^{k-1} left[j][m] right[k - j][m], of `used` columns.
template <int used, class S, int rows, int columns>
GAUSS_INLINED void crosswise(const S (&left)[rows][columns], const S (&right)[rows][columns], int k,
                             S (&sums)[columns]) {
  constexpr int count = columns_to_sum<S>(used, columns);
  constexpr int rest = count % k_columns_at_once<S>;
  if constexpr (count > rest) {
    for (int first = 0; first < count - rest; first += k_columns_at_once<S>)
      add_crosswise<k_columns_at_once<S>>(left, right, k, first, sums);
  }
  if constexpr (rest > 0) add_crosswise<rest>(left, right, k, count - rest, sums);
}

/// sums[m] = sum_{j=1}^{k-1} roots[j][m] roots[k - j][m].
template <int used, class S, int rows, int columns>
GAUSS_INLINED void squares(const S (&roots)[rows][columns], int k, S (&sums)[columns]) {
  constexpr int count = columns_to_sum<S>(used, columns);
  constexpr int rest = count % k_columns_at_once<S>;
  if constexpr (count > rest) {
    for (int first = 0; first < count - rest; first += k_columns_at_once<S>)
      add_squares<k_columns_at_once<S>>(roots, k, first, sums);
  }
  if constexpr (rest > 0) add_squares<rest>(roots, k, count - rest, sums);
}

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_SERIES_PRODUCTS_HPP
