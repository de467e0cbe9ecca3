// Gauss's principle with inequalities: accelerations of a system whose contacts may part (docs/theory.md, section 11).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_LEAST_CONSTRAINT_HPP
#define GAUSS_EVENT_LEAST_CONSTRAINT_HPP

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "gauss/event/couplings.hpp"
#include "gauss/event/dense.hpp"

namespace gauss::event {

/// The change of accelerations that constraints and contacts make: of all with E d = e and A d ≥ a the one with the least ½ dᵀ g d.
template <class S>
struct ContactProblem {
  std::size_t speeds = 0, equations = 0;
  std::vector<S> metric;  ///< g, speeds × speeds, positive definite
  std::vector<S> rows;    ///< E, then A: one after another
  std::vector<S> right;   ///< e, then a

  std::size_t count() const { return right.size(); }
};

template <class S>
struct ContactAccelerations {
  std::vector<S> change;     ///< d
  std::vector<S> reactions;  ///< along each row: those of contacts are not negative, and 0 where the contact parts
  std::vector<S> rates;      ///< what each row of d is above its right side: 0 where there is a reaction
  bool is_found = false;     ///< else no accelerations satisfy all rows
};

/// The dual method of active sets (Goldfarb and Idnani, Mathematical Programming 27 (1983) 1-33): contacts join one by one, that which would overlap the most first, and
/// leave where they would pull. The accelerations are unique; where rows depend on each other, reactions are those of the rows that joined.
template <class S>
class LeastConstraint {
 public:
  explicit LeastConstraint(const ContactProblem<S>& problem)
      : problem_(problem), couplings_(problem.metric, problem.rows, problem.speeds, problem.count()) {}

  ContactAccelerations<S> solve() {
    ContactAccelerations<S> result;
    reactions_.assign(problem_.count(), S(0));
    for (std::size_t k = 0; k < problem_.equations; ++k)
      if (!join(k)) return result;
    // Each pass makes the constraint larger, and there are finitely many sets of contacts.
    const std::size_t most = 50 * (problem_.count() + 1);
    for (std::size_t pass = 0; pass < most; ++pass) {
      const std::size_t worst = most_violated();
      if (worst == problem_.count()) return finish();
      if (!join(worst)) return result;
    }
    return result;
  }

 private:
  static S rounding() { return S(1000) * Math<S>::epsilon(); }
  /// Of a row, what is none of its own beside those that are active.
  static S dependent() { return S(0.01) * Math<S>::sqrt(Math<S>::epsilon()); }

  S rate(std::size_t row) const {
    S sum = -problem_.right[row];
    for (std::size_t j = 0; j < problem_.count(); ++j) sum += couplings_.between(row, j) * reactions_[j];
    return sum;
  }

  /// What rounding makes of a rate.
  S least(std::size_t row) const {
    S size = magnitude_of(problem_.right[row]);
    for (std::size_t j = 0; j < problem_.count(); ++j)
      size = std::max(size, magnitude_of(S(couplings_.between(row, j) * reactions_[j])));
    return rounding() * size;
  }

  bool is_active(std::size_t row) const { return std::find(active_.begin(), active_.end(), row) != active_.end(); }

  std::size_t most_violated() const {
    std::size_t worst = problem_.count();
    S size = 0;
    for (std::size_t k = problem_.equations; k < problem_.count(); ++k) {
      if (is_active(k)) continue;
      // Beside what the row itself can do: rows may have different units.
      const S found = rate(k),
              per = couplings_.between(k, k) > S(0) ? S(found * found / couplings_.between(k, k)) : S(0);
      if (found < -least(k) && (worst == problem_.count() || per > size)) worst = k, size = per;
    }
    return worst;
  }

  /// What active rows have to give up for one unit of a reaction along `row`.
  std::vector<S> shares(std::size_t row) const {
    std::vector<S> right;
    for (const std::size_t k : active_) right.push_back(couplings_.between(k, row));
    return solve_dense(active_couplings(), std::move(right));
  }

  DenseMatrix<S> active_couplings() const {
    DenseMatrix<S> system(active_.size(), active_.size());
    for (std::size_t i = 0; i < active_.size(); ++i)
      for (std::size_t j = 0; j < active_.size(); ++j) system(i, j) = couplings_.between(active_[i], active_[j]);
    return system;
  }

  /// Reactions grow along `row` until its rate is 0; contacts that would pull leave on the way. False: nothing can bring it there.
  bool join(std::size_t row) {
    const bool is_equation = row < problem_.equations;
    for (;;) {
      const S violated = -rate(row);
      const std::vector<S> taken = shares(row);
      S own = couplings_.between(row, row);
      for (std::size_t i = 0; i < active_.size(); ++i) own -= taken[i] * couplings_.between(row, active_[i]);
      const bool is_free = active_.size() < problem_.speeds && own > dependent() * couplings_.between(row, row);
      if (is_equation) {
        // One that follows from others has to be satisfied by them.
        if (!is_free) return magnitude_of(violated) <= S(1e3) * least(row);
        grow(row, taken, violated / own);
        active_.push_back(row);
        return true;
      }
      if (!(violated > S(0))) return true;
      const S whole = is_free ? S(violated / own) : std::numeric_limits<S>::infinity();
      S step = whole;
      std::size_t leaves = active_.size();
      for (std::size_t i = 0; i < active_.size(); ++i) {
        if (active_[i] < problem_.equations || !(taken[i] > S(0))) continue;
        const S until = reactions_[active_[i]] / taken[i];
        if (until < step) step = until, leaves = i;
      }
      if (!(step < std::numeric_limits<S>::infinity())) return false;
      grow(row, taken, step);
      if (leaves == active_.size()) {
        active_.push_back(row);
        return true;
      }
      reactions_[active_[leaves]] = S(0);
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(leaves));
    }
  }

  void grow(std::size_t row, const std::vector<S>& taken, const S& step) {
    for (std::size_t i = 0; i < active_.size(); ++i) reactions_[active_[i]] -= step * taken[i];
    reactions_[row] += step;
  }

  /// From the rows that are active in the end, to rounding. Where these nearly depend on each other, what they came to step by step is better.
  ContactAccelerations<S> finish() {
    const std::vector<S> by_steps = reactions_;
    if (find_at_once()) return result_of();
    reactions_ = by_steps;
    ContactAccelerations<S> result = result_of();
    for (std::size_t k = problem_.equations; k < problem_.count(); ++k)
      if (reactions_[k] < S(0) || rate(k) < -S(1e4) * least(k)) result.is_found = false;
    return result;
  }

  /// False: reactions of active rows would pull, or others are violated.
  bool find_at_once() {
    std::vector<S> right;
    for (const std::size_t k : active_) right.push_back(problem_.right[k]);
    const std::vector<S> found = solve_dense(active_couplings(), std::move(right));
    std::fill(reactions_.begin(), reactions_.end(), S(0));
    S size = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      reactions_[active_[i]] = found[i];
      size = std::max(size, magnitude_of(found[i]));
    }
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (active_[i] >= problem_.equations && found[i] < -dependent() * size) return false;
    return most_violated() == problem_.count();
  }

  ContactAccelerations<S> result_of() const {
    ContactAccelerations<S> result;
    result.is_found = true;
    result.reactions = reactions_;
    result.change.assign(problem_.speeds, S(0));
    for (std::size_t k = 0; k < problem_.count(); ++k) {
      result.rates.push_back(is_active(k) ? S(0) : rate(k));
      for (std::size_t i = 0; i < problem_.speeds; ++i) result.change[i] += reactions_[k] * couplings_.responses(k, i);
    }
    return result;
  }

  const ContactProblem<S>& problem_;
  Couplings<S> couplings_;
  std::vector<S> reactions_;
  std::vector<std::size_t> active_;
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_LEAST_CONSTRAINT_HPP
