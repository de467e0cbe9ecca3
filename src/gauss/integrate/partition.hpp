// Which speeds depend on which, by which constraints: the index sets mu and p of (3.6), scaled rows, and their elimination.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_PARTITION_HPP
#define GAUSS_INTEGRATE_PARTITION_HPP

#include "gauss/constrained.hpp"

namespace gauss::integrate {

/// Of n speeds and l constraints. What is true of `rank` rows and of `rank` speeds.
template <int n, int l>
struct Partition {
  int rank = 0;
  bool is_taken[l] = {};      ///< these rows determine the dependent speeds; the others follow from them
  bool is_dependent[n] = {};  ///< speeds
};

template <int n, int l>
bool operator==(const Partition<n, l>& a, const Partition<n, l>& b) {
  bool is_same = a.rank == b.rank;
  for (int mu = 0; mu < l; ++mu) is_same = is_same && a.is_taken[mu] == b.is_taken[mu];
  for (int i = 0; i < n; ++i) is_same = is_same && a.is_dependent[i] == b.is_dependent[i];
  return is_same;
}

template <int n, int l>
bool operator!=(const Partition<n, l>& a, const Partition<n, l>& b) {
  return !(a == b);
}

namespace detail {

/// Inertias to 1 and rows to unit length, as gauss/constrained.hpp has it, and for its reasons.
template <class S, int n, int l>
struct ScaledSystem {
  S g[n][n], f[n], b[l][n], c[l];  ///< b a = c
  S speed[n], row[l];              ///< scales
  S least[l];                      ///< what is asked of a row beyond the usual rank
  bool is_of_positions[l];

  template <class System>
  ScaledSystem(const System& system, const RankRule<S>& rule) {
    scale_speeds(system);
    for (int mu = 0; mu < l; ++mu) {
      scale_row(system, mu);
      least[mu] = gauss::detail::beyond_usual<S>(system, rule, mu);
    }
    for (int i = 0; i < n; ++i) {
      f[i] = speed[i] * system.f[i];
      for (int j = 0; j < n; ++j) g[i][j] = speed[i] * system.g[i][j] * speed[j];
    }
  }

  /// Largest of what forces and constraints ask for.
  S demand() const {
    S largest = S(0);
    for (int i = 0; i < n; ++i) largest = gauss::detail::larger<S>(largest, gauss::detail::absolute<S>(f[i]));
    for (int mu = 0; mu < l; ++mu) largest = gauss::detail::larger<S>(largest, gauss::detail::absolute<S>(c[mu]));
    return largest;
  }

 private:
  template <class System>
  void scale_speeds(const System& system) {
    for (int i = 0; i < n; ++i) speed[i] = system.g[i][i] > S(0) ? S(1) / Math<S>::sqrt(system.g[i][i]) : S(0);
    S of_massive[l];
    for (int mu = 0; mu < l; ++mu) of_massive[mu] = length(system.b[mu]);
    for (int i = 0; i < n; ++i) {
      if (system.g[i][i] > S(0)) continue;
      S beside = S(0), alone = S(0);
      for (int mu = 0; mu < l; ++mu) {
        const S size = gauss::detail::absolute<S>(system.b[mu][i]);
        alone = gauss::detail::larger<S>(alone, size);
        if (of_massive[mu] > S(0)) beside = gauss::detail::larger<S>(beside, size / of_massive[mu]);
      }
      const S largest = beside > S(0) ? beside : alone;
      speed[i] = largest > S(0) ? S(1) / largest : S(1);
    }
  }

  template <class System>
  void scale_row(const System& system, int mu) {
    const S rounding = S(8) * Math<S>::epsilon();
    for (int i = 0; i < n; ++i) {
      const S entry = system.b[mu][i];
      b[mu][i] = gauss::detail::absolute<S>(entry) < rounding * system.reach[mu][i] ? S(0) : entry;
    }
    const S size = length(b[mu]);
    const S part = gauss::detail::part_of_reach(b[mu], system.reach[mu]);
    const S usual = gauss::detail::usual_size<S>(size, length(system.reach[mu]), part);
    row[mu] = size > S(0) ? S(1) / usual : S(0);
    for (int i = 0; i < n; ++i) b[mu][i] = row[mu] * b[mu][i] * speed[i];
    is_of_positions[mu] = system.of_positions[mu] > S(0);
    c[mu] = -(size > S(0) ? row[mu] : S(1)) * system.drift[mu];
  }

  S length(const S (&entries)[n]) const {
    S squares = S(0);
    for (int i = 0; i < n; ++i) squares = squares + entries[i] * speed[i] * (entries[i] * speed[i]);
    return gauss::detail::root<S>(squares);
  }
};

/// Gauss-Jordan elimination of [b | 1] with complete pivoting, among the rows and speeds that may be pivots.
template <class S, int n, int l>
class JordanForm {
 public:
  static constexpr int k_most = n < l ? n : l;

  JordanForm(const ScaledSystem<S, n, l>& at, const Partition<n, l>& allowed, const RankRule<S>& rule) {
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < n; ++i) rows_[mu][i] = at.b[mu][i];
      for (int nu = 0; nu < l; ++nu) rows_[mu][n + nu] = S(mu == nu ? 1 : 0);
    }
    S usual[l];
    for (S& tolerance : usual) tolerance = rule.tolerance;
    while (taken_.rank < allowed.rank) {
      if (!take_largest(allowed, taken_.rank < rule.usual ? usual : at.least)) break;
    }
  }

  const Partition<n, l>& taken() const { return taken_; }
  int row(int k) const { return row_[k]; }
  int speed(int k) const { return speed_[k]; }

  /// Entry of B_d^-1 B in the row of the k-th dependent speed.
  const S& by_speed(int k, int i) const { return rows_[row_[k]][i]; }
  /// Of B_d^-1, for the row that was taken m-th.
  const S& inverse(int k, int m) const { return rows_[row_[k]][n + row_[m]]; }
  /// How much of the row that was taken k-th is in row mu, which was not taken.
  S share(int mu, int k) const { return -rows_[mu][n + row_[k]]; }

  /// What rows that were not taken say beside those that were, of what is asked of each.
  S left_over(const S (&tolerances)[l]) const {
    S largest = S(0);
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < n; ++i) {
        if (taken_.is_taken[mu] || taken_.is_dependent[i]) continue;
        largest = gauss::detail::larger<S>(largest, gauss::detail::absolute<S>(rows_[mu][i]) / tolerances[mu]);
      }
    }
    return largest;
  }

  /// Largest sum of a row of B_d^-1. Rows of b are scaled, so this is how much their errors grow.
  S condition() const {
    S largest = S(taken_.rank == 0 ? 1 : 0);
    for (int k = 0; k < taken_.rank; ++k) {
      S sum = S(0);
      for (int m = 0; m < taken_.rank; ++m) sum = sum + gauss::detail::absolute<S>(inverse(k, m));
      largest = gauss::detail::larger<S>(largest, sum);
    }
    return largest;
  }

 private:
  /// Beside what is asked of its row.
  bool take_largest(const Partition<n, l>& allowed, const S (&tolerances)[l]) {
    S largest = S(1);
    int row = -1, speed = -1;
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < n; ++i) {
        if (!allowed.is_taken[mu] || taken_.is_taken[mu] || !allowed.is_dependent[i] || taken_.is_dependent[i])
          continue;
        const S size = gauss::detail::absolute<S>(rows_[mu][i]) / tolerances[mu];
        if (!(size > largest)) continue;
        largest = size;
        row = mu;
        speed = i;
      }
    }
    if (row < 0) return false;
    eliminate(row, speed);
    return true;
  }

  void eliminate(int row, int speed) {
    const S pivot = rows_[row][speed];
    for (S& entry : rows_[row]) entry = entry / pivot;
    for (int mu = 0; mu < l; ++mu) {
      if (mu == row) continue;
      const S factor = rows_[mu][speed];
      for (int i = 0; i < n + l; ++i) rows_[mu][i] = rows_[mu][i] - factor * rows_[row][i];
      rows_[mu][speed] = S(0);
    }
    row_[taken_.rank] = row;
    speed_[taken_.rank] = speed;
    taken_.is_taken[row] = taken_.is_dependent[speed] = true;
    ++taken_.rank;
  }

  S rows_[l][n + l];
  int row_[k_most] = {}, speed_[k_most] = {};
  Partition<n, l> taken_;
};

}  // namespace detail

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_PARTITION_HPP
