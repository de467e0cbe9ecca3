#pragma once
// M u' = f for the few speeds of a mechanism, of a size that is known while compiling.

#include <utility>

namespace bench {

/// M symmetric, its lower half given, by L D Lᵀ; f becomes the solution.
template <int n, class S>
void solve_symmetric(S* M, S* f) {
  for (int j = 0; j < n; ++j) {
    S column[n];
    for (int i = 0; i < j; ++i) {
      S sum = M[j * n + i];
      for (int k = 0; k < i; ++k) sum -= M[i * n + k] * column[k];
      column[i] = sum;
    }
    S pivot = M[j * n + j];
    for (int i = 0; i < j; ++i) {
      M[j * n + i] = column[i] * M[i * n + i];
      pivot -= M[j * n + i] * column[i];
      f[j] -= M[j * n + i] * f[i];
    }
    M[j * n + j] = 1.0 / pivot;
  }
  for (int i = n - 1; i >= 0; --i) {
    S sum = f[i] * M[i * n + i];
    for (int k = i + 1; k < n; ++k) sum -= M[k * n + i] * f[k];
    f[i] = sum;
  }
}

/// By L U with the largest pivot of each column.
template <int n, class S>
void solve_by_pivots(S* M, S* f) {
  using std::fabs;
  for (int j = 0; j < n; ++j) {
    int row = j;
    for (int i = j + 1; i < n; ++i) {
      if (fabs(M[i * n + j]) > fabs(M[row * n + j])) row = i;
    }
    if (row != j) {
      for (int k = j; k < n; ++k) std::swap(M[j * n + k], M[row * n + k]);
      std::swap(f[j], f[row]);
    }
    const S inverse = 1.0 / M[j * n + j];
    M[j * n + j] = inverse;
    for (int i = j + 1; i < n; ++i) {
      const S factor = M[i * n + j] * inverse;
      for (int k = j + 1; k < n; ++k) M[i * n + k] -= factor * M[j * n + k];
      f[i] -= factor * f[j];
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    S sum = f[i];
    for (int k = i + 1; k < n; ++k) sum -= M[i * n + k] * f[k];
    f[i] = sum * M[i * n + i];
  }
}

}  // namespace bench
