// What impulses at contacts are found from, and what is found.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_IMPACT_PROBLEM_HPP
#define GAUSS_EVENT_IMPACT_PROBLEM_HPP

#include <cstddef>
#include <vector>

#include "gauss/event/null_space.hpp"

namespace gauss::event {

/// Rows are gradients by the speeds: of constraints first, then of gaps, then of slips of friction.
template <class S>
struct ImpactProblem {
  std::size_t speeds = 0, constraints = 0;
  std::vector<S> metric;           ///< speeds × speeds
  std::vector<S> rows;             ///< one after another
  std::vector<S> rates;            ///< of each row before
  std::vector<S> restitution;      ///< of each contact
  std::vector<char> takes_part;    ///< of each contact: it is closed, or closes now
  std::vector<std::size_t> slips;  ///< of each friction: how many rows it has, 1 or 2
  std::vector<S> limits;           ///< frictions × contacts: per impulse of the contact

  std::size_t contacts() const { return restitution.size(); }
  std::size_t count() const { return rates.size(); }
  /// A row, and changes of the speeds, in coordinates in which inertia is 1 (null_space.hpp).
  std::vector<S> row_in_metric(std::size_t row) const {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(row * speeds);
    return in_metric(metric, std::vector<S>(begin, begin + static_cast<std::ptrdiff_t>(speeds)), speeds, 1).entries;
  }
  std::vector<S> out_of_metric(const std::vector<S>& change) const {
    return gauss::event::out_of_metric(metric, change);
  }
  std::size_t first_slip(std::size_t friction) const {
    std::size_t first = constraints + contacts();
    for (std::size_t f = 0; f < friction; ++f) first += slips[f];
    return first;
  }
};

template <class S>
struct Impulses {
  std::vector<S> changes;   ///< of the speeds
  std::vector<S> impulses;  ///< along each row
  bool is_found = false;    ///< else no impulses satisfy the law to rounding
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_IMPACT_PROBLEM_HPP
