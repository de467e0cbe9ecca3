#pragma once
// Speeds in which inertias are 1, as gauss/constrained.hpp has them: in these, angles between gradients of constraints and lengths of them are measured.

#include <cln/float.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gaussgen {

namespace detail {

inline double number_like(int number, double /*like*/) { return number; }
inline cln::cl_F number_like(int number, const cln::cl_F& like) { return cln::cl_float(number, like); }

/// Σ over speeds of (b_μi scale_i)².
template <class T, class Entry>
T square_of_row(std::size_t row, const std::vector<T>& scales, const Entry& entry, const T& zero) {
  T sum = zero;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const T part = entry(row, i) * scales[i];
    sum = sum + part * part;
  }
  return sum;
}

/// 1 over the largest entry along a speed without inertia, beside what has inertia in its row; where nothing has, over the largest.
template <class T, class Entry>
T scale_of_weightless(std::size_t speed, const std::vector<T>& massive, const Entry& entry, const T& zero) {
  T beside = zero, alone = zero;
  for (std::size_t row = 0; row < massive.size(); ++row) {
    using std::abs;
    const T size = abs(entry(row, speed));
    alone = std::max(alone, size);
    if (massive[row] > zero) beside = std::max(beside, T(size / massive[row]));
  }
  const T one = number_like(1, zero);
  const T largest = beside > zero ? beside : alone;
  return largest > zero ? T(one / largest) : one;
}

}  // namespace detail

/// What speeds are multiplied by, of double or CLN's numbers: `entry(row, speed)` are those of `rows` gradients.
template <class T, class Entry>
std::vector<T> speed_scales(const std::vector<T>& inertias, std::size_t rows, const Entry& entry, const T& zero) {
  using std::sqrt;
  std::vector<T> scales, massive;
  for (const T& inertia : inertias)
    scales.push_back(inertia > zero ? T(detail::number_like(1, zero) / sqrt(inertia)) : zero);
  for (std::size_t row = 0; row < rows; ++row) massive.push_back(sqrt(detail::square_of_row(row, scales, entry, zero)));
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (!(inertias[i] > zero)) scales[i] = detail::scale_of_weightless(i, massive, entry, zero);
  }
  return scales;
}

}  // namespace gaussgen
