#include "kinematics/solve_sparse.hpp"

#include <algorithm>

#include "support/assert.hpp"

namespace gaussgen::kinematics {

using ir::Expr;

namespace {

constexpr std::size_t k_largest_block = 4;

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

class Solver {
 public:
  Solver(const Matrix& matrix, Vector right)
      : matrix_(matrix), right_(std::move(right)), graph_(right_.front().graph()), found_(matrix.size()) {
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
    if (columns.size() != block.size() || block.size() > k_largest_block) return false;
    Matrix square;
    Vector rest;
    for (const std::size_t row : block) {
      square.emplace_back();
      for (const std::size_t j : columns) square.back().push_back(matrix_[row][j]);
      rest.push_back(without_found(row));
    }
    const Expr whole = determinant(square, graph_);
    if (whole.is_zero()) return false;
    Vector values;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Matrix replaced = square;
      for (std::size_t i = 0; i < replaced.size(); ++i) replaced[i][k] = rest[i];
      values.push_back(determinant(replaced, graph_) * ir::pow(whole, -1));
    }
    for (std::size_t k = 0; k < columns.size(); ++k) found_[columns[k]] = values[k];
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
  ir::Graph& graph_;
  std::vector<std::optional<Expr>> found_;
  Indices rows_;  ///< that are not used yet
};

}  // namespace

std::optional<Vector> solve_sparse(const Matrix& matrix, Vector right) {
  GAUSS_ASSERT(!right.empty() && matrix.size() == right.size(), "{}", matrix.size());
  return Solver(matrix, std::move(right)).run();
}

}  // namespace gaussgen::kinematics
