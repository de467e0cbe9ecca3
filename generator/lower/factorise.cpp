#include "lower/factorise.hpp"

#include <stdexcept>

#include "ir/traverse.hpp"
#include "support/assert.hpp"

namespace gaussgen::lower {

using ir::Expr;

namespace {

ExprMatrix constant_matrix(ir::Graph& graph, std::size_t n, int diagonal) {
  ExprMatrix matrix(n, std::vector<Expr>(n, Expr(graph, graph.constant(0))));
  for (std::size_t i = 0; i < n; ++i) matrix[i][i] = Expr(graph, graph.constant(diagonal));
  return matrix;
}

struct Factors {
  ExprMatrix L;
  std::vector<Expr> D;
};

Factors ldlt(const ExprMatrix& M, const MatrixNames& names) {
  const std::size_t n = M.size();
  Factors f{constant_matrix(M[0][0].graph(), n, 1), {}};
  for (std::size_t j = 0; j < n; ++j) {
    Expr d = M[j][j];
    for (std::size_t k = 0; k < j; ++k) d -= f.L[j][k] * f.L[j][k] * f.D[k];
    f.D.push_back(d.named("pivot_" + names(j, j)));
    for (std::size_t i = j + 1; i < n; ++i) {
      Expr l = M[i][j];
      for (std::size_t k = 0; k < j; ++k) l -= f.L[i][k] * f.L[j][k] * f.D[k];
      f.L[i][j] = (l / f.D[j]).named("factor_" + names(i, j));
    }
  }
  return f;
}

ExprMatrix unit_lower_inverse(const ExprMatrix& L, const MatrixNames& names) {
  ExprMatrix result = constant_matrix(L[0][0].graph(), L.size(), 1);
  for (std::size_t j = 0; j < L.size(); ++j) {
    for (std::size_t i = j + 1; i < L.size(); ++i) {
      Expr sum = result[i][j];
      for (std::size_t k = j; k < i; ++k) sum -= L[i][k] * result[k][j];
      result[i][j] = sum.named("factor_inverse_" + names(i, j));
    }
  }
  return result;
}

/// 2: a number; 1: depends on parameters alone; 0: varies; -1: zero.
int pivot_rank(Expr entry) {
  if (entry.is_zero()) return -1;
  const ir::Graph& graph = entry.graph();
  if (graph[entry.id()].kind == ir::Kind::constant) return 2;
  for (const ir::NodeId id : ir::post_order(graph, {entry.id()})) {
    if (graph[id].kind == ir::Kind::symbol && ir::varies(graph.symbol(graph[id].symbol))) return 0;
  }
  return 1;
}

}  // namespace

ExprMatrix inverse_by_ldlt(const ExprMatrix& matrix, const MatrixNames& names) {
  const std::size_t n = matrix.size();
  const Factors f = ldlt(matrix, names);
  const ExprMatrix L_inv = unit_lower_inverse(f.L, names);
  ExprMatrix result = constant_matrix(matrix[0][0].graph(), n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) {
      for (std::size_t k = j; k < n; ++k) result[i][j] += L_inv[k][i] * L_inv[k][j] / f.D[k];
      result[i][j] = result[i][j].named(names(i, j));
      result[j][i] = result[i][j];
    }
  }
  return result;
}

namespace {

class Elimination {
 public:
  Elimination(ExprMatrix matrix, const MatrixNames& names, const Vanishes& vanishes)
      : m_(std::move(matrix)),
        right_(constant_matrix(m_[0][0].graph(), m_.size(), 1)),
        names_(names),
        vanishes_(vanishes),
        row_used_(m_.size(), false),
        column_used_(m_.size(), false),
        row_of_column_(m_.size()) {}

  ExprMatrix inverse() {
    for (std::size_t step = 0; step < m_.size(); ++step) eliminate(step);
    ExprMatrix result;
    for (std::size_t column = 0; column < m_.size(); ++column) {
      std::vector<Expr> row;
      for (std::size_t j = 0; j < m_.size(); ++j)
        row.push_back(right_[row_of_column_[column]][j].named(names_(column, j)));
      result.push_back(std::move(row));
    }
    return result;
  }

 private:
  void choose_pivot() {
    int best = -1;
    for (std::size_t i = 0; i < m_.size(); ++i) {
      for (std::size_t j = 0; j < m_.size(); ++j) {
        if (row_used_[i] || column_used_[j]) continue;
        const int rank = pivot_rank(m_[i][j]);
        // Where columns are equal, what is left of one is zero without a simplification that shows it.
        if (rank <= best || (vanishes_ && vanishes_(m_[i][j]))) continue;
        best = rank;
        pivot_row_ = i;
        pivot_column_ = j;
      }
    }
    if (best < 0) throw std::domain_error(names_.name + " has no inverse anywhere");
    row_used_[pivot_row_] = column_used_[pivot_column_] = true;
    row_of_column_[pivot_column_] = pivot_row_;
  }

  void eliminate(std::size_t step) {
    choose_pivot();
    const std::size_t n = m_.size();
    const std::string stage = "step" + std::to_string(step + 1) + "_";
    const Expr pivot = m_[pivot_row_][pivot_column_];
    for (std::size_t j = 0; j < n; ++j) {
      m_[pivot_row_][j] = (m_[pivot_row_][j] / pivot).named(stage + "left_" + names_(j, pivot_row_));
      right_[pivot_row_][j] = (right_[pivot_row_][j] / pivot).named(stage + "right_" + names_(pivot_row_, j));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Expr factor = m_[i][pivot_column_];
      if (i == pivot_row_ || factor.is_zero()) continue;
      for (std::size_t j = 0; j < n; ++j) {
        m_[i][j] = (m_[i][j] - factor * m_[pivot_row_][j]).named(stage + "left_" + names_(j, i));
        right_[i][j] = (right_[i][j] - factor * right_[pivot_row_][j]).named(stage + "right_" + names_(i, j));
      }
      m_[i][pivot_column_] = Expr(pivot.graph(), pivot.graph().constant(0));
    }
  }

  ExprMatrix m_;
  ExprMatrix right_;
  const MatrixNames& names_;
  const Vanishes& vanishes_;
  std::vector<bool> row_used_;
  std::vector<bool> column_used_;
  std::vector<std::size_t> row_of_column_;
  std::size_t pivot_row_ = 0;
  std::size_t pivot_column_ = 0;
};

}  // namespace

ExprMatrix inverse_by_elimination(ExprMatrix matrix, const MatrixNames& names, const Vanishes& vanishes) {
  return Elimination(std::move(matrix), names, vanishes).inverse();
}

}  // namespace gaussgen::lower
