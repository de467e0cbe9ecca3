// Singular values by one-sided Jacobi rotations (Hestenes 1958): columns are turned in pairs until all are orthogonal;
// their lengths are the singular values.

#include <cln/real.h>

#include <algorithm>

#include "evaluate/dense.hpp"

namespace gaussgen::evaluate {

using cln::cl_F;

namespace {

constexpr int k_most_sweeps = 100;

cl_F column_product(const Matrix& a, std::size_t p, std::size_t q) {
  cl_F sum = cln::cl_float(0, a(0, 0));
  for (std::size_t i = 0; i < a.rows(); ++i) sum = sum + a(i, p) * a(i, q);
  return sum;
}

/// Makes columns p and q orthogonal; false if they are so already.
bool turn(Matrix& a, std::size_t p, std::size_t q) {
  const cl_F alpha = column_product(a, p, p);
  const cl_F beta = column_product(a, q, q);
  const cl_F gamma = column_product(a, p, q);
  if (cln::zerop(gamma)) return false;
  const cl_F size = cln::sqrt(alpha * beta);
  const cl_F rounding = cln::scale_float(size, 3 - static_cast<sintC>(cln::float_digits(size)));
  if (cln::abs(gamma) <= rounding * static_cast<int>(a.rows())) return false;
  // The smaller root t of t² + 2 ζ t - 1 = 0, the tangent of the angle.
  const cl_F one = cln::cl_float(1, size);
  const cl_F zeta = (beta - alpha) / (2 * gamma);
  const cl_F root = one / (cln::abs(zeta) + cln::sqrt(one + zeta * zeta));
  const cl_F tangent = cln::minusp(zeta) ? -root : root;
  const cl_F cosine = one / cln::sqrt(one + tangent * tangent);
  const cl_F sine = cosine * tangent;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    const cl_F left = a(i, p);
    const cl_F right = a(i, q);
    a(i, p) = cosine * left - sine * right;
    a(i, q) = sine * left + cosine * right;
  }
  return true;
}

}  // namespace

Vector singular_values(const Matrix& original) {
  if (original.rows() == 0 || original.columns() == 0) return {};
  Matrix a = original.rows() < original.columns() ? transposed(original) : original;
  bool turned = true;
  for (int sweep = 0; turned && sweep < k_most_sweeps; ++sweep) {
    turned = false;
    for (std::size_t p = 0; p + 1 < a.columns(); ++p) {
      for (std::size_t q = p + 1; q < a.columns(); ++q) turned = turn(a, p, q) || turned;
    }
  }
  Vector values;
  for (std::size_t j = 0; j < a.columns(); ++j) values.push_back(cln::sqrt(column_product(a, j, j)));
  std::sort(values.begin(), values.end(), [](const cl_F& x, const cl_F& y) { return x > y; });
  return values;
}

std::optional<cl_F> condition(const Matrix& a) {
  const Vector values = singular_values(a);
  if (values.empty()) return std::nullopt;
  const cl_F& largest = values.front();
  const cl_F noise = cln::scale_float(largest, 4 - static_cast<sintC>(cln::float_digits(largest)));
  if (values.back() <= noise) return std::nullopt;
  return largest / values.back();
}

}  // namespace gaussgen::evaluate
