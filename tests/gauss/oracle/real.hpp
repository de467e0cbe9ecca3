#pragma once
// Fifty digits, so that plain difference quotients are exact enough to be an oracle.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace gaussgen::oracle {

using Real = boost::multiprecision::cpp_bin_float_50;
using Vec = std::vector<Real>;
using Mat = std::vector<Vec>;
using Vec3 = std::array<Real, 3>;
using Values = std::map<std::string, Real>;

/// Solves a x = b by elimination with row pivots.
inline Vec solve(Mat a, Vec b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

inline Mat inverse(const Mat& a) {
  Mat columns;
  for (std::size_t j = 0; j < a.size(); ++j) {
    Vec unit(a.size(), 0);
    unit[j] = 1;
    columns.push_back(solve(a, unit));
  }
  Mat result(a.size(), Vec(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) result[i][j] = columns[j][i];
  }
  return result;
}

/// |a - b| relative to the larger of |b| and 1, as a double for messages.
inline double deviation(const Real& a, const Real& b) {
  const Real scale = abs(b) > 1 ? Real(abs(b)) : Real(1);
  return static_cast<double>(Real(abs(a - b) / scale));
}

}  // namespace gaussgen::oracle
