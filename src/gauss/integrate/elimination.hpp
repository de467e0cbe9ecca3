// Dependent speeds expressed by independent ones, for a given choice of them: (3.6)-(3.8) of the paper, with numbers.
// SPDX-License-Identifier: MIT
//
// Gauss's principle leaves  g a = f + b^T lambda,  b a + drift = 0  (gauss/constrained.hpp). With as many rows taken, and as
// many speeds dependent on the others, as the rank says, b splits into B_d (taken rows, dependent speeds) and B_i, and
//
//     a_d = a_0 + c a_i,   c = -B_d^-1 B_i,   a_0 = -B_d^-1 drift            (3.6)
//     C^T (g a - f) = 0,   C = [c; 1]                                        (3.7)
//     B_d^T lambda = (g a - f)_d
//
// and (3.8), for reactions of held coordinates, follows from these accelerations and multipliers (`reactions_of_solution`). No
// partition is good everywhere, since det B_d has zeros; which one is good here is what `condition` and `best` say.
#ifndef GAUSS_INTEGRATE_ELIMINATION_HPP
#define GAUSS_INTEGRATE_ELIMINATION_HPP

#include <limits>

#include "gauss/integrate/partition.hpp"

namespace gauss::integrate {

/// The linear system of one state, to be solved for one partition or another. `System` is an emitted LinearSystem.
template <class S, int n, int l>
class Elimination {
 public:
  using Choice = Partition<n, l>;

  template <class System>
  Elimination(const System& system, const RankRule<S>& rule) : at_(system, rule), rule_(rule) {}

  /// By complete pivoting: the largest entry left, of all rows and speeds.
  Choice best() const { return detail::JordanForm<S, n, l>(at_, anything(), rule_).taken(); }

  /// Norm of B_d^-1, inertias 1 and rows scaled to the length that they may have: to be compared with that of another
  /// partition. Infinite where a row of B_d follows from the others.
  S condition(const Choice& partition) const {
    const detail::JordanForm<S, n, l> form(at_, partition, rule_);
    return form.taken().rank < partition.rank ? std::numeric_limits<S>::infinity() : form.condition();
  }

  /// False where the partition does not carry this state, or nearly not: a row of B_d follows from the others, a row that was
  /// not taken says something of its own or contradicts, inertias do not determine what is left, or something is not a number.
  /// `gauss::solve` then decides what holds.
  bool solve(const Choice& partition, LinearSolution<S, n, l>& solution) const {
    return Solver(*this, partition).solve(solution);
  }

 private:
  /// Pivots of elimination and sines of angles, by which `gauss::solve` decides on rank, are not the same but of one size. Within this factor of a
  /// tolerance it is left to `gauss::solve`, so that there is one decision.
  static constexpr int k_margin = 64;

  static Choice anything() {
    Choice all;
    all.rank = n < l ? n : l;
    for (bool& is_taken : all.is_taken) is_taken = true;
    for (bool& is_dependent : all.is_dependent) is_dependent = true;
    return all;
  }

  class Solver {
   public:
    Solver(const Elimination& from, const Choice& partition)
        : at_(from.at_), rule_(from.rule_), partition_(partition), form_(from.at_, partition, from.rule_) {}

    bool solve(LinearSolution<S, n, l>& solution) {
      if (!carries()) return false;
      reduce_metric();
      reduce_shares();
      if (!(metric_.is_determined > S(0))) return false;
      S a[n], lambda[l];
      for (S& value : a) value = S(0);
      for (S& value : lambda) value = S(0);
      for (int pass = 0; pass < k_passes; ++pass) add(a, lambda);
      if (!is_finite(a, lambda)) return false;
      finish(a, lambda, solution);
      return true;
    }

   private:
    static constexpr int k_passes = 2;  ///< the second refines

    bool carries() const {
      if (form_.taken().rank < partition_.rank) return false;
      const S margin = S(k_margin);
      if (!(margin * rule_.tolerance * form_.condition() < S(1))) return false;
      S tolerances[l];
      for (int mu = 0; mu < l; ++mu) tolerances[mu] = partition_.rank < rule_.usual ? rule_.tolerance : at_.least[mu];
      if (!(margin * form_.left_over(tolerances) < S(1))) return false;
      return rule_.is_agreement_known || is_agreed();
    }

    bool is_agreed() const {
      const S noise = Math<S>::sqrt(Math<S>::epsilon()) * at_.demand();
      for (int mu = 0; mu < l; ++mu) {
        if (partition_.is_taken[mu] || follows_from_positions(mu)) continue;
        S rest = at_.c[mu];
        for (int k = 0; k < partition_.rank; ++k) rest = rest - form_.share(mu, k) * at_.c[form_.row(k)];
        if (!(gauss::detail::absolute<S>(rest) <= noise)) return false;
      }
      return true;
    }

    /// Whether the derivative of an equation of positions is in what row mu follows from.
    bool follows_from_positions(int mu) const {
      bool is_found = at_.is_of_positions[mu];
      const S least = Math<S>::sqrt(Math<S>::epsilon());
      for (int k = 0; k < partition_.rank; ++k) {
        const bool takes_part = least < gauss::detail::absolute<S>(form_.share(mu, k));
        is_found = is_found || (takes_part && at_.is_of_positions[form_.row(k)]);
      }
      return is_found;
    }

    /// H = C^T g C of the independent speeds.
    void reduce_metric() {
      S half[n][n], reduced[n][n], counts[n];
      for (int i = 0; i < n; ++i) {
        counts[i] = S(partition_.is_dependent[i] ? 0 : 1);
        for (int j = 0; j < n; ++j) half[i][j] = with_dependent(at_.g[i], j);
      }
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          S column[n];
          for (int k = 0; k < n; ++k) column[k] = half[k][j];
          reduced[i][j] = with_dependent(column, i);
        }
      }
      metric_.factorise(reduced, counts, S(8 * n) * Math<S>::epsilon());
    }

    /// Component i of C^T x, for an independent i: x_i + c^T x_d.
    S with_dependent(const S (&x)[n], int i) const {
      S sum = x[i];
      for (int k = 0; k < partition_.rank; ++k) sum = sum - form_.by_speed(k, i) * x[form_.speed(k)];
      return sum;
    }

    /// 1 + A^T A, where A makes the rows that were not taken of those that were: from it follow the least of all multipliers
    /// with the same force.
    void reduce_shares() {
      S counts[k_most], gram[k_most][k_most];
      for (int k = 0; k < k_most; ++k) {
        counts[k] = S(k < partition_.rank ? 1 : 0);
        for (int m = 0; m < k_most; ++m) {
          gram[k][m] = S(k == m ? 1 : 0);
          if (k >= partition_.rank || m >= partition_.rank) continue;
          for (int mu = 0; mu < l; ++mu) {
            if (!partition_.is_taken[mu]) gram[k][m] = gram[k][m] + form_.share(mu, k) * form_.share(mu, m);
          }
        }
      }
      shares_.factorise(gram, counts, S(0));
    }

    /// What f and c ask for beyond a and lambda, solved for and added to them.
    void add(S (&a)[n], S (&lambda)[l]) const {
      S f[n], c[l], change[n];
      residual(a, lambda, f, c);
      start(c, change);
      S reduced[n];
      for (int i = 0; i < n; ++i) reduced[i] = f[i] - gauss::detail::inner(at_.g[i], change);
      S independent[n];
      for (int i = 0; i < n; ++i) independent[i] = partition_.is_dependent[i] ? S(0) : with_dependent(reduced, i);
      metric_.solve(independent);
      for (int i = 0; i < n; ++i) {
        if (!partition_.is_dependent[i]) change[i] = independent[i];
      }
      for (int k = 0; k < partition_.rank; ++k) {
        for (int i = 0; i < n; ++i) {
          if (partition_.is_dependent[i]) continue;
          change[form_.speed(k)] = change[form_.speed(k)] - form_.by_speed(k, i) * independent[i];
        }
      }
      add_forces(f, change, lambda);
      for (int i = 0; i < n; ++i) a[i] = a[i] + change[i];
    }

    void residual(const S (&a)[n], const S (&lambda)[l], S (&f)[n], S (&c)[l]) const {
      for (int i = 0; i < n; ++i) {
        f[i] = at_.f[i] - gauss::detail::inner(at_.g[i], a);
        for (int mu = 0; mu < l; ++mu) f[i] = f[i] + at_.b[mu][i] * lambda[mu];
      }
      for (int mu = 0; mu < l; ++mu) c[mu] = at_.c[mu] - gauss::detail::inner(at_.b[mu], a);
    }

    /// a_0: independent accelerations are 0.
    void start(const S (&c)[l], S (&a)[n]) const {
      for (S& value : a) value = S(0);
      for (int k = 0; k < partition_.rank; ++k) {
        for (int m = 0; m < partition_.rank; ++m)
          a[form_.speed(k)] = a[form_.speed(k)] + form_.inverse(k, m) * c[form_.row(m)];
      }
    }

    /// B_d^T lambda = (g a - f)_d, shared among all rows.
    void add_forces(const S (&f)[n], const S (&a)[n], S (&lambda)[l]) const {
      S needed[k_most], together[k_most];
      for (int k = 0; k < k_most; ++k) {
        const int i = form_.speed(k);
        needed[k] = k < partition_.rank ? gauss::detail::inner(at_.g[i], a) - f[i] : S(0);
      }
      for (int m = 0; m < k_most; ++m) {
        together[m] = S(0);
        for (int k = 0; m < partition_.rank && k < partition_.rank; ++k)
          together[m] = together[m] + form_.inverse(k, m) * needed[k];
      }
      shares_.solve(together);
      for (int k = 0; k < partition_.rank; ++k) {
        lambda[form_.row(k)] = lambda[form_.row(k)] + together[k];
        for (int mu = 0; mu < l; ++mu) {
          if (!partition_.is_taken[mu]) lambda[mu] = lambda[mu] + form_.share(mu, k) * together[k];
        }
      }
    }

    static bool is_finite(const S (&a)[n], const S (&lambda)[l]) {
      S sum = S(0);
      for (const S& value : a) sum = sum + value * S(0);
      for (const S& value : lambda) sum = sum + value * S(0);
      return !Math<S>::not_finite(sum);
    }

    void finish(const S (&a)[n], const S (&lambda)[l], LinearSolution<S, n, l>& solution) const {
      for (int i = 0; i < n; ++i) solution.accelerations[i] = at_.speed[i] * a[i];
      for (int mu = 0; mu < l; ++mu) {
        solution.multipliers[mu] = at_.row[mu] * lambda[mu];
        solution.is_shared[mu] = S(partition_.is_taken[mu] ? 0 : 1);
      }
      for (int k = 0; k < partition_.rank; ++k) {
        for (int mu = 0; mu < l; ++mu) {
          if (partition_.is_taken[mu]) continue;
          const S share = form_.share(mu, k);
          if (share * share > Math<S>::epsilon()) solution.is_shared[form_.row(k)] = S(1);
        }
      }
      solution.rank = S(partition_.rank);
      const Status less = Status::dependent_constraints;
      solution.motion = solution.step = partition_.rank < rule_.usual ? less : Status::ok;
      solution.reactions = partition_.rank < l ? less : Status::ok;
    }

    static constexpr int k_most = detail::JordanForm<S, n, l>::k_most;

    const detail::ScaledSystem<S, n, l>& at_;
    const RankRule<S>& rule_;
    const Choice& partition_;
    detail::JordanForm<S, n, l> form_;
    gauss::detail::MaskedLdl<S, n> metric_;
    gauss::detail::MaskedLdl<S, k_most> shares_;
  };

  detail::ScaledSystem<S, n, l> at_;
  RankRule<S> rule_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_ELIMINATION_HPP
