// Sums over lower orders in recurrences of power series, for all products of a function at once.
// SPDX-License-Identifier: MIT-0
//
// A coefficient of order k of a product is  a_0 b_k + a_k b_0 + sum_{j=1}^{k-1} a_j b_{k-j}.  The sum knows lower orders only, so those of all
// products are there before the first coefficient of order k is: one column for each. Of numbers, columns of a row are lanes, which compilers put into
// registers without a new order of any sum: each product has factors of its own beside those of its neighbours. Numbers that are registers
// themselves keep each factor once, so that all of them stay in the nearest cache.
#ifndef GAUSS_SERIES_PRODUCTS_HPP
#define GAUSS_SERIES_PRODUCTS_HPP

#include <type_traits>
#include <utility>

#include "gauss/math.hpp"

namespace gauss {

namespace detail {

constexpr int order_within(int order, int most) noexcept { return order < 1 ? 1 : order < most ? order : most; }

/// Columns that are summed at the same time, at most: six registers of four doubles hide the time of an addition, and leave some for what is read. Numbers that are
/// registers themselves leave fewer.
template <class S>
inline constexpr int k_columns_at_once = std::is_arithmetic_v<S> ? 24 : 12;

constexpr int whole_registers(int columns) noexcept { return columns < 1 ? 4 : (columns + 3) / 4 * 4; }

/// Of all columns in as few blocks as there can be, each but the last as wide as the others.
template <class S>
constexpr int columns_of_a_block(int columns) noexcept {
  const int blocks = (columns + k_columns_at_once<S> - 1) / k_columns_at_once<S>;
  return whole_registers((columns + blocks - 1) / blocks);
}

/// Columns from `first` on, of an order of 3 or more. What was stored last is read last. Sums begin with a product: compilers would keep those that begin with 0 in memory.
template <int count, class S, int rows, int columns>
GAUSS_INLINED void add_crosswise(const S (&left)[rows][columns], const S (&right)[rows][columns], int k, int first,
                                 S (&sums)[columns]) {
  S sum[count];
  for (int m = 0; m < count; ++m) sum[m] = left[2][first + m] * right[k - 2][first + m];
  for (int j = 3; j < k; ++j) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + left[j][first + m] * right[k - j][first + m];
  }
  for (int m = 0; m < count; ++m) sums[first + m] = sum[m] + left[1][first + m] * right[k - 1][first + m];
}

/// Likewise of squares, whose terms come in pairs.
template <int count, class S, int rows, int columns>
GAUSS_INLINED void add_squares(const S (&roots)[rows][columns], int k, int first, S (&sums)[columns]) {
  S sum[count];
  const int last = (k - 1) / 2;
  for (int m = 0; m < count; ++m) sum[m] = roots[last][first + m] * roots[k - last][first + m];
  for (int j = last - 1; j > 0; --j) {
    for (int m = 0; m < count; ++m) sum[m] = sum[m] + roots[j][first + m] * roots[k - j][first + m];
  }
  for (int m = 0; m < count; ++m) sums[first + m] = sum[m] + sum[m];
  if (k % 2 == 0) {
    for (int m = 0; m < count; ++m)
      sums[first + m] = sums[first + m] + roots[k / 2][first + m] * roots[k / 2][first + m];
  }
}

/// Of orders 1 and 2, which have no product and one.
template <class S, int rows, int columns>
GAUSS_INLINED void add_first(const S (&left)[rows][columns], const S (&right)[rows][columns], int k,
                             S (&sums)[columns]) {
  for (int m = 0; m < columns; ++m) sums[m] = k < 2 ? S(0) : left[1][m] * right[1][m];
}

/// Coefficients of `factors` values, for `products` of two of them and for `squares`.
template <class S, int rows, int factors, int products, int squares, bool is_number = std::is_arithmetic_v<S>>
struct SeriesFactors {
  static constexpr int n_factors = factors, n_products = products, n_squares = squares;
  alignas(64) S left[rows][whole_registers(products)] = {};
  alignas(64) S right[rows][whole_registers(products)] = {};
  alignas(64) S roots[rows][whole_registers(squares)] = {};
};
/// An odd number, so that rows do not share places of the cache.
template <class S, int rows, int factors, int products, int squares>
struct SeriesFactors<S, rows, factors, products, squares, false> {
  static constexpr int n_factors = factors, n_products = products, n_squares = squares;
  alignas(64) S all[rows][factors | 1];
};

/// Columns in which each factor is: products on the left, those on the right, then squares.
template <int factors, int columns>
struct FactorColumns {
  int begin[factors + 1] = {};
  int column[columns] = {};
};

/// Calls visit(factor, column) of each column, in their order.
template <class Series, class Visit>
constexpr void for_each_factor_column(Visit&& visit) {
  using Factors = decltype(Series::factors);
  constexpr int n = Factors::n_products;
  if constexpr (n > 0) {
    for (int m = 0; m < n; ++m) {
      visit(Series::left[m], m);
      visit(Series::right[m], n + m);
    }
  }
  if constexpr (Factors::n_squares > 0) {
    for (int m = 0; m < Factors::n_squares; ++m) visit(Series::squared[m], 2 * n + m);
  }
}

/// By counting: compilers bound the steps of what they evaluate, and models have thousands of factors.
template <class Series>
constexpr auto factor_columns() {
  using Factors = decltype(Series::factors);
  FactorColumns<Factors::n_factors, 2 * Factors::n_products + Factors::n_squares> result;
  for_each_factor_column<Series>([&](int factor, int) { ++result.begin[factor + 1]; });
  int next[Factors::n_factors + 1] = {};
  for (int factor = 0; factor < Factors::n_factors; ++factor) {
    result.begin[factor + 1] += result.begin[factor];
    next[factor + 1] = result.begin[factor + 1];
  }
  for_each_factor_column<Series>([&](int factor, int column) { result.column[next[factor]++] = column; });
  return result;
}

template <class Series>
inline constexpr auto k_factor_columns = factor_columns<Series>();

template <int column, class Factors, class S>
GAUSS_INLINED void set_column(Factors& factors, int k, const S& value) {
  constexpr int n = Factors::n_products;
  if constexpr (column < n) {
    factors.left[k][column] = value;
  } else if constexpr (column < 2 * n) {
    factors.right[k][column - n] = value;
  } else {
    factors.roots[k][column - 2 * n] = value;
  }
}

template <int begin, class Series, class S, int... i>
GAUSS_INLINED void set_columns(Series& series, int k, const S& value, std::integer_sequence<int, i...>) {
  (set_column<k_factor_columns<Series>.column[begin + i]>(series.factors, k, value), ...);
}

/// Coefficient k of a factor, for sums of higher orders.
template <int factor, class Series, class S>
GAUSS_INLINED void set_factor(Series& series, int k, const S& value) {
  if constexpr (std::is_arithmetic_v<S>) {
    constexpr int begin = k_factor_columns<Series>.begin[factor];
    constexpr int count = k_factor_columns<Series>.begin[factor + 1] - begin;
    set_columns<begin>(series, k, value, std::make_integer_sequence<int, count>());
  } else {
    series.factors.all[k][factor] = value;
  }
}

/// By place, known when code is compiled, so that addresses are.
template <class Series, int m>
inline constexpr int k_left = Series::left[m];
template <class Series, int m>
inline constexpr int k_right = Series::right[m];
template <class Series, int m>
inline constexpr int k_squared = Series::squared[m];

/// Of orders 1 to 3.
template <class S, int rows, int width>
GAUSS_INLINED S sum_of_few(const S (&all)[rows][width], int k, int left, int right) {
  if (k < 2) return S(0);
  const S first = all[1][left] * all[k - 1][right];
  return k < 3 ? first : first + all[2][left] * all[1][right];
}

/// Of factors that are there once. These are stored and read as whole registers, so that nothing waits for what was stored last; that is
/// read last all the same, since it is still being found while sums of the others can begin.
template <class Series, int first, class S, int rows, int width, int... m>
GAUSS_INLINED void add_factors(const S (&all)[rows][width], int k, S* sums, std::integer_sequence<int, m...>) {
  if (k < 4) {
    ((sums[first + m] = sum_of_few(all, k, k_left<Series, first + m>, k_right<Series, first + m>)), ...);
    return;
  }
  S sum[] = {all[2][k_left<Series, first + m>] * all[k - 2][k_right<Series, first + m>]...};
  const auto add = [&](int place, const S& left, const S& right) { sum[place] = sum[place] + left * right; };
  for (int j = 3; j < k - 1; ++j)
    (add(m, all[j][k_left<Series, first + m>], all[k - j][k_right<Series, first + m>]), ...);
  (add(m, all[1][k_left<Series, first + m>], all[k - 1][k_right<Series, first + m>]), ...);
  (add(m, all[k - 1][k_left<Series, first + m>], all[1][k_right<Series, first + m>]), ...);
  ((sums[first + m] = sum[m]), ...);
}

template <class Series, int first, class S, int rows, int width, int... m>
GAUSS_INLINED void add_squared(const S (&all)[rows][width], int k, S* sums, std::integer_sequence<int, m...>) {
  S sum[] = {(static_cast<void>(m), S(0))...};
  for (int j = (k - 1) / 2; j > 0; --j)
    ((sum[m] = sum[m] + all[j][k_squared<Series, first + m>] * all[k - j][k_squared<Series, first + m>]), ...);
  ((sum[m] = sum[m] + sum[m]), ...);
  if (k % 2 == 0)
    ((sum[m] = sum[m] + all[k / 2][k_squared<Series, first + m>] * all[k / 2][k_squared<Series, first + m>]), ...);
  ((sums[first + m] = sum[m]), ...);
}

/// Some columns after others, in straight code.
template <class Series, int first, int count, class S, int rows, int width>
GAUSS_INLINED void add_all_factors(const S (&all)[rows][width], int k, S* sums) {
  constexpr int now = count - first < k_columns_at_once<S> ? count - first : k_columns_at_once<S>;
  add_factors<Series, first>(all, k, sums, std::make_integer_sequence<int, now>());
  if constexpr (first + now < count) add_all_factors<Series, first + now, count>(all, k, sums);
}
template <class Series, int first, int count, class S, int rows, int width>
GAUSS_INLINED void add_all_squared(const S (&all)[rows][width], int k, S* sums) {
  constexpr int now = count - first < k_columns_at_once<S> ? count - first : k_columns_at_once<S>;
  add_squared<Series, first>(all, k, sums, std::make_integer_sequence<int, now>());
  if constexpr (first + now < count) add_all_squared<Series, first + now, count>(all, k, sums);
}

/// sums[m] = sum_{j=1}^{k-1} a[j] b[k - j], a and b the factors left[m] and right[m].
template <class Series, class S, int columns>
GAUSS_INLINED void crosswise(const Series& series, int k, S (&sums)[columns]) {
  if constexpr (std::is_arithmetic_v<S>) {
    const auto& left = series.factors.left;
    const auto& right = series.factors.right;
    if (k < 3) {
      add_first(left, right, k, sums);
      return;
    }
    // Rows are padded to whole registers.
    constexpr int block = columns_of_a_block<S>(columns), rest = columns % block;
    for (int first = 0; first < columns - rest; first += block) add_crosswise<block>(left, right, k, first, sums);
    if constexpr (rest > 0) add_crosswise<rest>(left, right, k, columns - rest, sums);
  } else {
    add_all_factors<Series, 0, decltype(Series::factors)::n_products>(series.factors.all, k, sums);
  }
}

/// sums[m] = sum_{j=1}^{k-1} a[j] a[k - j], a the factor squared[m].
template <class Series, class S, int columns>
GAUSS_INLINED void squares(const Series& series, int k, S (&sums)[columns]) {
  if constexpr (std::is_arithmetic_v<S>) {
    const auto& roots = series.factors.roots;
    if (k < 3) {
      add_first(roots, roots, k, sums);
      return;
    }
    constexpr int block = columns_of_a_block<S>(columns), rest = columns % block;
    for (int first = 0; first < columns - rest; first += block) add_squares<block>(roots, k, first, sums);
    if constexpr (rest > 0) add_squares<rest>(roots, k, columns - rest, sums);
  } else {
    add_all_squared<Series, 0, decltype(Series::factors)::n_squares>(series.factors.all, k, sums);
  }
}

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_SERIES_PRODUCTS_HPP
