// How a load is shared by more reactions than the motion needs, and whether they can bear it (docs/theory.md, section 11).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_LOAD_SHARES_HPP
#define GAUSS_EVENT_LOAD_SHARES_HPP

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "gauss/event/dense.hpp"
#include "gauss/event/least_constraint.hpp"
#include "gauss/event/null_space.hpp"

namespace gauss::event {

/// A contact, which only presses; or what bears no more than its limit: friction that sticks, with a row for each of its slips, or a link.
template <class S>
struct JudgedLoad {
  std::vector<std::size_t> rows;
  bool has_limit = false;       ///< else a contact
  S limit = 0;                  ///< without reactions
  std::vector<S> per_reaction;  ///< how much more it is, for each row of the problem
  bool is_brittle = false;      ///< it leaves nothing to others, as a link that breaks
  bool is_unloaded = false;     ///< a contact that nothing presses but friction
};

/// Reactions along rows, which are gradients by the speeds and stand one after another; some follow from others.
template <class S>
struct LoadProblem {
  std::size_t speeds = 0;
  std::vector<S> metric;     ///< speeds × speeds, positive definite
  std::vector<S> rows;
  std::vector<S> reactions;  ///< one choice of them
  std::vector<char> is_fixed;  ///< of each row: forces contain its reaction, and would be others
  std::vector<JudgedLoad<S>> judged;

  std::size_t count() const { return reactions.size(); }
};

/// Of all reactions that make the same motion: equal stiffness of all that holds tells the part of what is brittle, the least reactions in the metric of masses. Of the rest those count that leave
/// the most to what is nearest to its limit: friction and contacts give way without losing what they bear, so they hold if there is any choice in which all of them do (the static theorem of
/// limit analysis; W. Prager and P. G. Hodge, Theory of Perfectly Plastic Solids, 1951, chapter 8).
template <class S>
class LoadShares {
 public:
  explicit LoadShares(const LoadProblem<S>& problem) : problem_(problem), basis_(open_directions()) {
    for (std::size_t k = 0; k < problem.count(); ++k) reactions_.push_back(problem.reactions[k] * norms_[k]);
    for (std::size_t i = 0; i < problem.judged.size(); ++i) is_shared_.push_back(depends(i) ? 1 : 0);
    narrow(fixed_rows());
    for (std::size_t i = 0; i < problem.judged.size(); ++i) is_open_.push_back(depends(i) ? 1 : 0);
    move(least_change(all_rows()));
    narrow(brittle_rows());
    unload();
    leave_idle_friction();
  }

  /// Its reactions are not unique, whether or not forces contain them.
  bool is_shared(std::size_t judged) const { return is_shared_[judged] != 0; }

  /// Of each judged load, nothing where its reactions are unique; else how much is left to it, in the unit of its reaction: below 0 where no choice holds.
  std::vector<std::optional<S>> margins() {
    std::vector<std::optional<S>> result(problem_.judged.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      if (is_open_[i] != 0) result[i] = is_idle(i) ? size() / norm(i) : margin(i) / norm(i);
    std::vector<Bound> bounds;
    for (std::vector<std::size_t> rest = movable(); !rest.empty();) {
      const Level level = highest(rest, bounds);
      for (const std::size_t i : rest) result[i] = margin(i) / norm(i);
      // What ends with others ends with them to the last digit.
      for (const std::size_t i : level.bound) {
        result[i] = level.least / norm(i);
        bounds.push_back({i, level.least});
        rest.erase(std::find(rest.begin(), rest.end(), i));
      }
      if (!(level.least < S(0)) || level.bound.empty()) break;
    }
    return result;
  }

 private:
  using Indices = std::vector<std::size_t>;

  /// A plane above a margin: exact for contacts and friction in one direction, and a tangent for what has more.
  struct Cut {
    std::size_t of;
    S value;  ///< where nothing has moved
    std::vector<S> slope;
  };
  /// What no choice leaves more margin to.
  struct Level {
    S least;
    Indices bound;
  };
  struct Bound {
    std::size_t of;
    S margin;
  };

  static S none() { return std::max(S(1e-9), S(64 * Math<S>::epsilon())); }

  DenseMatrix<S> open_directions() {
    const DenseMatrix<S> scaled = in_metric(problem_.metric, problem_.rows, problem_.speeds, problem_.count());
    DenseMatrix<S> columns(problem_.speeds, problem_.count());
    for (std::size_t k = 0; k < problem_.count(); ++k) {
      S square = 0;
      for (std::size_t i = 0; i < problem_.speeds; ++i) square += scaled(k, i) * scaled(k, i);
      norms_.push_back(square > S(0) ? Math<S>::sqrt(square) : S(1));
      for (std::size_t i = 0; i < problem_.speeds; ++i) columns(i, k) = scaled(k, i) / norms_[k];
    }
    return null_space(columns, none());
  }

  std::size_t open() const { return basis_.columns; }
  const S& norm(std::size_t i) const { return norms_[problem_.judged[i].rows.front()]; }

  Indices all_rows() const {
    Indices result(problem_.count());
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = k;
    return result;
  }
  Indices fixed_rows() const {
    Indices result;
    for (std::size_t k = 0; k < problem_.count(); ++k)
      if (problem_.is_fixed[k] != 0) result.push_back(k);
    return result;
  }
  Indices brittle_rows() const {
    Indices result;
    for (const JudgedLoad<S>& one : problem_.judged)
      if (one.is_brittle) result.insert(result.end(), one.rows.begin(), one.rows.end());
    return result;
  }

  DenseMatrix<S> part_of_basis(const Indices& rows) const {
    DenseMatrix<S> part(rows.size(), open());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < open(); ++j) part(i, j) = basis_(rows[i], j);
    return part;
  }

  /// To what leaves these rows as they are.
  void narrow(const Indices& rows) {
    if (rows.empty() || open() == 0) return;
    const DenseMatrix<S> kept = null_space(part_of_basis(rows), none());
    DenseMatrix<S> narrowed(problem_.count(), kept.columns);
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t j = 0; j < kept.columns; ++j)
        for (std::size_t i = 0; i < open(); ++i) narrowed(k, j) += basis_(k, i) * kept(i, j);
    basis_ = std::move(narrowed);
  }

  /// That leaves least of these rows.
  std::vector<S> least_change(const Indices& rows) const {
    const DenseMatrix<S> part = part_of_basis(rows);
    DenseMatrix<S> normal(open(), open());
    std::vector<S> right(open(), S(0));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t i = 0; i < open(); ++i) {
        right[i] -= part(r, i) * reactions_[rows[r]];
        for (std::size_t j = 0; j < open(); ++j) normal(i, j) += part(r, i) * part(r, j);
      }
    }
    return solve_dense(std::move(normal), std::move(right));
  }

  void move(const std::vector<S>& change) {
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t j = 0; j < open(); ++j) reactions_[k] += basis_(k, j) * change[j];
  }

  /// Its limit and forces, in units of the first row.
  S limit_at(std::size_t i) const {
    const JudgedLoad<S>& one = problem_.judged[i];
    S sum = one.limit;
    for (std::size_t k = 0; k < problem_.count(); ++k) sum += one.per_reaction[k] * reactions_[k] / norms_[k];
    return norm(i) * sum;
  }
  S limit_slope(std::size_t i, std::size_t j) const {
    const JudgedLoad<S>& one = problem_.judged[i];
    S sum = 0;
    for (std::size_t k = 0; k < problem_.count(); ++k) sum += one.per_reaction[k] * basis_(k, j) / norms_[k];
    return norm(i) * sum;
  }
  std::vector<S> forces_at(std::size_t i) const {
    std::vector<S> result;
    for (const std::size_t k : problem_.judged[i].rows) result.push_back(norm(i) * reactions_[k] / norms_[k]);
    return result;
  }
  S force_slope(std::size_t i, std::size_t r, std::size_t j) const {
    const std::size_t row = problem_.judged[i].rows[r];
    return norm(i) * basis_(row, j) / norms_[row];
  }
  std::vector<S> forces_at(std::size_t i, const std::vector<S>& at) const {
    std::vector<S> forces = forces_at(i);
    for (std::size_t r = 0; r < forces.size(); ++r)
      for (std::size_t j = 0; j < open(); ++j) forces[r] += force_slope(i, r, j) * at[j];
    return forces;
  }
  bool has_directions(std::size_t i) const { return problem_.judged[i].has_limit && problem_.judged[i].rows.size() > 1; }
  S margin(std::size_t i) const {
    const std::vector<S> forces = forces_at(i);
    return problem_.judged[i].has_limit ? S(limit_at(i) - length_of(forces)) : forces.front();
  }

  bool depends(std::size_t i) const {
    for (std::size_t j = 0; j < open(); ++j) {
      for (const std::size_t k : problem_.judged[i].rows)
        if (magnitude_of(basis_(k, j)) > none()) return true;
      if (problem_.judged[i].has_limit && magnitude_of(limit_slope(i, j)) > none()) return true;
    }
    return false;
  }

  /// Of what there is, to tell what is none.
  S size() const {
    S result = 0;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      result = std::max(result, length_of(forces_at(i)));
      if (problem_.judged[i].has_limit) result = std::max(result, magnitude_of(limit_at(i)));
    }
    return result > S(0) ? result : S(1);
  }

  /// Contacts whose reactions against each other may grow without end have none of that where nothing else presses them: a body that just fits between two walls
  /// is not held by them.
  void unload() {
    Indices unloaded;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      const JudgedLoad<S>& one = problem_.judged[i];
      if (!one.has_limit && one.is_unloaded && is_open_[i] != 0 && may_jam(i)) unloaded.push_back(one.rows.front());
    }
    if (unloaded.empty()) return;
    move(least_change(unloaded));
    narrow(unloaded);
  }

  /// Whether there are reactions without a load in which this contact presses and all others hold: what is nearest to its own direction among these.
  bool may_jam(std::size_t contact) const {
    std::vector<S> wish(open());
    for (std::size_t j = 0; j < open(); ++j) wish[j] = basis_(problem_.judged[contact].rows.front(), j);
    std::vector<S> at(open(), S(0));
    std::vector<Cut> cuts = first_cuts(movable());
    for (int pass = 0; pass < k_passes; ++pass) {
      ContactProblem<S> nearest;
      nearest.speeds = open();
      nearest.metric = DenseMatrix<S>(open(), open()).entries;
      for (std::size_t j = 0; j < open(); ++j) nearest.metric[j * open() + j] = S(1);
      for (const Cut& cut : cuts) {
        S value = 0;
        for (std::size_t j = 0; j < open(); ++j) value += cut.slope[j] * wish[j];
        nearest.rows.insert(nearest.rows.end(), cut.slope.begin(), cut.slope.end());
        nearest.right.push_back(-value);
      }
      const ContactAccelerations<S> found = LeastConstraint<S>(nearest).solve();
      if (!found.is_found) return false;
      for (std::size_t j = 0; j < open(); ++j) at[j] = wish[j] + found.change[j];
      if (!(length_of(at) > S(1e-6) * length_of(wish))) return false;
      if (!add_tangents(at, true, S(none() * length_of(at)), cuts)) return true;
    }
    return true;
  }

  /// Friction whose contacts bear nothing bears nothing.
  void leave_idle_friction() {
    idle_.assign(problem_.judged.size(), 0);
    Indices idle;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      const JudgedLoad<S>& one = problem_.judged[i];
      if (!one.has_limit || is_open_[i] == 0 || !(magnitude_of(limit_at(i)) <= none() * size())) continue;
      bool is_fixed = true;
      for (std::size_t j = 0; j < open(); ++j) is_fixed = is_fixed && magnitude_of(limit_slope(i, j)) <= none();
      if (!is_fixed) continue;
      idle_[i] = 1;
      idle.insert(idle.end(), one.rows.begin(), one.rows.end());
    }
    if (idle.empty()) return;
    move(least_change(idle));
    narrow(idle);
  }

  /// It neither bears anything nor can.
  bool is_idle(std::size_t i) const {
    const JudgedLoad<S>& one = problem_.judged[i];
    const bool cannot = one.has_limit ? idle_[i] != 0 : one.is_unloaded && !depends(i);
    return cannot && length_of(forces_at(i)) <= none() * size();
  }

  Indices movable() const {
    Indices result;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i)
      if (is_open_[i] != 0 && depends(i)) result.push_back(i);
    return result;
  }

  Cut cut_along(std::size_t i, const std::vector<S>& direction) const {
    const JudgedLoad<S>& one = problem_.judged[i];
    const S sense = one.has_limit ? S(-1) : S(1);
    Cut cut{i, one.has_limit ? limit_at(i) : S(0), std::vector<S>(open(), S(0))};
    const std::vector<S> forces = forces_at(i);
    for (std::size_t r = 0; r < one.rows.size(); ++r) cut.value += sense * direction[r] * forces[r];
    for (std::size_t j = 0; j < open(); ++j) {
      if (one.has_limit) cut.slope[j] = limit_slope(i, j);
      for (std::size_t r = 0; r < one.rows.size(); ++r)
        cut.slope[j] += sense * direction[r] * force_slope(i, r, j);
    }
    return cut;
  }

  std::vector<Cut> first_cuts(const Indices& of) const {
    std::vector<Cut> cuts;
    for (const std::size_t i : of) {
      const std::size_t count = problem_.judged[i].rows.size();
      for (std::size_t r = 0; r < count; ++r) {
        std::vector<S> direction(count, S(0));
        direction[r] = S(1);
        cuts.push_back(cut_along(i, direction));
        direction[r] = S(-1);
        if (problem_.judged[i].has_limit) cuts.push_back(cut_along(i, direction));
      }
    }
    return cuts;
  }

  /// Where forces in several directions are more than planes so far say, by more than `least`. False: nowhere. `is_rate`: of loads that grow along `at`.
  bool add_tangents(const std::vector<S>& at, bool is_rate, const S& least, std::vector<Cut>& cuts) const {
    bool is_added = false;
    for (const std::size_t i : movable()) {
      if (!has_directions(i)) continue;
      std::vector<S> forces = forces_at(i, at);
      if (is_rate) {
        const std::vector<S> now = forces_at(i);
        for (std::size_t r = 0; r < forces.size(); ++r) forces[r] -= now[r];
      }
      const S all = length_of(forces);
      if (!(all > S(0))) continue;
      for (S& force : forces) force /= all;
      Cut cut = cut_along(i, forces);
      const S margin = height(cut, at, is_rate);
      bool is_known = false;
      for (const Cut& other : cuts)
        is_known = is_known || (other.of == i && !(height(other, at, is_rate) - margin > least));
      if (is_known) continue;
      cuts.push_back(std::move(cut));
      is_added = true;
    }
    return is_added;
  }

  static S height(const Cut& cut, const std::vector<S>& at, bool is_rate) {
    S sum = is_rate ? S(0) : cut.value;
    for (std::size_t j = 0; j < at.size(); ++j) sum += cut.slope[j] * at[j];
    return sum;
  }

  /// The largest margin that all of these have, while others keep theirs, and reactions with which they have it: by proximal steps (R. T. Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898), with
  /// tangents that are added where forces have several directions, until it is known which margins bind: then they lead there at once.
  Level highest(const Indices& of, const std::vector<Bound>& bounds) {
    const S all = size(), rounding = S(16) * Math<S>::epsilon() * all;
    Indices with_bounds = of;
    for (const Bound& bound : bounds) with_bounds.push_back(bound.of);
    std::vector<Cut> cuts = first_cuts(with_bounds);
    std::vector<S> at(open(), S(0)), best = at;
    add_tangents(at, false, rounding, cuts);
    S near = S(0.01);
    Balance balance;
    Level level{least_margin(cuts, bounds, at), {}};
    for (int pass = 0; pass < k_passes; ++pass) {
      const ContactAccelerations<S> found = proximal(cuts, bounds, at, S(4 * all), near);
      if (!found.is_found) break;
      S moved = 0;
      for (std::size_t j = 0; j < open(); ++j) {
        moved = std::max(moved, magnitude_of(found.change[j]));
        at[j] += found.change[j];
      }
      balance = balanced(cuts, bounds, found.reactions, at);
      add_tangents(balance.at, false, rounding, cuts);
      const S there = least_margin(cuts, bounds, balance.at);
      if (balance.is_maximum && there > level.least - rounding && balance.margin - there <= rounding) {
        best = balance.at;
        level.least = there;
        break;
      }
      const bool is_added = add_tangents(at, false, rounding, cuts);
      const S least = least_margin(cuts, bounds, at);
      const bool is_better = least > level.least + rounding;
      if (least > level.least) level.least = least, best = at;
      // Farther steps where planes are nearly level.
      if (is_better && !is_added) near = std::max(S(near / 10), S(1e-10));
      if (!is_added && (!is_better || !(moved > rounding))) break;
    }
    level.bound = balance.bound;
    move(best);
    return level;
  }

  /// A margin near a place: m(at + d) = value + slope d + ½ d curvature d.
  struct Expansion {
    S value;
    std::vector<S> slope;
    DenseMatrix<S> curvature;
  };

  Expansion expand(const Cut& cut, const std::vector<S>& at) const {
    const JudgedLoad<S>& one = problem_.judged[cut.of];
    Expansion result{height(cut, at, false), cut.slope, DenseMatrix<S>(open(), open())};
    if (!has_directions(cut.of)) return result;
    const std::vector<S> forces = forces_at(cut.of, at);
    const S all = length_of(forces);
    if (!(all > S(0))) return result;
    std::vector<S> direction = forces;
    for (S& part : direction) part /= all;
    const Cut tangent = cut_along(cut.of, direction);
    result.value = height(tangent, at, false);
    result.slope = tangent.slope;
    for (std::size_t i = 0; i < open(); ++i) {
      for (std::size_t j = 0; j < open(); ++j) {
        S across = 0, along_i = 0, along_j = 0;
        for (std::size_t r = 0; r < one.rows.size(); ++r) {
          const S f_i = force_slope(cut.of, r, i), f_j = force_slope(cut.of, r, j);
          across += f_i * f_j;
          along_i += direction[r] * f_i;
          along_j += direction[r] * f_j;
        }
        result.curvature(i, j) = (along_i * along_j - across) / all;
      }
    }
    return result;
  }

  /// Where margins that bind balance each other.
  struct Balance {
    std::vector<S> at;
    S margin = 0;             ///< of each of them
    Indices bound;            ///< without those that are given
    bool is_maximum = false;  ///< as far as these tell
  };

  /// Newton's method for the conditions of the maximum, Σ μ ∇m = 0 and Σ μ = 1 with m = s, from near it.
  Balance balanced(const std::vector<Cut>& cuts, const std::vector<Bound>& bounds, const std::vector<S>& multipliers,
                   const std::vector<S>& from) const {
    S largest = 0, sum = 0;
    for (const S& one : multipliers) largest = std::max(largest, one);
    std::vector<Cut> binding;
    std::vector<S> parts;
    Balance result;
    result.at = from;
    for (std::size_t c = 0; c < multipliers.size(); ++c) {
      if (!(multipliers[c] > none() * largest)) continue;
      const std::size_t of = cuts[c].of;
      if (!bound_of(bounds, of)) {
        sum += multipliers[c];
        if (std::find(result.bound.begin(), result.bound.end(), of) == result.bound.end()) result.bound.push_back(of);
      }
      const auto known = std::find_if(binding.begin(), binding.end(), [&](const Cut& one) { return one.of == of; });
      if (known == binding.end() || !has_directions(of)) {
        binding.push_back(cuts[c]);
        parts.push_back(multipliers[c]);
      } else {
        parts[static_cast<std::size_t>(known - binding.begin())] += multipliers[c];
      }
    }
    if (!(sum > S(0))) return result;
    for (S& part : parts) part /= sum;
    constexpr int k_steps = 8;
    const std::size_t d = open(), m = binding.size();
    for (int step = 0; step < k_steps; ++step) {
      DenseMatrix<S> matrix(d + 1 + m, d + 1 + m);
      std::vector<S> right(d + 1 + m, S(0));
      right[d] = S(1);
      for (std::size_t k = 0; k < m; ++k) {
        const Expansion here = expand(binding[k], result.at);
        const std::optional<S> margin = bound_of(bounds, binding[k].of);
        for (std::size_t i = 0; i < d; ++i) {
          matrix(i, d + 1 + k) = matrix(d + 1 + k, i) = here.slope[i];
          for (std::size_t j = 0; j < d; ++j) matrix(i, j) += parts[k] * here.curvature(i, j);
        }
        matrix(d, d + 1 + k) = margin ? S(0) : S(1);
        matrix(d + 1 + k, d) = margin ? S(0) : S(-1);
        right[d + 1 + k] = (margin ? *margin : S(0)) - here.value;
      }
      const std::vector<S> found = solve_dense(std::move(matrix), std::move(right));
      S moved = 0;
      for (std::size_t j = 0; j < d; ++j) {
        result.at[j] += found[j];
        moved = std::max(moved, magnitude_of(found[j]));
      }
      result.margin = found[d];
      for (std::size_t k = 0; k < m; ++k) parts[k] = found[d + 1 + k];
      if (!(moved > S(16) * Math<S>::epsilon() * size())) break;
    }
    result.is_maximum = are_balanced(binding, parts, result.at);
    return result;
  }

  /// No part below 0, and their slopes leave nothing.
  bool are_balanced(const std::vector<Cut>& binding, const std::vector<S>& parts, const std::vector<S>& at) const {
    std::vector<S> slope(open(), S(0));
    S steepest = 0, sum = 0;
    for (std::size_t k = 0; k < binding.size(); ++k) {
      if (parts[k] < -none()) return false;
      sum += parts[k];
      const Expansion here = expand(binding[k], at);
      for (std::size_t j = 0; j < open(); ++j) {
        slope[j] += parts[k] * here.slope[j];
        steepest = std::max(steepest, magnitude_of(S(parts[k] * here.slope[j])));
      }
    }
    return sum > S(0) && length_of(slope) <= none() * steepest;
  }

  /// Nothing: its margin is looked for.
  static std::optional<S> bound_of(const std::vector<Bound>& bounds, std::size_t i) {
    for (const Bound& one : bounds)
      if (one.of == i) return one.margin;
    return std::nullopt;
  }

  static S least_margin(const std::vector<Cut>& cuts, const std::vector<Bound>& bounds, const std::vector<S>& at) {
    S least = 0;
    bool is_first = true;
    for (const Cut& cut : cuts) {
      if (bound_of(bounds, cut.of)) continue;
      const S one = height(cut, at, false);
      if (is_first || one < least) least = one;
      is_first = false;
    }
    return least;
  }

  /// The place with the least ½ (ε |z - at|² + σ²), all margins being `level` - σ or more.
  ContactAccelerations<S> proximal(const std::vector<Cut>& cuts, const std::vector<Bound>& bounds,
                                   const std::vector<S>& at, const S& level, const S& near) const {
    const std::size_t n = open() + 1;
    ContactProblem<S> problem;
    problem.speeds = n;
    problem.metric.assign(n * n, S(0));
    for (std::size_t j = 0; j < n; ++j) problem.metric[j * n + j] = j + 1 < n ? near : S(1);
    for (const Cut& cut : cuts) {
      const std::optional<S> margin = bound_of(bounds, cut.of);
      problem.rows.insert(problem.rows.end(), cut.slope.begin(), cut.slope.end());
      problem.rows.push_back(margin ? S(0) : S(1));
      problem.right.push_back(margin.value_or(level) - height(cut, at, false));
    }
    return LeastConstraint<S>(problem).solve();
  }

  static constexpr int k_passes = 100;

  const LoadProblem<S>& problem_;
  std::vector<S> norms_;      ///< of rows, in the metric of masses: reactions times these have one unit
  DenseMatrix<S> basis_;      ///< what may be added to reactions
  std::vector<S> reactions_;  ///< times norms
  std::vector<char> is_shared_, is_open_, idle_;  ///< of judged loads
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_LOAD_SHARES_HPP
