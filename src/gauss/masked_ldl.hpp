// A factorisation of part of a symmetric matrix.
// SPDX-License-Identifier: MIT-0
#ifndef GAUSS_MASKED_LDL_HPP
#define GAUSS_MASKED_LDL_HPP

#include "gauss/selections.hpp"

namespace gauss {

namespace detail {

/// L D L^T of a symmetric matrix of which some rows and columns count as those of the unit matrix. It has n of them, N at most.
template <class S, int N, class Count = Known<N>>
class MaskedLdl {
 public:
  GAUSS_FUNCTION explicit MaskedLdl(Count size = {}) : n(size) {}

  /// `counts[i]` 1: row i is that of `matrix`; 0: of the unit matrix. A pivot below `tolerance` of what it is the rest of determines nothing.
  GAUSS_FUNCTION void factorise(const S (&matrix)[N][N], const S (&counts)[N], const S& tolerance) {
    is_determined = S(1);
    S back[N][N];  // L^-1
    for (int j = 0; j < n; ++j) {
      const S size = size_of_pivot(matrix, counts, j, back);
      for (int i = j; i < n; ++i) {
        S entry = masked(matrix, counts, i, j);
        for (int k = 0; k < j; ++k) entry = entry - factor_[i][k] * factor_[j][k] * pivot_[k];
        if (i == j) {
          const S is_good = positive<S>(entry - tolerance * size);
          is_determined = is_determined * is_good;
          pivot_[j] = entry;
          inverse_[j] = reciprocal(entry, is_good);
        } else {
          factor_[i][j] = entry * inverse_[j];
        }
      }
    }
  }

  GAUSS_FUNCTION void solve(S (&x)[N]) const {
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < i; ++k) x[i] = x[i] - factor_[i][k] * x[k];
    }
    for (int i = n - 1; i >= 0; --i) {
      x[i] = x[i] * inverse_[i];
      for (int k = i + 1; k < n; ++k) x[i] = x[i] - factor_[k][i] * x[k];
    }
  }

  S is_determined;

 private:
  GAUSS_FUNCTION static S masked(const S (&matrix)[N][N], const S (&counts)[N], int i, int j) {
    return Math<S>::select(Math<S>::less(S(0), counts[i] * counts[j]), matrix[i][j], S(i == j ? 1 : 0));
  }

  /// p = w^T matrix w for the row w of L^-1. A pivot that is small makes large factors, and with them what the next ones are the rest of.
  GAUSS_FUNCTION S size_of_pivot(const S (&matrix)[N][N], const S (&counts)[N], int j, S (&back)[N][N]) const {
    S size = masked(matrix, counts, j, j);
    for (int i = 0; i < j; ++i) {
      back[j][i] = -factor_[j][i];
      for (int k = i + 1; k < j; ++k) back[j][i] = back[j][i] - factor_[j][k] * back[k][i];
      size = size + back[j][i] * back[j][i] * masked(matrix, counts, i, i);
    }
    return size;
  }

  Count n;
  S factor_[N][N];
  S pivot_[N];
  S inverse_[N];
};

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_MASKED_LDL_HPP
