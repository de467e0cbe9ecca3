#include "strategy/elimination.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "ir/cost.hpp"
#include "ir/traverse.hpp"
#include "strategy/safety.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

struct Pivot {
  Safety safety = Safety::unknown;
  int operations = 0;
  std::size_t entries = 0;  ///< in its row: few entries mean little fill
  std::size_t row = 0;
  std::size_t column = 0;

  // Among equals the coordinate declared last becomes dependent, so that the first ones stay independent.
  friend bool operator<(const Pivot& a, const Pivot& b) {
    return std::tie(a.safety, a.entries, a.operations, a.row, b.column) <
           std::tie(b.safety, b.entries, b.operations, b.row, a.column);
  }
};

class GaussJordan {
 public:
  GaussJordan(const Dynamics& dynamics, const std::vector<std::size_t>& allowed)
      : dynamics_(dynamics),
        is_chosen_(!allowed.empty()),
        b_(dynamics.b),
        drift_(dynamics.b_drift),
        row_used_(dynamics.l(), 0),
        column_allowed_(dynamics.n(), 0) {
    for (std::size_t j = 0; j < dynamics.n(); ++j) {
      column_allowed_[j] = allowed.empty() || std::find(allowed.begin(), allowed.end(), j) != allowed.end() ? 1 : 0;
    }
  }

  bool run(Elimination& result) {
    for (std::size_t step = 0; step < b_.size(); ++step) {
      const Pivot pivot = best_pivot();
      if (pivot.safety == Safety::unknown) return false;
      for (const Addition& addition : additions(pivot.row, pivot.column)) result.additions.push_back(addition);
      row_used_[pivot.row] = 1;
      column_allowed_[pivot.column] = 0;
      result.dependent.push_back(pivot.column);
      result.rows.push_back(pivot.row);
      result.pivots.push_back(b_[pivot.row][pivot.column]);
      clear_column(pivot);
    }
    return true;
  }

  Expr entry(std::size_t row, std::size_t column) const { return b_[row][column]; }
  Expr drift(std::size_t row) const { return drift_[row]; }

 private:
  Pivot best_pivot() {
    Pivot best;
    for (std::size_t i = 0; i < b_.size(); ++i) {
      if (row_used_[i] != 0) continue;
      const auto entries =
          static_cast<std::size_t>(std::count_if(b_[i].begin(), b_[i].end(), [](Expr e) { return !e.is_zero(); }));
      for (std::size_t j = 0; j < b_[i].size(); ++j) {
        if (column_allowed_[j] == 0) continue;
        const Expr e = b_[i][j];
        const Pivot candidate{safety(e), ir::count_operations(e.graph(), {e.id()}, true).total(), entries, i, j};
        if (candidate.safety != Safety::unknown && candidate < best && (is_chosen_ || !drowns_others(i, j)))
          best = candidate;
      }
    }
    return best;
  }

  // a_c = -Σ (b_j/b_c) a_j puts g_cc (b_j/b_c)² beside g_jj: of that, rounding leaves nothing where it is much less.
  bool drowns_others(std::size_t row, std::size_t column) {
    const std::vector<Addition> all = additions(row, column);
    return std::any_of(all.begin(), all.end(),
                       [&](const Addition& each) { return each.drowns(dynamics_.at_parameters); });
  }

  std::vector<Addition> additions(std::size_t row, std::size_t column) {
    std::vector<Addition> result;
    const std::optional<Expr> own = inertia(column);
    if (!dynamics_.at_parameters || !own) return result;
    for (std::size_t j = 0; j < b_[row].size(); ++j) {
      if (j == column || b_[row][j].is_zero()) continue;
      const std::optional<Expr> entry = bound_of(b_[row][j]);
      const std::optional<Expr> before = inertia(j);
      if (entry && before) result.push_back({*own * pow(*entry / b_[row][column], 2), *before});
    }
    return result;
  }

  const std::optional<Expr>& inertia(std::size_t speed) {
    const auto known = inertias_.find(speed);
    if (known != inertias_.end()) return known->second;
    const Expr g = dynamics_.g[speed][speed];
    const bool is_fixed = ir::is_of_parameters(g.graph(), g.id());  // then it needs no sign
    return inertias_.emplace(speed, is_fixed ? std::optional<Expr>(g) : bound_of(g)).first->second;
  }

  // Gauss-Jordan: the pivot row is scaled to 1, and the column vanishes from every other row.
  void clear_column(const Pivot& pivot) {
    const Expr reciprocal = pow(b_[pivot.row][pivot.column], -1);
    for (Expr& e : b_[pivot.row]) e = e * reciprocal;
    drift_[pivot.row] = drift_[pivot.row] * reciprocal;
    for (std::size_t i = 0; i < b_.size(); ++i) {
      const Expr factor = b_[i][pivot.column];
      if (i == pivot.row || factor.is_zero()) continue;
      for (std::size_t j = 0; j < b_[i].size(); ++j) b_[i][j] = b_[i][j] - factor * b_[pivot.row][j];
      drift_[i] = drift_[i] - factor * drift_[pivot.row];
    }
  }

  const Dynamics& dynamics_;
  bool is_chosen_;                                       ///< by whoever wrote the model
  std::map<std::size_t, std::optional<Expr>> inertias_;  ///< g_cc at most
  Matrix b_;
  Vector drift_;
  std::vector<char> row_used_;
  std::vector<char> column_allowed_;
};

}  // namespace

std::optional<Elimination> eliminate(const Dynamics& dynamics, const std::vector<std::size_t>& allowed, Steps& steps) {
  GaussJordan elimination(dynamics, allowed);
  Elimination result;
  if (!elimination.run(result)) return std::nullopt;
  for (std::size_t j = 0; j < dynamics.n(); ++j) {
    if (std::find(result.dependent.begin(), result.dependent.end(), j) == result.dependent.end()) {
      result.independent.push_back(j);
    }
  }
  steps.begin("dependent accelerations: a_m = c_m_p a_p + drift_m, c = -b^-1 b_p (3.6)");
  for (std::size_t i = 0; i < result.dependent.size(); ++i) {
    const std::string label = dynamics.labels[result.dependent[i]];
    Vector row;
    for (const std::size_t p : result.independent) {
      row.push_back(steps.name(-elimination.entry(result.rows[i], p), "c_" + label + "_" + dynamics.labels[p]));
    }
    result.c_dep.push_back(row);
    result.drift.push_back(steps.name(-elimination.drift(result.rows[i]), "c_drift_" + label));
  }
  return result;
}

}  // namespace gaussgen::strategy
