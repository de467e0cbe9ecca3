#pragma once
// A naive form of every model: elimination that takes pivots up to 1e-9 for zero, whatever their unit.

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace hard_cases {

/// Row echelon form of the first `columns` of a matrix, without other entries in the columns of pivots; returns how many pivots there are. `places[k]` is the
/// column of pivot k.
template <int rows, int columns, int width>
int eliminate_absolute(double (&a)[rows][width], int (&places)[rows]) {
  constexpr double k_zero = 1e-9;
  int rank = 0;
  for (int column = 0; column < columns && rank < rows; ++column) {
    int largest = rank;
    for (int i = rank + 1; i < rows; ++i)
      if (std::abs(a[i][column]) > std::abs(a[largest][column])) largest = i;
    if (std::abs(a[largest][column]) <= k_zero) continue;
    std::swap(a[rank], a[largest]);
    for (int i = 0; i < rows; ++i) {
      if (i == rank) continue;
      const double factor = a[i][column] / a[rank][column];
      for (int j = column; j < width; ++j) a[i][j] -= factor * a[rank][j];
    }
    places[rank++] = column;
  }
  return rank;
}

template <class System>
struct SizesOf {
  static constexpr int n = static_cast<int>(std::extent_v<decltype(System::b), 1>);
  static constexpr int l = static_cast<int>(std::extent_v<decltype(System::b), 0>);
};

/// Accelerations from [g, -b^T; b, 0]; what has no pivot is 0.
template <class System, int n = SizesOf<System>::n>
void accelerations_by_absolute_pivots(const System& system, double (&accelerations)[n]) {
  constexpr int l = SizesOf<System>::l, size = n + l;
  double a[size][size + 1] = {}, x[size] = {};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) a[i][j] = system.g[i][j];
    for (int mu = 0; mu < l; ++mu) a[n + mu][i] = system.b[mu][i], a[i][n + mu] = -system.b[mu][i];
    a[i][size] = system.f[i];
  }
  for (int mu = 0; mu < l; ++mu) a[n + mu][size] = -system.drift[mu];
  int places[size];
  const int rank = eliminate_absolute<size, size>(a, places);
  for (int k = 0; k < rank; ++k) x[places[k]] = a[k][size] / a[k][places[k]];
  for (int i = 0; i < n; ++i) accelerations[i] = x[i];
}

/// Of the rows of constraints.
template <class System>
int rank_by_absolute_pivots(System system) {
  int places[SizesOf<System>::l];
  return eliminate_absolute<SizesOf<System>::l, SizesOf<System>::n>(system.b, places);
}

}  // namespace hard_cases
