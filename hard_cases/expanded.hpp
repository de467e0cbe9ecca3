#pragma once
// A naive form of accelerations: Cramer's rule with determinants multiplied out, as symbolic solution of the equations of motion leaves them.

namespace hard_cases {

/// Of the rows from `row` on and the columns that are left, by its first row: as many products as permutations.
template <int n, class S>
S determinant(const S (&a)[n][n], unsigned columns = (1u << n) - 1, int row = 0) {
  if (row == n) return 1;
  S sum = 0;
  bool is_minus = false;
  for (int j = 0; j < n; ++j) {
    if ((columns >> j & 1u) == 0) continue;
    const S term = a[row][j] * determinant(a, columns & ~(1u << j), row + 1);
    sum += is_minus ? -term : term;
    is_minus = !is_minus;
  }
  return sum;
}

/// x of g x = -missing.
template <int n, class S>
void solve_expanded(const S (&g)[n][n], const S (&missing)[n], S (&x)[n]) {
  const S all = determinant(g);
  for (int i = 0; i < n; ++i) {
    S replaced[n][n];
    for (int row = 0; row < n; ++row)
      for (int j = 0; j < n; ++j) replaced[row][j] = j == i ? -missing[row] : g[row][j];
    x[i] = determinant(replaced) / all;
  }
}

}  // namespace hard_cases
