#include "kinematics/solve_sparse.hpp"

#include <algorithm>

#include "support/assert.hpp"

namespace gaussgen::kinematics {

using ir::Expr;

namespace {

/// Minors are as many as subsets of columns.
constexpr std::size_t k_most_minors = 4;

using Vector = std::vector<Expr>;
using Matrix = std::vector<Vector>;
using Indices = std::vector<std::size_t>;

/// Expansion along the first row.
Expr determinant(const Matrix& matrix, ir::Graph& graph) {
  if (matrix.empty()) return {graph, graph.constant(1)};
  Expr sum(graph, graph.constant(0));
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    if (matrix[0][j].is_zero()) continue;
    Matrix minor;
    for (std::size_t i = 1; i < matrix.size(); ++i) {
      minor.push_back(matrix[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    const Expr term = matrix[0][j] * determinant(minor, graph);
    sum = j % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

/// Cramer's rule, with one divisor for all; nothing where that is 0 as it is written.
std::optional<Vector> solved_by_minors(const Matrix& matrix, const Vector& right, ir::Graph& graph) {
  const Expr whole = determinant(matrix, graph);
  if (whole.is_zero()) return std::nullopt;
  Vector values;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    Matrix replaced = matrix;
    for (std::size_t i = 0; i < replaced.size(); ++i) replaced[i][k] = right[i];
    values.push_back(determinant(replaced, graph) * ir::pow(whole, -1));
  }
  return values;
}

/// L U of a matrix of which most is on its diagonal, which is where pivots are taken from if there is anything.
class Elimination {
 public:
  explicit Elimination(const Matrix& matrix) : rows_(matrix) {
    for (std::size_t k = 0; k < rows_.size() && is_regular_; ++k) eliminate(k);
  }

  bool is_regular() const { return is_regular_; }

  Vector solve(Vector right) const {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k) std::swap(right[k], right[taken_[k]]);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = k + 1; i < n; ++i) right[i] -= rows_[i][k] * right[k];
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) right[k] -= rows_[k][j] * right[j];
      right[k] = right[k] * ir::pow(rows_[k][k], -1);
    }
    return right;
  }

 private:
  void eliminate(std::size_t k) {
    const auto pivot = std::find_if(rows_.begin() + static_cast<std::ptrdiff_t>(k), rows_.end(),
                                    [&](const Vector& row) { return !row[k].is_zero(); });
    is_regular_ = pivot != rows_.end();
    if (!is_regular_) return;
    taken_.push_back(static_cast<std::size_t>(pivot - rows_.begin()));
    std::swap(rows_[k], *pivot);
    for (std::size_t i = k + 1; i < rows_.size(); ++i) {
      rows_[i][k] = rows_[i][k] * ir::pow(rows_[k][k], -1);
      for (std::size_t j = k + 1; j < rows_.size(); ++j) rows_[i][j] -= rows_[i][k] * rows_[k][j];
    }
  }

  Matrix rows_;  ///< U and, below its diagonal, L
  std::vector<std::size_t> taken_;
  bool is_regular_ = true;
};

Vector rest_of(const Matrix& matrix, Vector right, const Vector& x) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) right[i] -= matrix[i][j] * x[j];
  }
  return right;
}

/// Corrected once: pivots are not chosen by their size, which nobody knows here, and may be small.
std::optional<Vector> solved_by_elimination(const Matrix& matrix, const Vector& right) {
  const Elimination elimination(matrix);
  if (!elimination.is_regular()) return std::nullopt;
  Vector values = elimination.solve(right);
  const Vector change = elimination.solve(rest_of(matrix, right, values));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] += change[k];
  return values;
}

class Solver {
 public:
  Solver(const Matrix& matrix, Vector right, LargeBlocks large)
      : matrix_(matrix),
        right_(std::move(right)),
        large_(large),
        graph_(right_.front().graph()),
        found_(matrix.size()) {
    for (std::size_t i = 0; i < matrix.size(); ++i) rows_.push_back(i);
  }

  std::optional<Vector> run() {
    while (!rows_.empty()) {
      const auto single =
          std::find_if(rows_.begin(), rows_.end(), [&](std::size_t row) { return unknowns(row).size() == 1; });
      const Indices block = single == rows_.end() ? coupled_with(rows_.front()) : Indices{*single};
      if (!solve(block)) return std::nullopt;
    }
    Vector result;
    for (const std::optional<Expr>& value : found_) result.push_back(*value);
    return result;
  }

 private:
  Indices unknowns(std::size_t row) const {
    Indices columns;
    for (std::size_t j = 0; j < found_.size(); ++j) {
      if (!found_[j] && !matrix_[row][j].is_zero()) columns.push_back(j);
    }
    return columns;
  }

  /// All rows that share unknowns with this one, directly or through others.
  Indices coupled_with(std::size_t first) const {
    Indices block{first};
    for (std::size_t next = 0; next < block.size(); ++next) {
      const Indices columns = unknowns(block[next]);
      for (const std::size_t row : rows_) {
        const bool is_in = std::find(block.begin(), block.end(), row) != block.end();
        const bool touches =
            std::any_of(columns.begin(), columns.end(), [&](std::size_t j) { return !matrix_[row][j].is_zero(); });
        if (touches && !is_in) block.push_back(row);
      }
    }
    std::sort(block.begin(), block.end());
    return block;
  }

  bool solve(const Indices& block) {
    Indices columns;
    for (const std::size_t row : block) {
      for (const std::size_t j : unknowns(row)) {
        if (std::find(columns.begin(), columns.end(), j) == columns.end()) columns.push_back(j);
      }
    }
    std::sort(columns.begin(), columns.end());
    const bool is_large = block.size() > k_most_minors;
    if (columns.size() != block.size() || (is_large && large_ == LargeBlocks::refuse)) return false;
    Matrix square;
    Vector rest;
    for (const std::size_t row : block) {
      square.emplace_back();
      for (const std::size_t j : columns) square.back().push_back(matrix_[row][j]);
      rest.push_back(without_found(row));
    }
    const auto values = is_large ? solved_by_elimination(square, rest) : solved_by_minors(square, rest, graph_);
    if (!values) return false;
    for (std::size_t k = 0; k < columns.size(); ++k) found_[columns[k]] = (*values)[k];
    for (const std::size_t row : block) rows_.erase(std::find(rows_.begin(), rows_.end(), row));
    return true;
  }

  Expr without_found(std::size_t row) const {
    Expr rest = right_[row];
    for (std::size_t j = 0; j < found_.size(); ++j) {
      if (found_[j] && !matrix_[row][j].is_zero()) rest = rest - matrix_[row][j] * *found_[j];
    }
    return rest;
  }

  const Matrix& matrix_;
  Vector right_;
  LargeBlocks large_;
  ir::Graph& graph_;
  std::vector<std::optional<Expr>> found_;
  Indices rows_;  ///< that are not used yet
};

}  // namespace

std::optional<Vector> solve_sparse(const Matrix& matrix, Vector right, LargeBlocks large) {
  GAUSS_ASSERT(!right.empty() && matrix.size() == right.size(), "{}", matrix.size());
  return Solver(matrix, std::move(right), large).run();
}

}  // namespace gaussgen::kinematics
