// Accelerations and multipliers of any constrained system, whatever its rank: what emitted functions turn to where their
// own, cheaper way has lost its digits.
// SPDX-License-Identifier: MIT-0
//
// Gauss's principle leaves the linear problem  g a = f + b^T lambda,  b a + drift = 0  (theory, section 3). It is scaled by inertias and
// by rows, b^T is factorised by Householder reflections with pivoting, what the constraints leave free is found from g there
// (null space), and the whole is refined once: Golub and Van Loan, Matrix Computations, 4th ed., 5.4 and 6.2. So g may be singular where
// constraints complete it, rows may follow from each other, and the error is that of the condition number, not of its square. All choices are selections, so that
// the lanes of a batch may differ; there is no allocation.
#ifndef GAUSS_CONSTRAINED_HPP
#define GAUSS_CONSTRAINED_HPP

#include "gauss/lost_lanes.hpp"
#include "gauss/masked_ldl.hpp"
#include "gauss/rank_rule.hpp"

namespace gauss {

/// Of n speeds and l constraints.
template <class S, int n, int l>
struct LinearSolution {
  S accelerations[n];
  /// Of those that do, the least: in the sum of (length_mu lambda_mu)^2, with the lengths of rows where inertias are 1 (detail::usual_size).
  S multipliers[l];
  S is_shared[l];  ///< 1: the multiplier is not unique, another constraint can do what this one does; else 0
  S rank;          ///< of b, to the tolerance
  /// singular_mass_matrix: something is not determined; dependent_constraints: fewer rows than usual say something; violated_constraints: they contradict each other
  StatusOf<S> motion;
  StatusOf<S> step;       ///< the same without the last, of a step of Newton's method
  StatusOf<S> reactions;  ///< the same, and dependent_constraints where multipliers are not unique
};

namespace detail {

/// Of the entry that is largest beside what it may be: whatever units and inertias are.
template <class S, int N, class Count = Known<N>>
GAUSS_FUNCTION S part_of_reach(const S (&row)[N], const S (&reach)[N], Count n = {}) {
  S part = S(0);
  for (int i = 0; i < n; ++i)
    part = larger<S>(part, absolute<S>(row[i]) * reciprocal<S>(reach[i], positive<S>(reach[i])));
  return part;
}

/// The length by which a row is divided. One that nearly vanishes beside what it may be is nearly nothing: beside the equations of positions it has the
/// direction of errors. But something light that it does not move here makes no row small, unless all of its entries are: `part`.
template <class S>
GAUSS_FUNCTION S usual_size(const S& size, const S& reach, const S& part) {
  const S least = Math<S>::sqrt(Math<S>::sqrt(Math<S>::epsilon()));
  const S share = Math<S>::select(Math<S>::less(part, least), part, least);
  const S limit = size * reciprocal<S>(share, positive<S>(share));
  return larger(size, Math<S>::select(Math<S>::less(reach, limit), reach, limit));
}

/// Of a system of n speeds and l constraints that compilers know. Whoever learns them at run time only has a struct of the same members, with arrays for
/// N and L at most.
template <int speeds, int rows>
struct KnownSizes {
  static constexpr int N = speeds, L = rows;
  Known<speeds> n;
  Known<rows> l;
  Known<(speeds < rows ? speeds : rows)> most;  ///< rows that can say something of their own
};

template <class S, class Sizes>
class Constrained : Sizes {
  using Bool = typename Math<S>::Bool;
  using Sizes::n, Sizes::l, Sizes::most;
  static constexpr int N = Sizes::N, L = Sizes::L, M = N < L ? N : L;

 public:
  template <class System>
  GAUSS_FUNCTION Constrained(const System& system, const RankRule<S>& rule, const Sizes& sizes = {})
      : Sizes(sizes), is_agreement_known_(rule.is_agreement_known), free_(sizes.n), shares_(sizes.l) {
    scale(system);
    for (int mu = 0; mu < l; ++mu) beyond_[mu] = beyond_usual<S>(system, rule, mu);
    factorise_rows(rule);
    reduce_metric();
    find_shared();
    find_asked(system);
  }

  GAUSS_FUNCTION void solve(LinearSolution<S, N, L>& solution) const {
    S a[N], lambda[L];
    const S contradiction = solve_for(f_, c_, a, lambda);
    finish(a, lambda, contradiction, solution);
  }

  /// With other forces and drifts.
  GAUSS_FUNCTION void respond(const S (&force)[N], const S (&drift)[L], S (&accelerations)[N]) const {
    S f[N], c[L], a[N], lambda[L];
    for (int i = 0; i < n; ++i) f[i] = speed_scale_[i] * force[i];
    for (int mu = 0; mu < l; ++mu) c[mu] = -row_scale_[mu] * drift[mu];
    (void)solve_for(f, c, a, lambda);
    for (int i = 0; i < n; ++i) accelerations[i] = speed_scale_[i] * a[i];
  }

 private:
  /// Returns by how much rows contradict each other.
  GAUSS_FUNCTION S solve_for(const S (&f)[N], const S (&c)[L], S (&a)[N], S (&lambda)[L]) const {
    for (int i = 0; i < n; ++i) a[i] = S(0);
    for (int mu = 0; mu < l; ++mu) lambda[mu] = S(0);
    S left_of_f[N], left_of_c[L], contradiction = S(0);
    for (int pass = 0; pass < 2; ++pass) {
      residual(f, c, a, lambda, left_of_f, left_of_c);
      const S found = add(left_of_f, left_of_c, a, lambda);
      if (pass == 0) contradiction = found;
    }
    return contradiction;
  }

  /// Inertias to 1, rows to unit length. What has no inertia is measured by the rows.
  template <class System>
  GAUSS_FUNCTION void scale(const System& system) {
    S massive[N];
    for (int i = 0; i < n; ++i) {
      massive[i] = positive<S>(system.g[i][i]);
      speed_scale_[i] = root(reciprocal(system.g[i][i], massive[i]));
    }
    S of_massive[L];
    for (int mu = 0; mu < l; ++mu) of_massive[mu] = length(system.b[mu]);
    for (int i = 0; i < n; ++i) {
      S beside = S(0), alone = S(0);
      for (int mu = 0; mu < l; ++mu) {
        const S size = absolute(system.b[mu][i]);
        beside = larger(beside, size * reciprocal(of_massive[mu], positive<S>(of_massive[mu])));
        alone = larger(alone, size);
      }
      const S largest = Math<S>::select(Math<S>::less(S(0), beside), beside, alone);
      const S measured = Math<S>::select(Math<S>::less(S(0), largest), reciprocal(largest, positive<S>(largest)), S(1));
      speed_scale_[i] = Math<S>::select(Math<S>::less(S(0), massive[i]), speed_scale_[i], measured);
    }
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < n; ++i) b_[mu][i] = without_rounding(system.b[mu][i], system.reach[mu][i]);
      const S size = length(b_[mu]);
      const S usual = usual_size(size, length(system.reach[mu]), part_of_reach(b_[mu], system.reach[mu], n));
      row_scale_[mu] = reciprocal(usual, positive<S>(size));
      for (int i = 0; i < n; ++i) b_[mu][i] = row_scale_[mu] * b_[mu][i] * speed_scale_[i];
      // A row of zeros that asks for something is contradictory; its scale is lost.
      const S of_demands = Math<S>::select(Math<S>::less(S(0), size), row_scale_[mu], S(1));
      c_[mu] = -of_demands * system.drift[mu];
      c_error_[mu] = of_demands * system.drift_error[mu];
    }
    find_lost_entries();
    for (int i = 0; i < n; ++i) {
      f_[i] = speed_scale_[i] * system.f[i];
      for (int j = 0; j < n; ++j) g_[i][j] = speed_scale_[i] * system.g[i][j] * speed_scale_[j];
    }
  }

  GAUSS_FUNCTION static S without_rounding(const S& entry, const S& reach) {
    return Math<S>::select(Math<S>::less(absolute(entry), S(8) * Math<S>::epsilon() * reach), S(0), entry);
  }

  GAUSS_FUNCTION S length(const S (&row)[N]) const {
    S squares = S(0);
    for (int i = 0; i < n; ++i) squares = squares + row[i] * speed_scale_[i] * (row[i] * speed_scale_[i]);
    return root(squares);
  }

  /// Inertias may be apart as far as squares of small entries of a row are numbers. One that is small by itself is nothing, such as the coordinate of what
  /// stands at 0: that is left by rounding.
  GAUSS_FUNCTION void find_lost_entries() {
    const S least = Math<S>::epsilon() * Math<S>::epsilon() * Math<S>::sqrt(Math<S>::epsilon());
    has_lost_entries_ = S(0);
    for (int mu = 0; mu < l; ++mu) {
      S lightest = S(0);
      for (int i = 0; i < n; ++i) lightest = larger(lightest, positive(absolute(b_[mu][i])) * speed_scale_[i]);
      for (int i = 0; i < n; ++i) {
        const S size = absolute(b_[mu][i]);
        const S by_inertia = positive<S>(Math<S>::epsilon() * lightest - speed_scale_[i]);
        has_lost_entries_ = larger(has_lost_entries_, positive(size) * positive<S>(least - size) * by_inertia);
      }
    }
  }

  /// b^T P = Q R. At each step the row that is longest across all before is next; beyond the usual rank, longest beside what is asked of it.
  GAUSS_FUNCTION void factorise_rows(const RankRule<S>& rule) {
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < n; ++i) r_[mu][i] = b_[mu][i];
    }
    for (int i = 0; i < n; ++i) is_row_[i] = S(0);
    rank_ = S(0);
    is_full_ = S(1);
    S goes_on = S(1);
    for (int k = 0; k < most; ++k) {
      bring_longest(k, k >= rule.usual);
      bring_largest(k);
      const S size = root(squares_from(k, r_[k]));
      goes_on = goes_on * positive<S>(size - (k < rule.usual ? rule.tolerance : beyond_[k]));
      if (k < rule.usual) is_full_ = goes_on;
      is_row_[k] = goes_on;
      rank_ = rank_ + goes_on;
      reflect(k, size);
    }
  }

  GAUSS_FUNCTION S squares_from(int k, const S (&row)[N]) const {
    S sum = S(0);
    for (int i = k; i < n; ++i) sum = sum + row[i] * row[i];
    return sum;
  }

  GAUSS_FUNCTION void bring_longest(int k, bool is_beyond) {
    S longest = squares_from(k, r_[k]);
    for (int j = k + 1; j < l; ++j) {
      const S other = squares_from(k, r_[j]);
      swapped_[k][j] = is_beyond ? Math<S>::less(longest * (beyond_[j] * beyond_[j]), other * (beyond_[k] * beyond_[k]))
                                 : Math<S>::less(longest, other);
      longest = Math<S>::select(swapped_[k][j], other, longest);
      swap_where<S>(swapped_[k][j], beyond_[k], beyond_[j]);
      for (int i = 0; i < n; ++i) swap_where<S>(swapped_[k][j], r_[k][i], r_[j][i]);
    }
  }

  /// Speeds, too: so reflections keep the digits of small entries beside large ones, as of what is light beside what is heavy (Cox and
  /// Higham, Stability of Householder QR factorization for weighted least squares problems, 1998).
  GAUSS_FUNCTION void bring_largest(int k) {
    S largest = absolute(r_[k][k]);
    for (int i = k + 1; i < n; ++i) {
      const S other = absolute(r_[k][i]);
      moved_[k][i] = Math<S>::less(largest, other);
      largest = Math<S>::select(moved_[k][i], other, largest);
      swap_where<S>(moved_[k][i], r_[k][k], r_[k][i]);
    }
  }

  GAUSS_FUNCTION void reflect(int k, const S& size) {
    const S head = r_[k][k];
    const S sign = Math<S>::select(Math<S>::less(head, S(0)), S(-1), S(1));
    for (int i = 0; i < n; ++i) reflector_[k][i] = i < k ? S(0) : r_[k][i];
    reflector_[k][k] = head + sign * size;
    strength_[k] = reciprocal(size * (size + absolute(head)), is_row_[k]);
    for (int j = k + 1; j < l; ++j) turn(k, r_[j]);
    r_[k][k] = Math<S>::select(Math<S>::less(S(0), is_row_[k]), -sign * size, head);
    inverse_[k] = reciprocal(r_[k][k], is_row_[k]);
  }

  GAUSS_FUNCTION void apply(int k, S (&x)[N]) const {
    const S along = strength_[k] * inner(reflector_[k], x, n);
    for (int i = k; i < n; ++i) x[i] = x[i] - along * reflector_[k][i];
  }

  GAUSS_FUNCTION void turn(int k, S (&x)[N]) const {
    for (int i = k + 1; i < n; ++i) swap_where<S>(moved_[k][i], x[k], x[i]);
    apply(k, x);
  }

  /// Q^T x
  GAUSS_FUNCTION void to_parts(S (&x)[N]) const {
    for (int k = 0; k < most; ++k) turn(k, x);
  }

  /// Q x
  GAUSS_FUNCTION void from_parts(S (&x)[N]) const {
    for (int k = most - 1; k >= 0; --k) {
      apply(k, x);
      for (int i = n - 1; i > k; --i) swap_where<S>(moved_[k][i], x[k], x[i]);
    }
  }

  /// Q^T g Q, and its factors over what the rows leave free.
  GAUSS_FUNCTION void reduce_metric() {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) parts_[i][j] = g_[i][j];
    }
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n; ++i) to_parts(parts_[i]);
      transpose();
    }
    S is_free[N];
    for (int i = 0; i < n; ++i) is_free[i] = S(1) - is_row_[i];
    // A quarter of the digits is left of what is divided by the least one, as in the cheap way.
    const S half = Math<S>::sqrt(Math<S>::epsilon());
    free_.factorise(parts_, is_free, S(8) * number<S>(n) * Math<S>::epsilon() + half * Math<S>::sqrt(half));
  }

  GAUSS_FUNCTION void transpose() {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) {
        const S above = parts_[j][i];
        parts_[j][i] = parts_[i][j];
        parts_[i][j] = above;
      }
    }
  }

  /// For each row without an own part, what of the others does the same: null vectors of b^T.
  GAUSS_FUNCTION void find_shared() {
    S counts[L];
    for (int j = 0; j < l; ++j) {
      const S is_left = S(1) - row_part(j);
      counts[j] = is_left;
      for (int k = 0; k < l; ++k) null_[j][k] = S(k == j ? 1 : 0) * is_left;
      for (int k = (j < most ? j : most) - 1; k >= 0; --k) {
        S sum = r_[j][k];
        for (int m = k + 1; m < most; ++m) sum = sum + r_[m][k] * row_part(m) * (m == j ? S(0) : null_[j][m]);
        null_[j][k] = Math<S>::select(Math<S>::less(S(0), is_left * row_part(k)), -sum * inverse_[k], null_[j][k]);
      }
    }
    S gram[L][L];
    for (int i = 0; i < l; ++i) {
      for (int j = 0; j < l; ++j) gram[i][j] = inner(null_[i], null_[j], l);
    }
    shares_.factorise(gram, counts, S(0));
  }

  /// Rows of which it is asked whether they contradict others: those that follow from constraints of velocities alone. Beside the equations of positions, as in
  /// the stages of a step, derivatives of these need not agree, and positions tell.
  template <class System>
  GAUSS_FUNCTION void find_asked(const System& system) {
    S of_positions[L];
    for (int mu = 0; mu < l; ++mu) of_positions[mu] = system.of_positions[mu];
    arrange(of_positions);
    const S least = Math<S>::sqrt(Math<S>::epsilon());
    for (int j = 0; j < l; ++j) {
      asked_[j] = S(1) - row_part(j);
      for (int k = 0; k < l; ++k) {
        const S takes_part = positive<S>(absolute<S>(null_[j][k]) - least);
        asked_[j] = asked_[j] * (S(1) - takes_part * of_positions[k]);
      }
    }
    arrange(c_error_);
  }

  GAUSS_FUNCTION S row_part(int k) const { return k < most ? is_row_[k < n ? k : 0] : S(0); }

  GAUSS_FUNCTION void residual(const S (&f)[N], const S (&c)[L], const S (&a)[N], const S (&lambda)[L], S (&of_f)[N],
                               S (&of_c)[L]) const {
    for (int i = 0; i < n; ++i) {
      of_f[i] = f[i];
      for (int j = 0; j < n; ++j) of_f[i] = of_f[i] - g_[i][j] * a[j];
      for (int mu = 0; mu < l; ++mu) of_f[i] = of_f[i] + b_[mu][i] * lambda[mu];
    }
    for (int mu = 0; mu < l; ++mu) of_c[mu] = c[mu] - inner(b_[mu], a, n);
  }

  /// Adds to a and lambda what f and c ask for; returns by how much rows contradict each other, of what they ask for.
  GAUSS_FUNCTION S add(S (&f)[N], S (&c)[L], S (&a)[N], S (&lambda)[L]) const {
    arrange(c);
    S y[N], x[N];
    const S contradiction = along_rows(c, y);
    to_parts(f);
    for (int i = 0; i < n; ++i) {
      x[i] = f[i];
      for (int k = 0; k < most; ++k) x[i] = x[i] - parts_[i][k] * y[k];
      x[i] = x[i] * (S(1) - is_row_[i]);
    }
    free_.solve(x);
    for (int i = 0; i < n; ++i) y[i] = Math<S>::select(Math<S>::less(S(0), is_row_[i]), y[i], x[i]);
    S change[L];
    forces(f, y, change);
    arrange_back(change);
    from_parts(y);
    for (int i = 0; i < n; ++i) a[i] = a[i] + y[i];
    for (int mu = 0; mu < l; ++mu) lambda[mu] = lambda[mu] + change[mu];
    return contradiction;
  }

  /// R^T y = c
  GAUSS_FUNCTION S along_rows(const S (&c)[L], S (&y)[N]) const {
    for (int i = 0; i < n; ++i) y[i] = S(0);
    S contradiction = S(0);
    for (int k = 0; k < l; ++k) {
      S rest = c[k], size = absolute(c[k]);
      for (int j = 0; j < (k < most ? k : most); ++j) {
        const S term = r_[k][j] * y[j] * is_row_[j];
        rest = rest - term;
        size = size + absolute(term);
      }
      if (k < most) y[k] = rest * inverse_[k];
      const S is_left = asked_[k] * positive<S>(absolute<S>(rest) - error_of_demands(c, k));
      contradiction = larger(contradiction, is_left * absolute(rest) * reciprocal(size, is_left));
    }
    return contradiction;
  }

  /// How far what row k and those that it follows from ask for may be off.
  GAUSS_FUNCTION S error_of_demands(const S (&c)[L], int k) const {
    S error = S(0);
    for (int m = 0; m < l; ++m) {
      const S rounding = S(10000) * Math<S>::epsilon() * absolute<S>(c[m]);
      error = error + absolute<S>(null_[k][m]) * larger<S>(rounding, c_error_[m]);
    }
    return error;
  }

  /// R lambda = (Q^T (g a - f)) along the rows, of least norm.
  GAUSS_FUNCTION void forces(const S (&f)[N], const S (&y)[N], S (&lambda)[L]) const {
    for (int k = 0; k < l; ++k) lambda[k] = S(0);
    for (int k = most - 1; k >= 0; --k) {
      S rest = inner(parts_[k], y, n) - f[k];
      for (int j = k + 1; j < most; ++j) rest = rest - r_[j][k] * lambda[j];
      lambda[k] = rest * inverse_[k];
    }
    S share[L];
    for (int j = 0; j < l; ++j) share[j] = -inner(null_[j], lambda, l);
    shares_.solve(share);
    for (int j = 0; j < l; ++j) {
      const S part = share[j] * (S(1) - row_part(j));
      for (int k = 0; k < l; ++k) lambda[k] = lambda[k] + part * null_[j][k];
    }
  }

  /// As the rows were brought into their order.
  GAUSS_FUNCTION void arrange(S (&values)[L]) const {
    for (int k = 0; k < most; ++k) {
      for (int j = k + 1; j < l; ++j) swap_where<S>(swapped_[k][j], values[k], values[j]);
    }
  }

  GAUSS_FUNCTION void arrange_back(S (&values)[L]) const {
    for (int k = most - 1; k >= 0; --k) {
      for (int j = l - 1; j > k; --j) swap_where<S>(swapped_[k][j], values[k], values[j]);
    }
  }

  GAUSS_FUNCTION void finish(const S (&a)[N], const S (&lambda)[L], const S& contradiction,
                             LinearSolution<S, N, L>& solution) const {
    for (int i = 0; i < n; ++i) solution.accelerations[i] = speed_scale_[i] * a[i];
    for (int k = 0; k < l; ++k) {
      S shared = S(0);
      for (int j = 0; j < l; ++j) shared = larger(shared, absolute(null_[j][k]));
      solution.is_shared[k] = positive<S>(shared * shared - Math<S>::epsilon());
    }
    arrange_back(solution.is_shared);
    for (int mu = 0; mu < l; ++mu) solution.multipliers[mu] = row_scale_[mu] * lambda[mu];
    solution.rank = rank_;
    const Bool never = Math<S>::less(S(0), S(0));
    // What is not a number tells nothing of ranks, and whoever fills the system says so.
    const S is_unknown = unknown();
    const Bool undetermined = Math<S>::less(free_.is_determined - has_lost_entries_ + is_unknown, S(1));
    const Bool lost = Math<S>::less(is_full_ + is_unknown, S(1));
    const Bool not_unique = Math<S>::less(rank_ + number<S>(l) * is_unknown, number<S>(l));
    const S allowed = is_agreement_known_ ? S(2) : Math<S>::sqrt(Math<S>::sqrt(Math<S>::epsilon()));
    const Bool contradictory = Math<S>::less(allowed, contradiction);
    solution.motion = Math<S>::status(undetermined, lost, never, contradictory);
    solution.step = Math<S>::status(undetermined, lost, never);
    solution.reactions = Math<S>::status(undetermined, not_unique, never, contradictory);
  }

  GAUSS_FUNCTION S unknown() const {
    S sum = S(0);
    for (int i = 0; i < n; ++i) sum = sum + f_[i] + inner(g_[i], g_[i], n);
    for (int mu = 0; mu < l; ++mu) sum = sum + c_[mu] + inner(b_[mu], b_[mu], n);
    return indicator<S>(Math<S>::not_finite(sum));
  }

  S g_[N][N], f_[N], b_[L][N], c_[L];  ///< scaled
  S speed_scale_[N], row_scale_[L];
  S r_[L][N];  ///< R^T: row k has its entries above the diagonal, and r_[k][k]
  S reflector_[M][N], strength_[M], inverse_[M];
  S is_row_[N];  ///< 1: this part of the speeds is what a row says; 0: it is free
  S beyond_[L];  ///< what is asked of a row beyond the usual rank
  S rank_, is_full_, has_lost_entries_;
  bool is_agreement_known_;
  Bool swapped_[M][L];  ///< rows, and speeds:
  Bool moved_[M][N];
  S parts_[N][N];  ///< Q^T g Q
  MaskedLdl<S, N, decltype(Sizes::n)> free_;
  S null_[L][L];
  S asked_[L];    ///< 1: a row is left that has to agree with the others
  S c_error_[L];  ///< how far c may be off; as the rows were brought into their order
  MaskedLdl<S, L, decltype(Sizes::l)> shares_;
};

}  // namespace detail

/// Accelerations and multipliers; see LinearSolution. `System` has g[n][n], symmetric, f[n], b[l][n], where row mu is dphi_mu/du, reach[l][n], not less than
/// its entries in any configuration, drift[l] and drift_error[l], by how much it may be off; of_positions[l], 1 where a row is the derivative of an equation of positions and else 0, and off[l], the
/// square of the part by which positions are off the equations that row mu may follow from.
template <class System, class S, int n, int l>
GAUSS_PART void solve(const System& system, const RankRule<S>& rule, LinearSolution<S, n, l>& solution) noexcept {
  detail::Constrained<S, detail::KnownSizes<n, l>>(system, rule).solve(solution);
}

/// Accelerations with each of `count` other forces and drifts in the place of those of `system`, such as their derivatives. The status says whether they are
/// finite.
template <class System, class S, int n, int l, int count>
GAUSS_PART StatusOf<S> solve_each(const System& system, const RankRule<S>& rule, const S (&f)[count][n],
                                  const S (&drift)[count][l], S (&accelerations)[count][n]) noexcept {
  const detail::Constrained<S, detail::KnownSizes<n, l>> constrained(system, rule);
  S nothing = S(0);
  for (int k = 0; k < count; ++k) {
    constrained.respond(f[k], drift[k], accelerations[k]);
    for (int i = 0; i < n; ++i) nothing = nothing + (accelerations[k][i] - accelerations[k][i]);
  }
  const auto never = Math<S>::less(S(0), S(0));
  return Math<S>::status(never, never, Math<S>::not_finite(nothing));
}

}  // namespace gauss

#endif  // GAUSS_CONSTRAINED_HPP
