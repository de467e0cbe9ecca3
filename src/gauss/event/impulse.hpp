// Impulses at contacts, with friction: Gauss's principle for speeds that jump, with the law of restitution as its constraint
// (docs/theory.md, section 11).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_IMPULSE_HPP
#define GAUSS_EVENT_IMPULSE_HPP

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "gauss/event/coupled_impulses.hpp"

namespace gauss::event {

/// Moreau's law for all contacts at once: the rate of each gap becomes no less than -e times what it was, and there is an impulse only where it is
/// that. Friction takes no more than its limit, against what slip is left. Poisson's law where friction leaves that without impulses, or with energy that it gives. The result does not depend on the order of contacts.
///
/// Rows are measured in the metric of masses, so that lengths and angles, and whatever units they have, are alike, and what acts on nothing in common is found by itself.
template <class S>
class ImpactSolver {
 public:
  explicit ImpactSolver(const ImpactProblem<S>& problem) : problem_(problem), scales_(problem.count(), S(1)) {
    measure();
    find_islands();
  }

  Impulses<S> solve() const {
    Impulses<S> result{std::vector<S>(problem_.speeds, S(0)), std::vector<S>(problem_.count(), S(0)), true};
    for (std::size_t island = 0; island < problem_.count(); ++island) {
      if (island_of_[island] != island) continue;
      const Part part = part_of(island);
      const Impulses<S> found = CoupledImpulses<S>(part.problem).solve();
      result.is_found = result.is_found && found.is_found;
      for (std::size_t i = 0; i < problem_.speeds; ++i) result.changes[i] += found.changes[i];
      for (std::size_t k = 0; k < part.rows.size(); ++k)
        result.impulses[part.rows[k]] = scales_[part.rows[k]] * found.impulses[k];
    }
    return result;
  }

 private:
  using Indices = std::vector<std::size_t>;

  struct Part {
    ImpactProblem<S> problem;
    Indices rows;  ///< of the whole problem
  };

  std::size_t contact_row(std::size_t contact) const { return problem_.constraints + contact; }

  /// To length 1. The rows of a slip keep their angles.
  void measure() {
    between_ = Couplings<S>(problem_.metric, problem_.rows, problem_.speeds, problem_.count()).between;
    const auto scale = [&](std::size_t first, std::size_t count) {
      S own = 0;
      for (std::size_t k = first; k < first + count; ++k) own = std::max(own, between_(k, k));
      for (std::size_t k = first; own > S(0) && k < first + count; ++k) scales_[k] = S(1) / Math<S>::sqrt(own);
    };
    for (std::size_t k = 0; k < problem_.constraints + problem_.contacts(); ++k) scale(k, 1);
    for (std::size_t f = 0; f < problem_.slips.size(); ++f) scale(problem_.first_slip(f), problem_.slips[f]);
  }

  /// Each by its first row.
  void find_islands() {
    island_of_.resize(problem_.count());
    std::iota(island_of_.begin(), island_of_.end(), std::size_t(0));
    const auto join = [&](std::size_t a, std::size_t b) {
      const std::size_t from = std::max(island_of_[a], island_of_[b]), to = std::min(island_of_[a], island_of_[b]);
      std::replace(island_of_.begin(), island_of_.end(), from, to);
    };
    const S none = 64 * Math<S>::epsilon();
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (magnitude_of(S(scales_[k] * scales_[j] * between_(k, j))) > none) join(k, j);
    for (std::size_t f = 0; f < problem_.slips.size(); ++f) {
      const std::size_t first = problem_.first_slip(f);
      for (std::size_t k = 1; k < problem_.slips[f]; ++k) join(first, first + k);
      for (std::size_t c = 0; c < problem_.contacts(); ++c)
        if (magnitude_of(problem_.limits[f * problem_.contacts() + c]) > S(0)) join(first, contact_row(c));
    }
  }

  Part part_of(std::size_t island) const {
    Part part;
    ImpactProblem<S>& own = part.problem;
    own.speeds = problem_.speeds;
    own.metric = problem_.metric;
    const auto take = [&](std::size_t k) {
      const auto begin = problem_.rows.begin() + static_cast<std::ptrdiff_t>(k * problem_.speeds);
      for (std::size_t i = 0; i < problem_.speeds; ++i)
        own.rows.push_back(scales_[k] * begin[static_cast<std::ptrdiff_t>(i)]);
      own.rates.push_back(scales_[k] * problem_.rates[k]);
      part.rows.push_back(k);
    };
    const auto is_in = [&](std::size_t k) { return island_of_[k] == island; };
    for (std::size_t k = 0; k < problem_.constraints; ++k)
      if (is_in(k)) take(k), ++own.constraints;
    Indices contacts;
    for (std::size_t c = 0; c < problem_.contacts(); ++c) {
      if (!is_in(contact_row(c))) continue;
      take(contact_row(c));
      own.restitution.push_back(problem_.restitution[c]);
      own.takes_part.push_back(problem_.takes_part[c]);
      contacts.push_back(c);
    }
    for (std::size_t f = 0; f < problem_.slips.size(); ++f) {
      const std::size_t first = problem_.first_slip(f);
      if (!is_in(first)) continue;
      for (std::size_t k = first; k < first + problem_.slips[f]; ++k) take(k);
      own.slips.push_back(problem_.slips[f]);
      for (const std::size_t c : contacts)
        own.limits.push_back(problem_.limits[f * problem_.contacts() + c] * scales_[contact_row(c)] / scales_[first]);
    }
    return part;
  }

  const ImpactProblem<S>& problem_;
  DenseMatrix<S> between_;
  std::vector<S> scales_;  ///< of rows
  Indices island_of_;      ///< each row
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_IMPULSE_HPP
