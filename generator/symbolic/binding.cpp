#include "symbolic/binding.hpp"

#include <functional>

#include "support/assert.hpp"

namespace gaussgen::symbolic {

namespace {

struct Block {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> columns;
};

/// Connected components of the pattern of non-zero entries: two rows belong together when they share a column.
std::vector<Block> blocks_of(const Matrix& matrix) {
  const std::size_t n = matrix.size();
  std::vector<bool> row_done(n, false);
  std::vector<bool> column_done(n, false);
  std::vector<Block> blocks;
  std::function<void(std::size_t, Block&)> visit = [&](std::size_t row, Block& block) {
    row_done[row] = true;
    for (std::size_t column = 0; column < n; ++column) {
      if (column_done[column] || matrix[row][column].is_zero()) continue;
      column_done[column] = true;
      for (std::size_t other = 0; other < n; ++other) {
        if (!row_done[other] && !matrix[other][column].is_zero()) visit(other, block);
      }
    }
  };
  std::vector<bool> row_before(n, false);
  std::vector<bool> column_before(n, false);
  for (std::size_t row = 0; row < n; ++row) {
    if (row_done[row]) continue;
    Block block;
    visit(row, block);
    for (std::size_t i = 0; i < n; ++i) {
      if (row_done[i] && !row_before[i]) block.rows.push_back(i);
      if (column_done[i] && !column_before[i]) block.columns.push_back(i);
    }
    row_before = row_done;
    column_before = column_done;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

Matrix explicit_inverse(const Matrix& m) {
  if (m.size() == 1) return {{1 / m[0][0]}};
  const ex determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return {{m[1][1] / determinant, -m[0][1] / determinant}, {-m[1][0] / determinant, m[0][0] / determinant}};
}

}  // namespace

ex Bindings::define(const std::string& name, const ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value)) return value;
  const ex symbol = GiNaC::realsymbol(name);
  all_.push_back(Definition{name, symbol, value});
  return symbol;
}

Matrix Bindings::invert_block(OpaqueInverse block) {
  const std::size_t n = block.matrix.size();
  if (n <= 2) return explicit_inverse(block.matrix);
  block.entries = Matrix(n, std::vector<ex>(n, ex(0)));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const bool is_mirrored = block.is_symmetric && j < i;
      block.entries[i][j] = is_mirrored
                                ? block.entries[j][i]
                                : ex(GiNaC::realsymbol(block.name + "_" + block.rows[i] + "_" + block.columns[j]));
    }
  }
  all_.push_back(block);
  return block.entries;
}

Matrix Bindings::invert(const std::string& name, const std::vector<std::string>& rows,
                        const std::vector<std::string>& columns, const Matrix& matrix, bool is_symmetric) {
  const std::size_t n = matrix.size();
  Matrix inverse(n, std::vector<ex>(n, ex(0)));
  for (const Block& block : blocks_of(matrix)) {
    // The rows of the inverse are the columns of the matrix.
    OpaqueInverse part{name, {}, {}, is_symmetric, {}, {}};
    GAUSS_ASSERT(block.rows.size() == block.columns.size(), "{} is singular by structure", name);
    for (const std::size_t column : block.columns) part.rows.push_back(rows[column]);
    for (const std::size_t row : block.rows) {
      part.columns.push_back(columns[row]);
      std::vector<ex> entries;
      for (const std::size_t column : block.columns) entries.push_back(matrix[row][column]);
      part.matrix.push_back(std::move(entries));
    }
    const Matrix entries = invert_block(std::move(part));
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
      for (std::size_t j = 0; j < block.rows.size(); ++j) inverse[block.columns[i]][block.rows[j]] = entries[i][j];
    }
  }
  return inverse;
}

}  // namespace gaussgen::symbolic
