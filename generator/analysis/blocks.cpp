#include "analysis/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace gaussgen::analysis {

namespace {

constexpr Real k_rounding = 1e-17L;  ///< of a sum in these numbers, of its terms
constexpr Real k_nothing = 1e-30L;   ///< of the largest: what factors have of rounding that come from more digits

using Flags = std::vector<std::vector<char>>;

/// Whether i depends on j, directly or over others (Warshall).
Flags reached(const Matrix& a) {
  const auto n = static_cast<std::size_t>(a.rows());
  Flags reaches(n, std::vector<char>(n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      reaches[i][j] = i == j || a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) != 0 ? 1 : 0;
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      if (reaches[i][k] == 0) continue;
      for (std::size_t j = 0; j < n; ++j) reaches[i][j] = static_cast<char>(reaches[i][j] | reaches[k][j]);
    }
  }
  return reaches;
}

}  // namespace

Matrix without_rounding(const Matrix& sums, const Matrix& terms) {
  Matrix result = sums;
  const Real largest = terms.size() == 0 ? 0 : terms.maxCoeff();
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      if (std::abs(result(i, j)) <= k_rounding * terms(i, j) + k_nothing * largest) result(i, j) = 0;
    }
  }
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) { return without_rounding(a * b, a.cwiseAbs() * b.cwiseAbs()); }

std::vector<std::vector<std::size_t>> blocks(const Matrix& a) {
  const Flags reaches = reached(a);
  const std::size_t n = reaches.size();
  std::vector<std::vector<std::size_t>> result;
  std::vector<char> taken(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (taken[i] != 0) continue;
    std::vector<std::size_t> block;
    for (std::size_t j = i; j < n; ++j) {
      if (j == i || (reaches[i][j] != 0 && reaches[j][i] != 0)) block.push_back(j);
    }
    for (const std::size_t j : block) taken[j] = 1;
    result.push_back(std::move(block));
  }
  // What reaches fewer variables does not depend on what reaches more.
  const auto depends_on = [&](const std::vector<std::size_t>& block) {
    return std::count(reaches[block[0]].begin(), reaches[block[0]].end(), 1);
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const auto& one, const auto& other) { return depends_on(one) < depends_on(other); });
  return result;
}

std::vector<std::size_t> without_effect(const Matrix& a, const std::vector<bool>& candidates) {
  std::vector<bool> left_out(candidates.size(), false);
  std::vector<std::size_t> found;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (!candidates[j] || left_out[j]) continue;
      bool has_effect = false;
      for (std::size_t i = 0; i < candidates.size(); ++i)
        has_effect = has_effect || (!left_out[i] && a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) != 0);
      if (has_effect) continue;
      left_out[j] = true;
      has_changed = true;
      found.push_back(j);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

Matrix part(const Matrix& a, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) {
  Matrix result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j)
      result(i, j) = a(static_cast<Eigen::Index>(rows[static_cast<std::size_t>(i)]),
                       static_cast<Eigen::Index>(columns[static_cast<std::size_t>(j)]));
  }
  return result;
}

}  // namespace gaussgen::analysis
