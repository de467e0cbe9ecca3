// The largest margin that limits of forces can all have: a concave programme over few unknowns (docs/theory.md, section 11).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_LARGEST_MARGIN_HPP
#define GAUSS_EVENT_LARGEST_MARGIN_HPP

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "gauss/event/dense.hpp"
#include "gauss/event/least_constraint.hpp"

namespace gauss::event {

/// value + slope z
template <class S>
struct Affine {
  S value = 0;
  std::vector<S> slope;

  S operator()(const std::vector<S>& z) const { return value + product_of(slope, z); }
};

/// limit - |forces|; without forces it is the limit.
template <class S>
struct Margin {
  Affine<S> limit;
  std::vector<Affine<S>> forces;

  std::vector<S> forces_at(const std::vector<S>& z) const {
    std::vector<S> result;
    for (const Affine<S>& force : forces) result.push_back(force(z));
    return result;
  }
  S operator()(const std::vector<S>& z) const { return limit(z) - length_of(forces_at(z)); }

  /// The plane above it that touches it where forces have this direction; exact for less than two of them.
  Affine<S> plane(const std::vector<S>& direction) const {
    Affine<S> result = limit;
    for (std::size_t r = 0; r < forces.size(); ++r) {
      result.value -= direction[r] * forces[r].value;
      for (std::size_t j = 0; j < result.slope.size(); ++j) result.slope[j] -= direction[r] * forces[r].slope[j];
    }
    return result;
  }
};

/// What is known of margins by planes: exact ones, and tangents of what has forces in several directions.
template <class S>
struct MarginPlanes {
  struct Plane : Affine<S> {
    std::size_t of = 0;
  };

  explicit MarginPlanes(const std::vector<Margin<S>>& of) : margins(of) {
    for (std::size_t i = 0; i < margins.size(); ++i) {
      const std::size_t count = margins[i].forces.size();
      if (count == 0) add(i, {});
      for (std::size_t r = 0; r < count; ++r) {
        for (const int sign : {1, -1}) {
          std::vector<S> direction(count, S(0));
          direction[r] = S(sign);
          add(i, direction);
        }
      }
    }
  }

  void add(std::size_t of, const std::vector<S>& direction) { all.push_back({margins[of].plane(direction), of}); }
  bool is_round(std::size_t i) const { return margins[i].forces.size() > 1; }

  /// Tangents at `z`, where planes so far are above a margin by more than `least`. False: nowhere.
  bool add_tangents(const std::vector<S>& z, const S& least) {
    const std::size_t before = all.size();
    for (std::size_t i = 0; i < margins.size(); ++i) {
      if (!is_round(i)) continue;
      std::vector<S> direction = margins[i].forces_at(z);
      const S length = length_of(direction), margin = margins[i](z);
      const bool is_known = std::any_of(
          all.begin(), all.end(), [&](const Plane& plane) { return plane.of == i && !(plane(z) - margin > least); });
      if (is_known || !(length > S(0))) continue;
      for (S& part : direction) part /= length;
      add(i, direction);
    }
    return all.size() > before;
  }

  const std::vector<Margin<S>>& margins;
  std::vector<Plane> all;
};

/// Of margins without values: whether some z other than 0 leaves all of them at 0 or more, and is on the side of `wish`: the projection of `wish` on the cone of these z is not 0.
template <class S>
bool has_ray_towards(const std::vector<S>& wish, const std::vector<Margin<S>>& margins) {
  constexpr int k_passes = 100;
  const std::size_t n = wish.size();
  MarginPlanes<S> planes(margins);
  for (int pass = 0; pass < k_passes; ++pass) {
    ContactProblem<S> nearest;
    nearest.speeds = n;
    nearest.metric.assign(n * n, S(0));
    for (std::size_t j = 0; j < n; ++j) nearest.metric[j * n + j] = S(1);
    for (const auto& plane : planes.all) {
      nearest.rows.insert(nearest.rows.end(), plane.slope.begin(), plane.slope.end());
      nearest.right.push_back(-plane(wish));
    }
    const ContactAccelerations<S> found = LeastConstraint<S>(nearest).solve();
    if (!found.is_found) return false;
    std::vector<S> z = wish;
    for (std::size_t j = 0; j < n; ++j) z[j] += found.change[j];
    if (!(length_of(z) > S(1e-6) * length_of(wish))) return false;
    if (!planes.add_tangents(z, S(1e-9) * length_of(z))) return true;
  }
  return true;
}

/// The z with the largest margin that all have, by proximal steps (R. T. Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898), with tangents that are added where forces have several directions, until it is
/// known which margins bind: then these lead there at once, by Newton's method.
template <class S>
class LargestMargin {
 public:
  /// `floors`: of margins that keep at least this, and are not made larger. `size`: of the forces, to tell what is rounding.
  LargestMargin(const std::vector<Margin<S>>& margins, const std::vector<std::optional<S>>& floors, const S& size)
      : planes_(margins), floors_(floors), unknowns_(margins.front().limit.slope.size()), size_(size) {}

  struct Result {
    std::vector<S> z;
    S margin = 0;                      ///< the least of those without a floor
    std::vector<std::size_t> binding;  ///< of these, those that nothing can make larger together
  };

  Result solve() {
    std::vector<S> z(unknowns_, S(0));
    planes_.add_tangents(z, rounding());
    Result result{z, least(z), {}};
    S nearness = S(0.01);
    for (int pass = 0; pass < k_passes; ++pass) {
      const ContactAccelerations<S> found = proximal(z, nearness);
      if (!found.is_found) break;
      for (std::size_t j = 0; j < unknowns_; ++j) z[j] += found.change[j];
      const Balance balance = balanced(found.reactions, z);
      result.binding = balance.binding;
      planes_.add_tangents(balance.z, rounding());
      const S there = least(balance.z);
      if (balance.is_maximum && there > result.margin - rounding() && balance.margin - there <= rounding()) {
        result.z = balance.z;
        result.margin = there;
        break;
      }
      const bool is_added = planes_.add_tangents(z, rounding());
      const S here = least(z);
      const bool is_better = here > result.margin + rounding(), is_moved = length_of(found.change) > rounding();
      if (here > result.margin) result.margin = here, result.z = z;
      if (!is_added && !(is_better && is_moved)) break;
      // Farther steps where planes are nearly level.
      if (!is_added) nearness = std::max(S(nearness / 10), S(1e-10));
    }
    return result;
  }

 private:
  using Plane = typename MarginPlanes<S>::Plane;

  /// Where margins that bind balance each other.
  struct Balance {
    std::vector<S> z;
    S margin = 0;
    std::vector<std::size_t> binding;
    bool is_maximum = false;  ///< as far as these tell
  };
  /// m(z + d) = value + slope d + ½ d curvature d
  struct Expansion {
    S value;
    std::vector<S> slope;
    DenseMatrix<S> curvature;
  };

  S rounding() const { return S(16) * Math<S>::epsilon() * size_; }
  static S none() { return S(1e-9); }

  S least(const std::vector<S>& z) const {
    S result = std::numeric_limits<S>::infinity();
    for (const Plane& plane : planes_.all)
      if (!floors_[plane.of]) result = std::min(result, plane(z));
    return result;
  }

  /// The place with the least ½ (ε |d|² + σ²), all margins being 4 size - σ or more.
  ContactAccelerations<S> proximal(const std::vector<S>& z, const S& nearness) const {
    const std::size_t n = unknowns_ + 1;
    ContactProblem<S> problem;
    problem.speeds = n;
    problem.metric.assign(n * n, S(0));
    for (std::size_t j = 0; j < n; ++j) problem.metric[j * n + j] = j < unknowns_ ? nearness : S(1);
    for (const Plane& plane : planes_.all) {
      const std::optional<S>& floor = floors_[plane.of];
      problem.rows.insert(problem.rows.end(), plane.slope.begin(), plane.slope.end());
      problem.rows.push_back(floor ? S(0) : S(1));
      problem.right.push_back(floor.value_or(4 * size_) - plane(z));
    }
    ContactAccelerations<S> found = LeastConstraint<S>(problem).solve();
    if (found.is_found) found.change.pop_back();
    return found;
  }

  Expansion expand(const Plane& plane, const std::vector<S>& z) const {
    Expansion result{plane(z), plane.slope, DenseMatrix<S>(unknowns_, unknowns_)};
    const Margin<S>& margin = planes_.margins[plane.of];
    std::vector<S> direction = margin.forces_at(z);
    const S length = length_of(direction);
    if (!planes_.is_round(plane.of) || !(length > S(0))) return result;
    for (S& part : direction) part /= length;
    const Affine<S> tangent = margin.plane(direction);
    result.value = tangent(z);
    result.slope = tangent.slope;
    for (std::size_t i = 0; i < unknowns_; ++i) {
      for (std::size_t j = 0; j < unknowns_; ++j) {
        S all = 0, along_i = 0, along_j = 0;
        for (std::size_t r = 0; r < direction.size(); ++r) {
          all += margin.forces[r].slope[i] * margin.forces[r].slope[j];
          along_i += direction[r] * margin.forces[r].slope[i];
          along_j += direction[r] * margin.forces[r].slope[j];
        }
        result.curvature(i, j) = (along_i * along_j - all) / length;
      }
    }
    return result;
  }

  /// One for each margin that is round, and with what part each binds, by multipliers of planes.
  std::vector<std::pair<Plane, S>> binding_planes(const std::vector<S>& multipliers) const {
    std::vector<std::pair<Plane, S>> result;
    S largest = 0, sum = 0;
    for (const S& one : multipliers) largest = std::max(largest, one);
    for (std::size_t p = 0; p < multipliers.size(); ++p) {
      const Plane& plane = planes_.all[p];
      if (!(multipliers[p] > none() * largest)) continue;
      if (!floors_[plane.of]) sum += multipliers[p];
      const auto known = std::find_if(result.begin(), result.end(), [&](const auto& one) {
        return one.first.of == plane.of && planes_.is_round(plane.of);
      });
      if (known != result.end()) known->second += multipliers[p];
      if (known == result.end()) result.emplace_back(plane, multipliers[p]);
    }
    if (!(sum > S(0))) return {};
    for (auto& [plane, part] : result) part /= sum;
    return result;
  }

  /// Newton's method for the conditions of the maximum, Σ μ ∇m = 0 and Σ μ = 1 with m = s, from near it.
  Balance balanced(const std::vector<S>& multipliers, const std::vector<S>& from) const {
    constexpr int k_steps = 12;
    std::vector<std::pair<Plane, S>> binding = binding_planes(multipliers);
    Balance result{from, S(0), {}, false};
    if (binding.empty()) return result;
    for (const auto& [plane, part] : binding)
      if (!floors_[plane.of] &&
          std::find(result.binding.begin(), result.binding.end(), plane.of) == result.binding.end())
        result.binding.push_back(plane.of);
    const std::size_t n = unknowns_, m = binding.size();
    for (int step = 0; step < k_steps; ++step) {
      DenseMatrix<S> matrix(n + 1 + m, n + 1 + m);
      std::vector<S> right(n + 1 + m, S(0));
      right[n] = S(1);
      // Where all is level, rounding says which way: no way is far then.
      for (std::size_t i = 0; i < n; ++i) matrix(i, i) = -S(1e-3) / size_;
      for (std::size_t k = 0; k < m; ++k) {
        const auto& [plane, part] = binding[k];
        const Expansion here = expand(plane, result.z);
        const std::optional<S>& floor = floors_[plane.of];
        for (std::size_t i = 0; i < n; ++i) {
          matrix(i, n + 1 + k) = matrix(n + 1 + k, i) = here.slope[i];
          for (std::size_t j = 0; j < n; ++j) matrix(i, j) += part * here.curvature(i, j);
        }
        matrix(n, n + 1 + k) = floor ? S(0) : S(1);
        matrix(n + 1 + k, n) = floor ? S(0) : S(-1);
        right[n + 1 + k] = floor.value_or(S(0)) - here.value;
      }
      const std::vector<S> found = solve_dense(std::move(matrix), std::move(right));
      S moved = 0;
      for (std::size_t j = 0; j < n; ++j) {
        result.z[j] += found[j];
        moved = std::max(moved, magnitude_of(found[j]));
      }
      result.margin = found[n];
      for (std::size_t k = 0; k < m; ++k) binding[k].second = found[n + 1 + k];
      if (!(moved > rounding())) break;
    }
    result.is_maximum = are_balanced(binding, result.z);
    return result;
  }

  /// No part below 0, and their slopes leave nothing.
  bool are_balanced(const std::vector<std::pair<Plane, S>>& binding, const std::vector<S>& z) const {
    std::vector<S> slope(unknowns_, S(0));
    S steepest = 0;
    for (const auto& [plane, part] : binding) {
      if (part < -none()) return false;
      const Expansion here = expand(plane, z);
      for (std::size_t j = 0; j < unknowns_; ++j) {
        slope[j] += part * here.slope[j];
        steepest = std::max(steepest, magnitude_of(S(part * here.slope[j])));
      }
    }
    return length_of(slope) <= none() * steepest;
  }

  static constexpr int k_passes = 100;

  MarginPlanes<S> planes_;
  const std::vector<std::optional<S>>& floors_;
  std::size_t unknowns_;
  S size_;
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_LARGEST_MARGIN_HPP
