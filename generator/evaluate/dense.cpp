#include "evaluate/dense.hpp"

#include <cln/float.h>
#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/assert.hpp"

namespace gaussgen::evaluate {

using cln::cl_F;

namespace {

/// largest = max(largest, candidate); both have the same precision.
void raise_to(cl_F& largest, const cl_F& candidate) {
  if (candidate > largest) largest = candidate;
}

/// log2 |x|, of numbers beyond the range of double, too.
double size_of(const cl_F& x) {
  if (cln::zerop(x)) return -std::numeric_limits<double>::infinity();
  const auto exponent = cln::float_exponent(x);
  return static_cast<double>(exponent) + std::log2(cln::double_approx(cln::scale_float(cln::abs(x), -exponent)));
}

/// Elimination with full pivoting of A with b beside it. Zeros cost nothing, and pivots are found by doubles: matrices of long mechanisms are
/// large, and mostly zero.
class Elimination {
 public:
  Elimination(Matrix a, Vector b) : a_(std::move(a)), b_(std::move(b)), column_of_(a_.columns()) {
    for (std::size_t j = 0; j < column_of_.size(); ++j) column_of_[j] = j;
    for (std::size_t i = 0; i < a_.rows(); ++i) {
      for (std::size_t j = 0; j < a_.columns(); ++j) sizes_.push_back(size_of(a_(i, j)));
    }
  }

  /// Number of pivots larger than `limit`; stops at the first that is not.
  std::size_t run(const cl_F& limit) {
    const std::size_t most = std::min(a_.rows(), a_.columns());
    for (std::size_t k = 0; k < most; ++k) {
      bring_pivot_to(k);
      if (!(cln::abs(a_(k, k)) > limit)) return k;
      eliminate_below(k);
    }
    return most;
  }

  /// Unknowns that are not zero in all of A x = 0, where `rank` pivots are not: those of the columns behind them, and of pivots that depend on one of
  /// these by more than `tolerance`.
  std::vector<std::size_t> open_unknowns(std::size_t rank, const cl_F& tolerance) const {
    std::vector<char> is_open(rank, 0);
    for (std::size_t free = rank; free < a_.columns(); ++free) {
      const Vector x = null_vector(rank, free);
      for (std::size_t k = 0; k < rank; ++k) {
        if (cln::abs(x[k]) > tolerance) is_open[k] = 1;
      }
    }
    std::vector<std::size_t> open(column_of_.begin() + static_cast<std::ptrdiff_t>(rank), column_of_.end());
    for (std::size_t k = 0; k < rank; ++k) {
      if (is_open[k] != 0) open.push_back(column_of_[k]);
    }
    std::sort(open.begin(), open.end());
    return open;
  }

  Vector back_substituted() const {
    const std::size_t n = a_.columns();
    Vector x = b_;
    for (std::size_t k = n; k-- > 0;) {
      cl_F sum = b_[k];
      for (std::size_t j = k + 1; j < n; ++j) sum = sum - a_(k, j) * x[column_of_[j]];
      x[column_of_[k]] = sum / a_(k, k);
    }
    return x;
  }

 private:
  /// The pivots' part of x with A x = 0 where one of the other unknowns is 1 and the rest are 0.
  Vector null_vector(std::size_t rank, std::size_t free) const {
    const cl_F zero = cln::cl_float(0, a_(0, 0));
    Vector x(rank, zero);
    for (std::size_t k = rank; k-- > 0;) {
      cl_F sum = -a_(k, free);
      for (std::size_t j = k + 1; j < rank; ++j) {
        if (!cln::zerop(x[j]) && !cln::zerop(a_(k, j))) sum = sum - a_(k, j) * x[j];
      }
      x[k] = cln::zerop(sum) ? zero : sum / a_(k, k);
    }
    return x;
  }

  double& size(std::size_t i, std::size_t j) { return sizes_[i * a_.columns() + j]; }

  void bring_pivot_to(std::size_t k) {
    std::size_t row = k;
    std::size_t column = k;
    for (std::size_t i = k; i < a_.rows(); ++i) {
      for (std::size_t j = k; j < a_.columns(); ++j) {
        if (size(i, j) > size(row, column)) {
          row = i;
          column = j;
        }
      }
    }
    swap_rows(k, row);
    swap_columns(k, column);
  }

  void swap_rows(std::size_t i, std::size_t k) {
    if (i == k) return;
    for (std::size_t j = 0; j < a_.columns(); ++j) {
      std::swap(a_(i, j), a_(k, j));
      std::swap(size(i, j), size(k, j));
    }
    std::swap(b_[i], b_[k]);
  }

  void swap_columns(std::size_t j, std::size_t k) {
    if (j == k) return;
    for (std::size_t i = 0; i < a_.rows(); ++i) {
      std::swap(a_(i, j), a_(i, k));
      std::swap(size(i, j), size(i, k));
    }
    std::swap(column_of_[j], column_of_[k]);
  }

  void eliminate_below(std::size_t k) {
    std::vector<std::size_t> columns;
    for (std::size_t j = k; j < a_.columns(); ++j) {
      if (!cln::zerop(a_(k, j))) columns.push_back(j);
    }
    for (std::size_t i = k + 1; i < a_.rows(); ++i) {
      if (cln::zerop(a_(i, k))) continue;
      const cl_F factor = a_(i, k) / a_(k, k);
      for (const std::size_t j : columns) {
        a_(i, j) = a_(i, j) - factor * a_(k, j);
        size(i, j) = size_of(a_(i, j));
      }
      b_[i] = b_[i] - factor * b_[k];
    }
  }

  Matrix a_;
  Vector b_;
  std::vector<double> sizes_;           ///< of the entries of A
  std::vector<std::size_t> column_of_;  ///< which unknown a column stands for
};

cl_F largest_entry(const Matrix& a) {
  cl_F largest = cln::abs(a(0, 0));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.columns(); ++j) raise_to(largest, cln::abs(a(i, j)));
  }
  return largest;
}

Matrix rows_equilibrated(Matrix a) {
  for (std::size_t i = 0; i < a.rows(); ++i) {
    cl_F largest = cln::abs(a(i, 0));
    for (std::size_t j = 1; j < a.columns(); ++j) raise_to(largest, cln::abs(a(i, j)));
    if (cln::zerop(largest)) continue;
    for (std::size_t j = 0; j < a.columns(); ++j) a(i, j) = a(i, j) / largest;
  }
  return a;
}

}  // namespace

Matrix transposed(const Matrix& a) {
  GAUSS_ASSERT(a.rows() > 0 && a.columns() > 0, "{} by {}", a.rows(), a.columns());
  Matrix result(a.columns(), a.rows(), a(0, 0));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.columns(); ++j) result(j, i) = a(i, j);
  }
  return result;
}

Matrix multiply(const Matrix& a, const Matrix& b) {
  GAUSS_ASSERT(a.columns() == b.rows() && a.columns() > 0, "{} columns, {} rows", a.columns(), b.rows());
  Matrix result(a.rows(), b.columns(), a(0, 0));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < b.columns(); ++j) {
      for (std::size_t k = 0; k < a.columns(); ++k) result(i, j) = result(i, j) + a(i, k) * b(k, j);
    }
  }
  return result;
}

Vector multiply(const Matrix& a, const Vector& x) {
  GAUSS_ASSERT(a.columns() == x.size() && !x.empty(), "{} columns, {} entries", a.columns(), x.size());
  Vector result(a.rows(), cln::cl_float(0, x[0]));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.columns(); ++j) result[i] = result[i] + a(i, j) * x[j];
  }
  return result;
}

std::optional<Vector> solve(const Matrix& a, const Vector& b) {
  GAUSS_ASSERT(a.rows() == a.columns() && b.size() == a.rows(), "{} by {} and {}", a.rows(), a.columns(), b.size());
  if (b.empty()) return Vector{};
  const cl_F largest = largest_entry(a);
  // What elimination leaves of a singular matrix is rounding: some units of the largest entry.
  const cl_F limit = cln::scale_float(largest, 4 - static_cast<sintC>(cln::float_digits(largest))) *
                     cln::cl_float(static_cast<int>(a.rows()), largest);
  Elimination elimination(a, b);
  if (elimination.run(limit) < a.rows()) return std::nullopt;
  return elimination.back_substituted();
}

std::size_t rank(const Matrix& a, const cl_F& tolerance) {
  if (a.rows() == 0 || a.columns() == 0) return 0;
  return Elimination(a, Vector(a.rows(), a(0, 0))).run(tolerance * largest_entry(a));
}

std::vector<std::size_t> open_unknowns(const Matrix& a, const cl_F& tolerance) {
  if (a.rows() == 0 || a.columns() == 0) return {};
  Elimination elimination(a, Vector(a.rows(), a(0, 0)));
  const std::size_t rank = elimination.run(tolerance * largest_entry(a));
  return elimination.open_unknowns(rank, tolerance);
}

Matrix scaled_symmetric(const Matrix& a) {
  GAUSS_ASSERT(a.rows() == a.columns(), "{} by {}", a.rows(), a.columns());
  Vector factors;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    const cl_F size = cln::abs(a(i, i));
    factors.push_back(cln::zerop(size) ? cln::cl_float(1, size) : cln::recip(cln::sqrt(size)));
  }
  Matrix result = a;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.columns(); ++j) result(i, j) = factors[i] * a(i, j) * factors[j];
  }
  return result;
}

Matrix equilibrated(const Matrix& a) {
  if (a.rows() == 0 || a.columns() == 0) return a;
  return transposed(rows_equilibrated(transposed(rows_equilibrated(a))));
}

cl_F backward_error(const Matrix& a, const Vector& x, const Vector& b) {
  GAUSS_ASSERT(a.rows() == b.size() && a.columns() == x.size() && !b.empty() && !x.empty(), "{} by {}, {} and {}",
               a.rows(), a.columns(), x.size(), b.size());
  cl_F worst = cln::cl_float(0, b[0]);
  for (std::size_t i = 0; i < a.rows(); ++i) {
    cl_F residual = b[i];
    cl_F size = cln::abs(b[i]);
    for (std::size_t j = 0; j < a.columns(); ++j) {
      residual = residual - a(i, j) * x[j];
      size = size + cln::abs(a(i, j) * x[j]);
    }
    if (!cln::zerop(size)) raise_to(worst, cln::abs(residual) / size);
  }
  return worst;
}

}  // namespace gaussgen::evaluate
