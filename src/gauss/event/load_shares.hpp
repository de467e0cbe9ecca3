// How a load is shared by more reactions than the motion needs, and whether they can bear it (docs/theory.md, section 11).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_LOAD_SHARES_HPP
#define GAUSS_EVENT_LOAD_SHARES_HPP

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "gauss/event/dense.hpp"
#include "gauss/event/largest_margin.hpp"
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
};

/// Reactions along rows, which are gradients by the speeds and stand one after another; some follow from others.
template <class S>
struct LoadProblem {
  std::size_t speeds = 0;
  std::vector<S> metric;  ///< speeds × speeds, positive definite
  std::vector<S> rows;
  std::vector<S> reactions;    ///< one choice of them
  std::vector<char> is_fixed;  ///< of each row: forces contain its reaction, and would be others
  std::vector<JudgedLoad<S>> judged;
  std::function<bool(std::size_t)>
      is_unloaded;  ///< of those judged, a contact that nothing presses but friction: asked where that matters; may be none

  std::size_t count() const { return reactions.size(); }
};

/// Of all reactions that make the same motion: equal stiffness of all that holds tells the part of what is brittle, the least sum of squares of reactions. Of the rest those count that leave
/// the most to what is nearest to its limit: friction and contacts give way without losing what they bear, so they hold if there is any choice in which all of them do (the static theorem of
/// limit analysis; W. Prager and P. G. Hodge, Theory of Perfectly Plastic Solids, 1951, chapter 8).
template <class S>
class LoadShares {
 public:
  explicit LoadShares(const LoadProblem<S>& problem) : problem_(problem), basis_(open_directions()) {
    const std::size_t count = problem.judged.size();
    for (std::size_t k = 0; k < problem.count(); ++k) reactions_.push_back(problem.reactions[k] * norms_[k]);
    for (std::size_t i = 0; i < count; ++i) is_shared_.push_back(depends(i) ? 1 : 0);
    narrow(fixed_rows());
    for (std::size_t i = 0; i < count; ++i) is_open_.push_back(depends(i) ? 1 : 0);
    move(least_change(all_rows(), true));
    narrow(brittle_rows());
    unload();
    leave_idle_friction();
  }

  /// Its reactions are not unique, whether or not forces contain them.
  bool is_shared(std::size_t judged) const { return is_shared_[judged] != 0; }

  /// Of each judged load, nothing where its reactions are unique, unless it is brittle; else how much is left to it, in the unit of its reaction: below 0 where no choice holds.
  std::vector<std::optional<S>> margins() {
    std::vector<std::optional<S>> result(problem_.judged.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      if (is_open_[i] != 0 || problem_.judged[i].is_brittle) result[i] = (is_idle(i) ? size() : value_of(i)) / norm(i);
    const std::vector<std::size_t> movable = those_that_move();
    std::vector<std::optional<S>> floors(movable.size());
    // What is overloaded says nothing of the others: these share what is left.
    while (std::find(floors.begin(), floors.end(), std::nullopt) != floors.end()) {
      const auto found = LargestMargin<S>(margins_of(movable), floors, size()).solve();
      move(found.z);
      for (std::size_t m = 0; m < movable.size(); ++m)
        if (!floors[m]) result[movable[m]] = value_of(movable[m]) / norm(movable[m]);
      // What ends with others ends with them to the last digit.
      for (const std::size_t m : found.binding) {
        result[movable[m]] = found.margin / norm(movable[m]);
        floors[m] = found.margin - rounding();
      }
      if (!(found.margin < S(0)) || found.binding.empty()) break;
    }
    return result;
  }

 private:
  using Indices = std::vector<std::size_t>;

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
  /// What forces contain, and constraints that limits depend on: these would press each other as hard as friction needs.
  Indices fixed_rows() const {
    std::vector<char> is_fixed = problem_.is_fixed;
    for (const JudgedLoad<S>& one : problem_.judged)
      for (std::size_t k = 0; k < problem_.count(); ++k)
        if (magnitude_of(one.per_reaction[k]) > S(0) && !is_contact(k)) is_fixed[k] = 1;
    Indices result;
    for (std::size_t k = 0; k < problem_.count(); ++k)
      if (is_fixed[k] != 0) result.push_back(k);
    return result;
  }
  bool is_contact(std::size_t row) const {
    return std::any_of(problem_.judged.begin(), problem_.judged.end(),
                       [row](const JudgedLoad<S>& one) { return !one.has_limit && one.rows.front() == row; });
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

  /// That leaves least of these rows; `as_forces`: of the reactions themselves, as if all were equally stiff.
  std::vector<S> least_change(const Indices& rows, bool as_forces = false) const {
    const DenseMatrix<S> part = part_of_basis(rows);
    DenseMatrix<S> normal(open(), open());
    std::vector<S> right(open(), S(0));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const S weight = as_forces ? S(1) / (norms_[rows[r]] * norms_[rows[r]]) : S(1);
      for (std::size_t i = 0; i < open(); ++i) {
        right[i] -= weight * part(r, i) * reactions_[rows[r]];
        for (std::size_t j = 0; j < open(); ++j) normal(i, j) += weight * part(r, i) * part(r, j);
      }
    }
    return solve_dense(std::move(normal), std::move(right));
  }

  void move(const std::vector<S>& change) {
    for (std::size_t k = 0; k < problem_.count(); ++k)
      for (std::size_t j = 0; j < open(); ++j) reactions_[k] += basis_(k, j) * change[j];
  }

  /// `factor` times a reaction, over what is open.
  void add_reaction(std::size_t row, const S& factor, Affine<S>& to) const {
    const S part = factor / norms_[row];
    to.value += part * reactions_[row];
    for (std::size_t j = 0; j < open(); ++j) to.slope[j] += part * basis_(row, j);
  }

  Affine<S> nothing() const { return {S(0), std::vector<S>(open(), S(0))}; }

  /// Times the norm of its first row, with which margins have one unit.
  Margin<S> margin_of(std::size_t i) const {
    const JudgedLoad<S>& one = problem_.judged[i];
    Margin<S> result{nothing(), {}};
    if (!one.has_limit) {
      add_reaction(one.rows.front(), norm(i), result.limit);
      return result;
    }
    result.limit.value = norm(i) * one.limit;
    for (std::size_t k = 0; k < problem_.count(); ++k) add_reaction(k, norm(i) * one.per_reaction[k], result.limit);
    for (const std::size_t row : one.rows) {
      result.forces.push_back(nothing());
      add_reaction(row, norm(i), result.forces.back());
    }
    return result;
  }

  const std::vector<Margin<S>>& margins_of(const Indices& judged) {
    margins_.clear();
    for (const std::size_t i : judged) margins_.push_back(margin_of(i));
    return margins_;
  }

  S value_of(std::size_t i) const { return margin_of(i)(std::vector<S>(open(), S(0))); }

  static S steepest(const Affine<S>& of) {
    S result = 0;
    for (const S& one : of.slope) result = std::max(result, magnitude_of(one));
    return result;
  }

  bool depends(std::size_t i) const {
    const Margin<S> margin = margin_of(i);
    return steepest(margin.limit) > none() ||
           std::any_of(margin.forces.begin(), margin.forces.end(),
                       [](const Affine<S>& force) { return steepest(force) > none(); });
  }

  Indices those_that_move() const {
    Indices result;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i)
      if (is_open_[i] != 0 && depends(i)) result.push_back(i);
    return result;
  }

  /// Of what there is, to tell what is none.
  S size() const {
    S result = 0;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      const Margin<S> margin = margin_of(i);
      result = std::max(result, magnitude_of(margin.limit.value));
      for (const Affine<S>& force : margin.forces) result = std::max(result, magnitude_of(force.value));
    }
    return result > S(0) ? result : S(1);
  }
  S rounding() const { return S(64) * Math<S>::epsilon() * size(); }

  /// Contacts whose reactions against each other may grow without end have none of that where nothing else presses them: a body that just fits between two walls
  /// is not held by them.
  void unload() {
    Indices unloaded;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      const JudgedLoad<S>& one = problem_.judged[i];
      if (!one.has_limit && is_open_[i] != 0 && may_jam(i) && is_unloaded(i)) unloaded.push_back(one.rows.front());
    }
    if (unloaded.empty()) return;
    move(least_change(unloaded));
    narrow(unloaded);
  }

  /// Whether there are reactions without a load in which this contact presses and all others hold.
  bool may_jam(std::size_t contact) {
    std::vector<Margin<S>> growing = margins_of(those_that_move());
    for (Margin<S>& margin : growing) {
      margin.limit.value = S(0);
      for (Affine<S>& force : margin.forces) force.value = S(0);
    }
    return has_ray_towards(margin_of(contact).limit.slope, growing);
  }

  /// Friction whose contacts bear nothing bears nothing.
  void leave_idle_friction() {
    idle_.assign(problem_.judged.size(), 0);
    Indices idle;
    for (std::size_t i = 0; i < problem_.judged.size(); ++i) {
      const JudgedLoad<S>& one = problem_.judged[i];
      const Affine<S> limit = margin_of(i).limit;
      if (!one.has_limit || is_open_[i] == 0 || magnitude_of(limit.value) > none() * size() || steepest(limit) > none())
        continue;
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
    if (is_open_[i] == 0 || (one.has_limit ? idle_[i] == 0 : depends(i))) return false;
    return magnitude_of(value_of(i)) <= none() * size() && (one.has_limit || is_unloaded(i));
  }

  bool is_unloaded(std::size_t i) const { return problem_.is_unloaded && problem_.is_unloaded(i); }

  const LoadProblem<S>& problem_;
  std::vector<S> norms_;      ///< of rows, in the metric of masses: reactions times these have one unit
  DenseMatrix<S> basis_;      ///< what may be added to reactions
  std::vector<S> reactions_;  ///< times norms
  std::vector<Margin<S>> margins_;
  std::vector<char> is_shared_, is_open_, idle_;  ///< of judged loads
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_LOAD_SHARES_HPP
