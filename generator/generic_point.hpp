#pragma once
// What holds in every configuration, seen at one configuration that nothing singles out.

#include "evaluate/arithmetic_paired.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/dense.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// A matrix that is singular here is singular everywhere, up to an accident: coordinates, speeds, inputs, time and
/// parameters lie near those of the initial state, but apart from each other and from round numbers. No simplification of
/// expressions can tell this: sin(2x) - 2 sin(x) cos(x) is zero in any form.
class GenericPoint {
 public:
  explicit GenericPoint(ModelGraph& motion) : motion_(motion) {}

  /// What is nothing but rounding is zero in it. Where entries have no value at any point that was tried, only their pattern
  /// counts: equal expressions are equal numbers, others are not.
  evaluate::Matrix operator()(const strategy::Matrix& matrix);

 private:
  using Number = evaluate::Scaled<cln::cl_F>;
  using Values = evaluate::Evaluator<Number>;

  Values& values_near_start(int attempt);
  static std::optional<evaluate::Matrix> matrix_of(const strategy::Matrix& matrix, Values& values,
                                                   bool replaces_undefined);

  ModelGraph& motion_;
  std::vector<Values> points_;  ///< by attempt
};

/// Whether an expression is zero there, also one that came out of many divisions, through which the bounds of GenericPoint grow
/// beyond its value: see Arithmetic<Paired>.
class VanishesEverywhere {
 public:
  explicit VanishesEverywhere(ModelGraph& motion) : motion_(motion) {}

  bool operator()(ir::Expr expression);

 private:
  using Values = evaluate::Evaluator<evaluate::Paired>;

  Values values(int attempt);

  ModelGraph& motion_;
  std::vector<Values> points_;  ///< by attempt
};

/// Number of independent rows, whatever the units of rows and columns.
std::size_t generic_rank(const evaluate::Matrix& matrix);

/// Of a metric: those rows that are combinations of earlier ones.
std::vector<std::size_t> dependent_rows(evaluate::Matrix metric);

/// Those columns that are combinations of other columns.
std::vector<std::size_t> dependent_columns(const evaluate::Matrix& matrix);

}  // namespace gaussgen
