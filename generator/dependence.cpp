#include "dependence.hpp"

#include "generic_point.hpp"

namespace gaussgen {

namespace {

/// Rows up to and with `last`.
evaluate::Matrix upper(const evaluate::Matrix& matrix, std::size_t last) {
  evaluate::Matrix result(last + 1, matrix.columns(), matrix(0, 0));
  for (std::size_t i = 0; i <= last; ++i) {
    for (std::size_t j = 0; j < matrix.columns(); ++j) result(i, j) = matrix(i, j);
  }
  return result;
}

/// For each row, whether those before it give it.
template <class Rank>
std::vector<bool> dependent_rows(const evaluate::Matrix& matrix, Rank rank) {
  std::vector<bool> dependent;
  std::size_t before = 0;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    const std::size_t with = rank(upper(matrix, i));
    dependent.push_back(with == before);
    before = with;
  }
  return dependent;
}

bool is_zero_row(const evaluate::Matrix& matrix, std::size_t i) {
  for (std::size_t j = 0; j < matrix.columns(); ++j) {
    if (!cln::zerop(matrix(i, j))) return false;
  }
  return true;
}

}  // namespace

std::vector<Dependence> dependences(Mechanics& mechanics, ModelValues& values) {
  if (mechanics.dynamics.l() == 0 || mechanics.dynamics.n() == 0) return {};
  const auto here = values(mechanics.dynamics.b);
  if (!here) return {};
  const std::vector<bool> dependent = dependent_rows(*here, [&](const auto& rows) { return values.rank(rows); });
  std::vector<Dependence> result;
  for (std::size_t mu = 0; mu < dependent.size(); ++mu) {
    if (dependent[mu]) result.push_back({mu, is_zero_row(*here, mu), false});
  }
  if (result.empty()) return result;
  const std::vector<bool> everywhere = dependent_rows(GenericPoint(mechanics)(mechanics.dynamics.b), generic_rank);
  for (Dependence& found : result) found.everywhere = everywhere[found.index];
  return result;
}

}  // namespace gaussgen
