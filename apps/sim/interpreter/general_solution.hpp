#pragma once
// The general solution of constrained systems, of sizes that are known at run time: that of the prelude, with the same operations.

#include <cstddef>

#include "gauss/constrained.hpp"
#include "sim/interpreter/program.hpp"

namespace gausssim {

/// For the classes of the prelude, which have arrays for `most` speeds and as many constraints.
template <int count>
struct SizesUpTo {
  static constexpr int N = count, L = count;
  int n = 0, l = 0, most = 0;
};

template <class S, int count>
struct SystemUpTo {
  S g[count][count], f[count], b[count][count], reach[count][count];
  S of_positions[count], off[count], drift[count], drift_error[count];
};

template <class S>
gauss::RankRule<S> rank_rule(const Solve& solve, const S* slots) {
  const S tolerance = solve.has_tolerance ? gauss::rank_tolerance<S>(slots[solve.tolerance]) : S(0);
  switch (solve.rule) {
    case RankRuleKind::positions:
      return solve.has_tolerance ? gauss::rank_on_positions<S>(solve.usual, tolerance)
                                 : gauss::rank_on_positions<S>(solve.usual);
    case RankRuleKind::velocities:
      return solve.has_tolerance ? gauss::rank_of_velocities<S>(solve.usual, tolerance)
                                 : gauss::rank_of_velocities<S>(solve.usual);
    default:
      return solve.has_tolerance ? gauss::rank_of_steps<S>(solve.usual, tolerance)
                                 : gauss::rank_of_steps<S>(solve.usual);
  }
}

/// A system of the frame, solved with arrays for `count`.
template <class S, int count>
class GeneralSolution {
 public:
  GeneralSolution(const Solve& solve, S* slots) : solve_(solve), slots_(slots) {}

  void solve() {
    gauss::LinearSolution<S, count, count> solution;
    constrained().solve(solution);
    give(solution);
  }

  /// gauss::solve_each.
  gauss::Status solve_each() {
    const auto found = constrained();
    const int n = solve_.speeds, l = solve_.rows;
    S nothing = S(0);
    for (int k = 0; k < solve_.sides; ++k) {
      S f[count], drift[count], accelerations[count];
      read(solve_.forces, k, n, f);
      read(solve_.drifts, k, l, drift);
      found.respond(f, drift, accelerations);
      S* const given = slots_ + solve_.solution + static_cast<std::ptrdiff_t>(k) * n;
      for (int i = 0; i < n; ++i) {
        given[i] = accelerations[i];
        nothing = nothing + (accelerations[i] - accelerations[i]);
      }
    }
    return gauss::Math<S>::status(false, false, gauss::Math<S>::not_finite(nothing));
  }

 private:
  using Constrained = gauss::detail::Constrained<S, SizesUpTo<count>>;

  Constrained constrained() const {
    const int n = solve_.speeds, l = solve_.rows;
    SystemUpTo<S, count> system;
    read_matrix(solve_.g, n, n, system.g);
    read_matrix(solve_.b, l, n, system.b);
    read_matrix(solve_.reach, l, n, system.reach);
    read(solve_.f, 0, n, system.f);
    read(solve_.of_positions, 0, l, system.of_positions);
    read(solve_.off, 0, l, system.off);
    read(solve_.drift, 0, l, system.drift);
    read(solve_.drift_error, 0, l, system.drift_error);
    return Constrained(system, rank_rule<S>(solve_, slots_), SizesUpTo<count>{n, l, n < l ? n : l});
  }

  void read_matrix(Slot from, int rows, int columns, S (&to)[count][count]) const {
    for (int i = 0; i < rows; ++i) read(from, i, columns, to[i]);
  }

  /// Row i of a matrix that begins at `from`.
  void read(Slot from, int i, int columns, S (&to)[count]) const {
    const S* const row = slots_ + from + static_cast<std::ptrdiff_t>(i) * columns;
    for (int j = 0; j < columns; ++j) to[j] = row[j];
  }

  /// In the order of layout_of_solution.
  void give(const gauss::LinearSolution<S, count, count>& solution) {
    S* next = slots_ + solve_.solution;
    for (int i = 0; i < solve_.speeds; ++i) *next++ = solution.accelerations[i];
    for (int mu = 0; mu < solve_.rows; ++mu) *next++ = solution.multipliers[mu];
    for (int mu = 0; mu < solve_.rows; ++mu) *next++ = solution.is_shared[mu];
    *next++ = solution.rank;
    for (const gauss::Status status : {solution.motion, solution.step, solution.reactions})
      *next++ = S(static_cast<int>(status));
  }

  const Solve& solve_;
  S* slots_;
};

/// Calls `work` with a solution whose arrays are as small as there are.
template <class S, class Work>
auto with_general_solution(const Solve& solve, S* slots, const Work& work) {
  const int most = solve.speeds < solve.rows ? solve.rows : solve.speeds;
  if (most <= 8) return work(GeneralSolution<S, 8>(solve, slots));
  if (most <= 32) return work(GeneralSolution<S, 32>(solve, slots));
  return work(GeneralSolution<S, k_most_of_system>(solve, slots));
}

}  // namespace gausssim
