#pragma once
// Reactions of held coordinates from mass points alone, as section 3 of the paper has them: dual basis, э^ij, b^{μi}, (3.6)-(3.8), for any partition of the free
// coordinates. Nothing here knows of the generator: derivatives of places and constraints are by dual numbers, in more digits than the headers under test.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "gauss/scalar/dual.hpp"
#include "wide_matrix.hpp"

namespace mass_points {

using physics::at;
using physics::Matrix;
using physics::norm;
using physics::Row;
using physics::Wide;

/// Empty where the matrix is singular.
inline Matrix invert(const Matrix& a) { return physics::inverse(a, 1e-12); }

/// What (3.6)-(3.8) come to for one partition.
struct Motion {
  Row accelerations;  ///< of the free coordinates
  Row reactions;      ///< R_j
  Row without_b;      ///< R_j if b^{μi} were 0
  Wide condition;     ///< of b over the dependent coordinates, inertias 1 and rows of unit length
};

/// `Mechanism` has n free and k held coordinates, l constraints, `points` mass points, and templates on the scalar: `held(t, x)`, `places(y, r)`
/// with y the free, then the held ones, `rows(t, y, rates, phi)`. Gravity is along -z.
template <class Mechanism>
class Instant {
 public:
  static constexpr int n = Mechanism::n, k = Mechanism::k, l = Mechanism::l, all = n + k;

  /// `state`: free coordinates, then their rates.
  Instant(const Mechanism& mechanism, Wide t, const double* state) : of_(mechanism), t_(t) {
    find_held();
    for (int a = 0; a < n; ++a) y_[a] = state[a], u_[a] = state[n + a];
    find_metric();
    find_rows();
  }

  /// Largest of |Σ m э^i э^j - э^ij| and |Σ m э^i r_α|: what makes the dual basis one.
  Wide error_of_dual_basis() const {
    Wide largest = 0;
    for (int i = 0; i < k; ++i) {
      for (int b = 0; b < all; ++b) {
        // э_ν^i = G^{iA} r_νA
        Wide along = 0;
        for (int p = 0; p < Mechanism::points; ++p)
          for (int x = 0; x < 3; ++x) along += of_.mass(p) * dual(i, p, x) * slope_[p][x][b];
        largest = std::max(largest, std::abs(along - (b == n + i ? 1 : 0)));
      }
      for (int j = 0; j < k; ++j) {
        Wide entry = 0;
        for (int p = 0; p < Mechanism::points; ++p)
          for (int x = 0; x < 3; ++x) entry += of_.mass(p) * dual(i, p, x) * dual(j, p, x);
        largest = std::max(largest, std::abs(entry - whole_[at(n + i)][at(n + j)]));
      }
    }
    return largest;
  }

  Wide size_of_forces() const {
    Wide largest = 0;
    for (int a = 0; a < all; ++a) largest = std::max({largest, std::abs(force_[a]), std::abs(bias_[a])});
    return largest;
  }

  /// `dependent`: l of the free coordinates. Its condition is infinite where b over them is singular.
  Motion motion(const std::vector<int>& dependent) const {
    Motion result{{}, {}, {}, HUGE_VALL};
    Matrix b_d, scaled;
    for (int mu = 0; mu < l; ++mu) {
      Wide squares = 0;
      for (int a = 0; a < n; ++a) squares += beta_[mu][a] * beta_[mu][a] / metric_[at(a)][at(a)];
      b_d.emplace_back();
      scaled.emplace_back();
      for (const int d : dependent) {
        b_d.back().push_back(beta_[mu][d]);
        scaled.back().push_back(beta_[mu][d] / std::sqrt(metric_[at(d)][at(d)] * squares));
      }
    }
    const Matrix b_inverse = invert(b_d), of_scaled = invert(scaled);
    if (b_inverse.empty() || of_scaled.empty()) return result;
    result.condition = norm(of_scaled) * std::sqrt(Wide(l));
    result.accelerations = accelerations(dependent, b_inverse);
    find_reactions(dependent, b_inverse, result);
    return result;
  }

 private:
  using First = gauss::Dual<Wide, 1>;
  using Second = gauss::Dual<First, 1>;

  static First along(Wide value, Wide rate) {
    First result(value);
    result.tangent[0] = rate;
    return result;
  }
  static Second twice_along(Wide value, Wide rate, Wide second) {
    Second result(along(value, rate));
    result.tangent[0] = along(rate, second);
    return result;
  }

  void find_held() {
    Second x[k];
    of_.held(twice_along(t_, 1, 0), x);
    for (int i = 0; i < k; ++i) {
      y_[n + i] = x[i].value.value;
      u_[n + i] = x[i].value.tangent[0];
      law_[i] = x[i].tangent[0].tangent[0];
    }
  }

  void find_metric() {
    using D = gauss::Dual<Wide, all>;
    D y[all], r[Mechanism::points][3];
    Second path[all], moved[Mechanism::points][3];
    for (int a = 0; a < all; ++a) {
      y[a] = D::variable(y_[a], a);
      path[a] = twice_along(y_[a], u_[a], 0);
    }
    of_.places(y, r);
    of_.places(path, moved);
    whole_.assign(at(all), Row(at(all), 0));
    for (int p = 0; p < Mechanism::points; ++p) {
      for (int x = 0; x < 3; ++x) {
        for (int a = 0; a < all; ++a) {
          const Wide weighed = of_.mass(p) * r[p][x].tangent[a];
          slope_[p][x][a] = r[p][x].tangent[a];
          bias_[a] += weighed * moved[p][x].tangent[0].tangent[0];
          if (x == 2) force_[a] -= weighed * of_.gravity();
          for (int b = 0; b < all; ++b) whole_[at(a)][at(b)] += weighed * r[p][x].tangent[b];
        }
      }
    }
    metric_ = whole_;
    whole_ = invert(whole_);
    Matrix block(at(n), Row(at(n)));
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) block[at(a)][at(b)] = metric_[at(a)][at(b)];
    block_ = invert(block);
    Matrix upper(at(k), Row(at(k)));
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j) upper[at(i)][at(j)] = whole_[at(n + i)][at(n + j)];
    lower_ = invert(upper);
  }

  void find_rows() {
    using D = gauss::Dual<Wide, all>;
    D y[all], u[all], phi[l];
    First path[all], rates[all], moved[l];
    for (int a = 0; a < all; ++a) {
      y[a] = D(y_[a]);
      u[a] = D::variable(u_[a], a);
      path[a] = along(y_[a], u_[a]);
      rates[a] = along(u_[a], a < n ? 0 : law_[a - n]);
    }
    of_.rows(D(t_), y, u, phi);
    of_.rows(along(t_, 1), path, rates, moved);
    for (int mu = 0; mu < l; ++mu) {
      for (int a = 0; a < all; ++a) beta_[mu][a] = phi[mu].tangent[a];
      drift_[mu] = moved[mu].tangent[0];
    }
    for (int mu = 0; mu < l; ++mu) {
      for (int i = 0; i < k; ++i) {
        // b_μ^i = (β_μj - β_μα g^αβ g_βj) э^ji
        leaning_[mu][i] = 0;
        for (int j = 0; j < k; ++j)
          leaning_[mu][i] += (beta_[mu][n + j] - through_block(beta_[mu], j)) * whole_[at(n + j)][at(n + i)];
      }
    }
  }

  Wide dual(int i, int p, int x) const {
    Wide sum = 0;
    for (int a = 0; a < all; ++a) sum += whole_[at(n + i)][at(a)] * slope_[p][x][a];
    return sum;
  }

  /// v_α g^αβ g_βj
  Wide through_block(const Wide* v, int j) const {
    Wide sum = 0;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) sum += v[a] * block_[at(a)][at(b)] * metric_[at(b)][at(n + j)];
    return sum;
  }

  /// c_p^μ, for the m-th dependent coordinate.
  Wide c(const Matrix& b_inverse, std::size_t m, int p) const {
    Wide sum = 0;
    for (int rho = 0; rho < l; ++rho) sum -= b_inverse[m][at(rho)] * beta_[rho][p];
    return sum;
  }

  /// (3.7) beside the constraints, differentiated once.
  Row accelerations(const std::vector<int>& dependent, const Matrix& b_inverse) const {
    Matrix left;
    Row right;
    for (int p = 0; p < n; ++p) {
      if (std::find(dependent.begin(), dependent.end(), p) != dependent.end()) continue;
      left.emplace_back(at(n), 0);
      right.push_back(0);
      add_equation(p, 1, left.back(), right.back());
      for (std::size_t m = 0; m < dependent.size(); ++m)
        add_equation(dependent[m], c(b_inverse, m, p), left.back(), right.back());
    }
    for (int mu = 0; mu < l; ++mu) {
      left.emplace_back(beta_[mu], beta_[mu] + n);
      right.push_back(-drift_[mu]);
    }
    const Matrix solved = invert(left);
    Row result(at(n), 0);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) result[at(a)] += solved[at(a)][at(b)] * right[at(b)];
    return result;
  }

  /// ∂Z/∂a^α = A_α - Q_α, A_α = g_αβ q̈^β + g_αj c̈^j + bias_α
  void add_equation(int a, Wide factor, Row& left, Wide& right) const {
    for (int b = 0; b < n; ++b) left[at(b)] += factor * metric_[at(a)][at(b)];
    right += factor * (force_[a] - bias_[a]);
    for (int j = 0; j < k; ++j) right -= factor * metric_[at(a)][at(n + j)] * law_[j];
  }

  Wide slope_of_compulsion(int a, const Row& accelerations) const {
    Wide sum = bias_[a] - force_[a];
    for (int b = 0; b < n; ++b) sum += metric_[at(a)][at(b)] * accelerations[at(b)];
    for (int j = 0; j < k; ++j) sum += metric_[at(a)][at(n + j)] * law_[j];
    return sum;
  }

  /// (3.8): ∂Z/∂a_i + b^{μi} ∂Z/∂a^μ = 0 with ∂Z/∂a_i = э^ij (a_j - F_j - R_j).
  void find_reactions(const std::vector<int>& dependent, const Matrix& b_inverse, Motion& motion) const {
    for (int j = 0; j < k; ++j) {
      // a_j = э_ji (c̈^i + G^{iA} bias_A), F_j = Q_j - g_jα g^αβ Q_β
      Wide reaction = -(force_[n + j] - through_block(force_, j));
      Wide leaning = 0;
      for (int i = 0; i < k; ++i) {
        Wide raised = law_[i];
        for (int a = 0; a < all; ++a) raised += whole_[at(n + i)][at(a)] * bias_[a];
        reaction += lower_[at(j)][at(i)] * raised;
        for (std::size_t m = 0; m < dependent.size(); ++m) {
          // b^{μi} = -(b^-1)^{μρ} b_ρ^i
          Wide b_up = 0;
          for (int rho = 0; rho < l; ++rho) b_up -= b_inverse[m][at(rho)] * leaning_[rho][i];
          leaning += lower_[at(j)][at(i)] * b_up * slope_of_compulsion(dependent[m], motion.accelerations);
        }
      }
      motion.reactions.push_back(reaction + leaning);
      motion.without_b.push_back(reaction);
    }
  }

  const Mechanism& of_;
  Wide t_;
  Wide y_[all], u_[all], law_[k];          ///< law: second derivatives of held coordinates
  Wide slope_[Mechanism::points][3][all];  ///< r_νA
  Wide bias_[all] = {}, force_[all] = {};
  Matrix metric_, whole_, block_, lower_;         ///< G_AB; G^AB; g^αβ; э_ij
  Wide beta_[l][all], leaning_[l][k], drift_[l];  ///< β_μA; b_μ^i; dφ/dt where q̈ is 0
};

}  // namespace mass_points
