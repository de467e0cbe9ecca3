#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ir/expr.hpp"
#include "strategy/steps.hpp"

namespace gaussgen::strategy {

using Vector = std::vector<ir::Expr>;
using Matrix = std::vector<Vector>;  ///< rows

/// How many times its rounding error a pivot has to exceed, or nothing is left of it.
inline constexpr int k_lost_to_rounding = 4;

/// What a pivot of inertia has to keep of the sum that it is the rest of, after this many pivots: a quarter of the digits of what is divided by it are
/// left then, some 1e-4 in double, or anything at all after very many. A larger multiple of epsilon would ask for digits that float does not have.
ir::Expr trusted_part(int pivots, ir::Expr epsilon);

/// What the response of a constraint has to keep of its diagonal entry for a solution to be taken that is corrected once: the error that is left is the square of
/// rounding divided by this part, and that is rounding again.
ir::Expr kept_by_rows(ir::Expr epsilon);

/// What the response of a constraint alone has to be above, of what it can be where parts may turn (Reach): `kept_by_rows`. Below, the row nearly vanishes,
/// and how many rows are left is a matter of all of them.
ir::Expr least_response(ir::Expr response, ir::Expr epsilon);

/// What to do with a pivot that has lost all its digits.
enum class Dependent {
  divide,  ///< as with any other: the result is not finite, and status says so
  drop,    ///< its unknown becomes zero: a redundant row of constraints then leaves the accelerations right
};

/// Unrolled L D Lᵀ of a symmetric positive definite matrix (Golub & Van Loan, Matrix Computations, 4.1). Rows are taken in
/// an order that keeps L sparse: next is always the one with the fewest entries left; every order is stable.
class Ldl {
 public:
  /// `labels` name rows; entries appear as <prefix>_pivot_<row> and <prefix>_factor_<row>_<column>.
  Ldl(const Matrix& matrix, const std::vector<std::string>& labels, const std::string& prefix, ir::Expr epsilon,
      Steps& steps, Dependent dependent = Dependent::divide);

  /// x with matrix x = right_hand_side; unknowns appear as <name>_<row>.
  Vector solve(const Vector& right_hand_side, const std::string& name, Steps& steps) const;

  /// Boolean: some pivot is not positive or too small beside what it is the rest of to divide by: `trusted_part`. Pivots that are diagonal entries themselves
  /// cannot cancel and are compared with 0.
  ir::Expr singular() const;

  /// Boolean: the same of responses of constraints: `kept_by_rows`, and the part `least` of that; diagonal entries by `least_response`.
  ir::Expr dependent(const ir::Rational& least) const;

  /// Rows whose pivot vanishes identically: the matrix is singular in every configuration.
  std::vector<std::string> vanishing() const;

 private:
  /// What is left of the matrix: the rows that are not eliminated yet, by column; zeros have no entry.
  using Rest = std::vector<std::map<std::size_t, ir::Expr>>;

  /// A factor below the pivot of its column.
  struct Entry {
    std::size_t row;
    ir::Expr value;
  };

  void eliminate(std::size_t pivot, Rest& rest, Steps& steps);
  void find_size(std::size_t pivot, Steps& steps);
  void find_size_by_factors(std::size_t pivot, Steps& steps);
  const Entry* entry_below(std::size_t column, std::size_t row) const;
  void sort_columns();

  ir::Expr tolerance(std::size_t pivot) const;
  ir::Expr violated(ir::Expr part, const std::function<ir::Expr(ir::Expr)>& least_original) const;
  int count() const { return static_cast<int>(d_.size()); }
  ir::Expr reciprocal(std::size_t pivot) const;

  ir::Graph& graph_;
  ir::Expr epsilon_;
  Dependent dependent_;
  std::vector<std::string> labels_;
  std::string prefix_;
  std::vector<std::size_t> order_;
  Vector diagonal_;
  Vector sizes_;                                    ///< whose rounding is in the pivots
  std::vector<std::map<std::size_t, ir::Expr>> w_;  ///< L⁻¹ below its diagonal, by row
  std::vector<char> is_original_;                   ///< the pivot is the diagonal entry itself
  Vector d_;
  std::vector<std::vector<Entry>> l_;  ///< by column, rows in the order of elimination
};

}  // namespace gaussgen::strategy
