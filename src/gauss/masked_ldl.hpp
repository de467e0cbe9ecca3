// A factorisation of part of a symmetric matrix.
// SPDX-License-Identifier: MIT-0
#ifndef GAUSS_MASKED_LDL_HPP
#define GAUSS_MASKED_LDL_HPP

#include "gauss/selections.hpp"

namespace gauss {

namespace detail {

/// L D L^T of a symmetric matrix of which some rows and columns count as those of the unit matrix.
template <class S, int n>
class MaskedLdl {
 public:
  /// `counts[i]` 1: row i is that of `matrix`; 0: of the unit matrix. A pivot below `tolerance` of its diagonal entry determines nothing.
  GAUSS_FUNCTION void factorise(const S (&matrix)[n][n], const S (&counts)[n], const S& tolerance) {
    is_determined = S(1);
    for (int j = 0; j < n; ++j) {
      for (int i = j; i < n; ++i) {
        const S both = counts[i] * counts[j];
        S entry = Math<S>::select(Math<S>::less(S(0), both), matrix[i][j], S(i == j ? 1 : 0));
        const S diagonal = entry;
        for (int k = 0; k < j; ++k) entry = entry - factor_[i][k] * factor_[j][k] * pivot_[k];
        if (i == j) {
          const S is_good = positive<S>(entry - tolerance * diagonal);
          is_determined = is_determined * is_good;
          pivot_[j] = entry;
          inverse_[j] = reciprocal(entry, is_good);
        } else {
          factor_[i][j] = entry * inverse_[j];
        }
      }
    }
  }

  GAUSS_FUNCTION void solve(S (&x)[n]) const {
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
  S factor_[n][n];
  S pivot_[n];
  S inverse_[n];
};

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_MASKED_LDL_HPP
