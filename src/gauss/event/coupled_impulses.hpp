// Impulses at contacts that act on each other, with friction.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_COUPLED_IMPULSES_HPP
#define GAUSS_EVENT_COUPLED_IMPULSES_HPP

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "gauss/event/couplings.hpp"
#include "gauss/event/dense.hpp"
#include "gauss/event/impact_problem.hpp"

namespace gauss::event {

/// Of rows that have one unit (ImpactSolver): what is none is told by the largest of all. Gauss-Seidel with projections, and then linear equations. Poisson's law where friction leaves Moreau's without
/// impulses, or with energy that it gives.
template <class S>
class CoupledImpulses {
 public:
  explicit CoupledImpulses(const ImpactProblem<S>& problem)
      : problem_(problem),
        couplings_(problem.metric, problem.rows, problem.speeds, problem.count()),
        rates_(problem.rates),
        restitution_(problem.restitution),
        given_(problem.contacts(), S(0)) {}

  Impulses<S> solve() {
    bool is_found = find();
    const bool rebounds = std::any_of(restitution_.begin(), restitution_.end(), [](const S& e) { return e > S(0); });
    if (rebounds && !problem_.slips.empty() && (!is_found || gives_energy())) is_found = find_in_two_phases();
    Impulses<S> result;
    result.is_found = is_found;
    result.impulses = impulses_;
    result.changes.assign(problem_.speeds, S(0));
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t i = 0; i < problem_.speeds; ++i) result.changes[i] += impulses_[k] * couplings_.responses(k, i);
    return result;
  }

 private:
  bool find() {
    // Shorter steps of friction where it turns the slip that it acts against.
    for (const double step : {1.0, 0.3, 0.1, 0.03}) {
      impulses_.assign(problem_.count(), S(0));
      relax(S(step));
      if (settle()) return true;
    }
    return false;
  }

  /// Seen from what moves by itself: p (φ⁻ + φ⁺)/2.
  bool gives_energy() const {
    S sum = 0, size = 0;
    for (std::size_t k = 0; k < problem_.count(); ++k) {
      sum += impulses_[k] * (rates_[k] + rate(k));
      size = std::max(size, magnitude_of(S(impulses_[k] * rates_[k])));
    }
    return sum > least(1e-9) * size;
  }

  /// Poisson's law, which has impulses, and takes energy, where restitution of rates and friction leave none, or would give some: those that stop what closes, and then as large a part of these
  /// as restitution says, with friction in both phases (F. Pfeiffer and C. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8).
  bool find_in_two_phases() {
    std::fill(restitution_.begin(), restitution_.end(), S(0));
    if (!find()) return false;
    std::vector<S> first = impulses_;
    for (std::size_t c = 0; c < problem_.contacts(); ++c) {
      const std::size_t k = problem_.constraints + c;
      const S closing = problem_.rates[k] < S(0) ? problem_.restitution[c] : S(0);
      given_[c] = closing * impulses_[k];
      first[k] += given_[c];
    }
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t j = 0; j < problem_.count(); ++j) rates_[k] += couplings_.between(k, j) * first[j];
    if (!find()) return false;
    for (std::size_t k = 0; k < problem_.count(); ++k) impulses_[k] += first[k];
    return true;
  }

  S rate(std::size_t row) const {
    S sum = rates_[row];
    for (std::size_t j = 0; j < problem_.count(); ++j) sum += couplings_.between(row, j) * impulses_[j];
    return sum;
  }

  /// What the rate of a gap is to be, where it has an impulse.
  S target(std::size_t contact) const {
    const S before = rates_[problem_.constraints + contact];
    return before < S(0) ? -restitution_[contact] * before : S(0);
  }

  S limit(std::size_t friction) const {
    S sum = 0;
    for (std::size_t c = 0; c < problem_.contacts(); ++c)
      sum += problem_.limits[friction * problem_.contacts() + c] * (impulses_[problem_.constraints + c] + given_[c]);
    return std::max(sum, S(0));
  }

  bool may_have_limit(std::size_t friction) const {
    for (std::size_t c = 0; c < problem_.contacts(); ++c)
      if (problem_.takes_part[c] != 0 && problem_.limits[friction * problem_.contacts() + c] > S(0)) return true;
    return false;
  }

  /// Or what the number type still tells.
  static S least(double part) { return std::max(S(part), S(64 * Math<S>::epsilon())); }

  /// Gauss-Seidel with projections: near enough to tell what has an impulse, and what slips which way. At first as if each row gave way: that leaves equal parts to rows that do the same.
  void relax(const S& step) {
    for (const double yield : {0.1, 1e-2, 1e-3, 0.0}) relax(S(yield), step, yield > 0 ? 200 : 20000);
  }

  void relax(const S& yield, const S& step, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      S moved = 0, size = 0;
      const auto set = [&](std::size_t row, const S& value) {
        moved = std::max(moved, magnitude_of(S(value - impulses_[row])));
        size = std::max(size, magnitude_of(value));
        impulses_[row] = value;
      };
      for (std::size_t k = 0; k < problem_.constraints; ++k)
        if (couplings_.between(k, k) > S(0)) set(k, without(k, S(0), yield));
      for (std::size_t c = 0; c < problem_.contacts(); ++c) {
        const std::size_t k = problem_.constraints + c;
        if (problem_.takes_part[c] == 0 || !(couplings_.between(k, k) > S(0))) continue;
        set(k, std::max(S(0), without(k, target(c), yield)));
      }
      for (std::size_t f = 0; f < problem_.slips.size(); ++f)
        if (may_have_limit(f)) relax_friction(f, yield, step, set);
      if (!(moved > least(1e-14) * size)) return;
    }
  }

  /// The impulse along a row with which its rate, and what gives way, come to `target`.
  S without(std::size_t row, const S& target, const S& yield) const {
    const S own = couplings_.between(row, row);
    return impulses_[row] - (rate(row) - target + yield * own * impulses_[row]) / ((S(1) + yield) * own);
  }

  /// The same length of step in all directions, since it is the direction of the slip that friction acts against.
  template <class Set>
  void relax_friction(std::size_t friction, const S& yield, const S& step, const Set& set) {
    const std::size_t first = problem_.first_slip(friction), count = problem_.slips[friction];
    S values[2] = {S(0), S(0)}, square = 0, own = 0;
    for (std::size_t k = first; k < first + count; ++k) own = std::max(own, couplings_.between(k, k));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = first + i;
      if (own > S(0)) values[i] = impulses_[k] - step * (rate(k) + yield * own * impulses_[k]) / ((S(1) + yield) * own);
      square += values[i] * values[i];
    }
    const S size = Math<S>::sqrt(square), most = limit(friction);
    const S part = size > most ? most / size : S(1);
    for (std::size_t i = 0; i < count; ++i) set(first + i, part * values[i]);
  }

  /// What each row is, from what was found: then impulses follow from linear equations, to rounding.
  bool settle() {
    constexpr int k_passes = 40;
    const std::vector<S> relaxed = impulses_;
    std::vector<S> best;
    S nearest = std::numeric_limits<S>::infinity();
    for (int pass = 0; pass < k_passes; ++pass) {
      const std::vector<S> before = impulses_;
      solve_active();
      S moved = 0, size = 0;
      for (std::size_t k = 0; k < impulses_.size(); ++k) {
        moved = std::max(moved, magnitude_of(S(impulses_[k] - before[k])));
        size = std::max(size, magnitude_of(impulses_[k]));
      }
      // Directions of slip may turn away from what they were relaxed to.
      const bool is_nearer = moved < nearest && holds();
      if (is_nearer) best = impulses_, nearest = moved;
      if (!(moved > 64 * Math<S>::epsilon() * size) || (!is_nearer && !best.empty())) break;
    }
    impulses_ = best.empty() ? relaxed : best;
    return holds();
  }

  /// The whole law, to rounding of what was relaxed.
  bool holds() const {
    S fastest = 0, largest = 0;
    for (const S& one : problem_.rates) fastest = std::max(fastest, magnitude_of(one));
    for (const S& one : given_) largest = std::max(largest, one);
    for (const S& one : impulses_) largest = std::max(largest, magnitude_of(one));
    const S of_rates = least(1e-9) * fastest, of_impulses = least(1e-9) * largest;
    for (std::size_t k = 0; k < problem_.constraints; ++k)
      if (!(magnitude_of(rate(k)) <= of_rates)) return false;
    for (std::size_t c = 0; c < problem_.contacts(); ++c) {
      if (problem_.takes_part[c] == 0) continue;
      const std::size_t k = problem_.constraints + c;
      const S above = rate(k) - target(c);
      if (!(above >= -of_rates) || !(impulses_[k] >= -of_impulses)) return false;
      if (impulses_[k] > of_impulses && above > of_rates) return false;
    }
    for (std::size_t f = 0; f < problem_.slips.size(); ++f)
      if (may_have_limit(f) && !friction_holds(f, of_rates, of_impulses)) return false;
    return true;
  }

  bool friction_holds(std::size_t friction, const S& of_rates, const S& of_impulses) const {
    const std::size_t first = problem_.first_slip(friction), count = problem_.slips[friction];
    const S most = limit(friction), slip = length(first, count, [this](std::size_t k) { return rate(k); });
    const S taken = length(first, count, [this](std::size_t k) { return impulses_[k]; });
    if (!(taken <= most + of_impulses)) return false;
    for (std::size_t k = first; slip > of_rates && k < first + count; ++k)
      if (!(magnitude_of(S(impulses_[k] + most * rate(k) / slip)) <= of_impulses)) return false;
    return true;
  }

  template <class Value>
  static S length(std::size_t first, std::size_t count, const Value& value) {
    S square = 0;
    for (std::size_t k = first; k < first + count; ++k) square += value(k) * value(k);
    return Math<S>::sqrt(square);
  }

  void solve_active() {
    const std::size_t m = problem_.count();
    std::vector<std::size_t> active;
    for (std::size_t k = 0; k < problem_.constraints; ++k) active.push_back(k);
    for (std::size_t c = 0; c < problem_.contacts(); ++c)
      if (problem_.takes_part[c] != 0 && is_pressed(c)) active.push_back(problem_.constraints + c);
    S fastest = 0;
    for (const S& one : problem_.rates) fastest = std::max(fastest, magnitude_of(one));
    // Slip that is left has its friction from the contacts: a part of their columns.
    DenseMatrix<S> by(m, m);
    std::vector<S> of_given(m, S(0));
    for (std::size_t k = 0; k < m; ++k) by(k, k) = S(1);
    for (std::size_t f = 0; f < problem_.slips.size(); ++f) {
      if (!may_have_limit(f)) continue;
      const std::size_t first = problem_.first_slip(f), count = problem_.slips[f];
      const S most = limit(f), slip = length(first, count, [this](std::size_t k) { return rate(k); });
      const S taken = length(first, count, [this](std::size_t k) { return impulses_[k]; });
      const bool sticks = most > S(0) && taken < most * (S(1) - least(1e-9));
      // What has come to rest with all that friction has tells its direction by that alone.
      const bool rests = !(slip > least(1e-9) * fastest) && taken > S(0);
      for (std::size_t k = first; k < first + count; ++k) {
        if (sticks) {
          active.push_back(k);
          continue;
        }
        by(k, k) = S(0);
        const S direction = rests ? S(-impulses_[k] / taken) : slip > S(0) ? S(rate(k) / slip) : S(0);
        for (std::size_t c = 0; c < problem_.contacts(); ++c) {
          by(k, problem_.constraints + c) = -direction * problem_.limits[f * problem_.contacts() + c];
          of_given[k] -= direction * problem_.limits[f * problem_.contacts() + c] * given_[c];
        }
      }
    }
    DenseMatrix<S> matrix(active.size(), active.size());
    std::vector<S> right(active.size(), S(0));
    for (std::size_t i = 0; i < active.size(); ++i) {
      const std::size_t row = active[i];
      const bool is_gap = row >= problem_.constraints && row < problem_.constraints + problem_.contacts();
      right[i] = (is_gap ? target(row - problem_.constraints) : S(0)) - rates_[row];
      for (std::size_t k = 0; k < m; ++k) right[i] -= couplings_.between(row, k) * of_given[k];
      for (std::size_t j = 0; j < active.size(); ++j)
        for (std::size_t k = 0; k < m; ++k) matrix(i, j) += couplings_.between(row, k) * by(k, active[j]);
    }
    const std::vector<S> found = least_solution(matrix, right, active);
    std::vector<S> all = of_given;
    for (std::size_t j = 0; j < active.size(); ++j)
      for (std::size_t k = 0; k < m; ++k) all[k] += by(k, active[j]) * found[j];
    impulses_ = all;
  }

  /// Of all solutions, the least one, by iterated regularisation (A. Neumaier, SIAM Review 40 (1998) 636-666, section 10).
  std::vector<S> least_solution(const DenseMatrix<S>& matrix, const std::vector<S>& right,
                                const std::vector<std::size_t>& rows) const {
    DenseMatrix<S> yielding = matrix;
    for (std::size_t i = 0; i < rows.size(); ++i) yielding(i, i) += S(k_yield) * couplings_.between(rows[i], rows[i]);
    std::vector<S> result(rows.size(), S(0));
    S before = std::numeric_limits<S>::infinity();
    for (int pass = 0; pass < k_corrections; ++pass) {
      std::vector<S> off = right;
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < rows.size(); ++j) off[i] -= matrix(i, j) * result[j];
      const std::vector<S> change = solve_dense(yielding, off);
      S moved = 0;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        result[i] += change[i];
        moved = std::max(moved, magnitude_of(change[i]));
      }
      if (!(moved < before / 2)) break;
      before = moved;
    }
    return result;
  }

  bool is_pressed(std::size_t contact) const {
    const std::size_t k = problem_.constraints + contact;
    S largest = 0;
    for (const S& one : impulses_) largest = std::max(largest, magnitude_of(one));
    return impulses_[k] > least(1e-11) * largest;
  }

  static constexpr double k_yield = 1e-6;
  static constexpr int k_corrections = 30;

  const ImpactProblem<S>& problem_;
  Couplings<S> couplings_;
  std::vector<S> rates_, restitution_;  ///< of the phase
  std::vector<S> given_;                ///< impulses of contacts that it begins with
  std::vector<S> impulses_;
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_COUPLED_IMPULSES_HPP
