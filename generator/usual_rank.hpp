#pragma once
// How many of the constraints say something of their own: where the mechanism usually is, on its equations of positions, and not beside them.

#include <optional>
#include <string>
#include <vector>

#include "dense.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// States that nothing singles out, at which all equations of positions hold. A closed loop has constraints that follow from the others
/// there (a Bennett linkage three of five), and beside them does not: rank has no meaning off the equations.
class UsualStates {
 public:
  explicit UsualStates(Mechanics& mechanics);

  /// Positions that satisfy the equations were found.
  bool are_known() const { return !states_.empty(); }

  /// Rows over the free speeds that do not follow from each other, in the state where these are the most: sines as emitted code has them (gauss/constrained.hpp), to a
  /// tolerance. Nothing where no position is known or an entry has no value.
  std::optional<std::vector<std::size_t>> independent(const strategy::Matrix& rows, double tolerance) const;

  /// Where no other place is found near the one at which the searches begin: the rank there. Nothing where there are others, or the search comes to none.
  std::optional<std::size_t> rank_where_alone(const strategy::Matrix& rows) const;

 private:
  struct State {
    std::vector<double> configuration, speeds;
    double rounding = 0;  ///< sines that are less say nothing here
  };

  evaluate::Evaluator<double> values_at(const State& state) const;
  std::optional<Eigen::MatrixXd> rows_at(const State& state, const strategy::Matrix& rows) const;
  std::optional<Eigen::MatrixXd> rows_that_last(const State& state, const strategy::Matrix& rows) const;

  Mechanics& mechanics_;
  std::vector<State> states_;
  std::optional<State> alone_;
  std::optional<State> beside_;  ///< not on the equations of positions
};

/// Sine of the angle to all others, with masses as the metric, below which a constraint follows from them: the model's, or that of emitted code in double.
double rank_tolerance(const model::Model& model);

/// Of rows over the free speeds, in a usual state; in a generic one where no usual one is found.
std::size_t rank_to(double tolerance, const strategy::Matrix& rows, Mechanics& mechanics);

/// Likewise to the tolerance that the model asks for, else exactly: what nearly follows from other rows, and is left out by emitted code in double, is a rank lower
/// than usual, and in its status.
std::size_t usual_rank(const strategy::Matrix& rows, Mechanics& mechanics);

/// Of all constraints; found once.
std::size_t usual_rank(Mechanics& mechanics);

/// As many of them that do not follow from each other there.
std::vector<std::size_t> usual_base(Mechanics& mechanics);

/// Without those whose gradient vanishes wherever they hold (Mechanics::vanishing): beside that, where a search has come to, it has a direction.
std::size_t rank_that_holds(Mechanics& mechanics);

/// Of a mechanism whose constraints hold at one place alone, as far as searches near it see, such as a triangle of bars that is stretched: speeds that they leave there to first
/// order, and that lead nowhere. Nothing where there is none.
std::optional<std::size_t> locked_motions(Mechanics& mechanics);

/// Motions that all constraints leave: free speeds less that; none where they are locked.
std::size_t mobility(Mechanics& mechanics);

/// "mobility 1 (3 speeds, 6 constraints of rank 2)", "mobility 0 (3 speeds, 2 constraints, which lock 2 motions at the only place near)"; empty without constraints, and
/// where counting would take long.
std::string mobility_in_words(Mechanics& mechanics);

}  // namespace gaussgen
