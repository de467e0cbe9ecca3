#include "agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dense.hpp"
#include "repeated_numbers.hpp"
#include "usual_places.hpp"

namespace gaussgen {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In units of the model's time; no part of anybody's period.
constexpr std::array<double, 3> k_times{0.3713, 1.7171, 0.0391};
constexpr double k_left = 1e4;  ///< times rounding

constexpr unsigned k_seed = 1986;  ///< not that of other checks, which have looked at their states already

struct Somewhere {
  Linearised at;
  double least;  ///< of rows of length 1: what is left of a combination, or of what it asks for, is nothing
};

/// At a place where equations of positions hold; nothing where none is found.
std::optional<Somewhere> somewhere(Mechanics& mechanics, double time, RepeatedNumbers& numbers) {
  UsualPlaces places(mechanics, time, numbers);
  if (!places.next()) return std::nullopt;
  const std::vector<bool>& all = places.equations().movable();
  std::vector<double> speeds;
  for (std::size_t i = 0; i < all.size(); ++i) speeds.push_back(numbers());
  auto at = places.equations().of_speeds(speeds, all);
  return at ? std::optional(Somewhere{std::move(*at), k_left * places.rounding()}) : std::nullopt;
}

VectorXd row_of(const Linearised& at, std::size_t index) {
  return Eigen::Map<const VectorXd>(at.j[index].data(), static_cast<Index>(at.j[index].size()));
}

/// Nothing where the row is no combination of the others.
std::optional<bool> agree_at(const Somewhere& place, const std::vector<std::size_t>& others, std::size_t index) {
  const Linearised& at = place.at;
  const VectorXd last = row_of(at, index);
  MatrixXd columns(last.size(), static_cast<Index>(others.size()));
  VectorXd lengths(columns.cols());
  for (Index k = 0; k < columns.cols(); ++k) {
    const VectorXd row = row_of(at, others[static_cast<std::size_t>(k)]);
    lengths[k] = row.norm() > 0 ? row.norm() : 1;
    columns.col(k) = row / lengths[k];
  }
  const VectorXd parts =
      columns.cols() == 0 ? VectorXd(0) : VectorXd(columns.completeOrthogonalDecomposition().solve(last));
  const VectorXd left = columns.cols() == 0 ? last : VectorXd(last - columns * parts);
  if (left.norm() > place.least * last.norm()) return std::nullopt;
  double sum = at.f[index], size = at.size[index];
  for (Index k = 0; k < columns.cols(); ++k) {
    const std::size_t other = others[static_cast<std::size_t>(k)];
    sum -= parts[k] / lengths[k] * at.f[other];
    size += std::abs(parts[k]) / lengths[k] * at.size[other];
  }
  return std::abs(sum) <= place.least * size;
}

}  // namespace

std::optional<bool> agree_elsewhere(Mechanics& mechanics, const std::vector<std::size_t>& others,
                                    const std::vector<std::size_t>& more, std::size_t index, double part) {
  RepeatedNumbers numbers(k_seed);
  std::optional<bool> result;
  for (const double time : k_times) {
    auto at = somewhere(mechanics, time, numbers);
    if (at) at->least = std::max(at->least, part);
    auto agree = at ? agree_at(*at, others, index) : std::nullopt;
    // The row of a loop across its plane, which vanishes at the initial state, takes others where the plane has turned.
    if (at && !agree) agree = agree_at(*at, more, index);
    if (agree && !*agree) return false;
    if (agree) result = true;
  }
  return result;
}

}  // namespace gaussgen
