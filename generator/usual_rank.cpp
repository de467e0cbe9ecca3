#include "usual_rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluation.hpp"
#include "generic_point.hpp"
#include "least_step.hpp"
#include "repeated_numbers.hpp"
#include "usual_places.hpp"

namespace gaussgen {

namespace {

/// Of speeds times speeds and constraints.
constexpr std::size_t k_most_entries = 4000;

constexpr int k_states = 3;
constexpr double k_solved =
    1e-10;  ///< of what an equation is made of: double roots are found so far, and the rank follows what is left
constexpr double k_rounding = 1e-12;  ///< of a row where others are of length 1, at positions that are good to rounding

/// Speeds where inertias are 1, rows of unit length.
Eigen::MatrixXd scaled(Eigen::MatrixXd matrix, const std::vector<double>& inertias) {
  matrix *= scales_of_columns(inertias, matrix).asDiagonal();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double size = matrix.row(i).norm();
    if (size > 0) matrix.row(i) /= size;
  }
  return matrix;
}

std::size_t rank_of(const Eigen::MatrixXd& matrix, const std::vector<double>& inertias, double tolerance) {
  if (matrix.size() == 0) return 0;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled(matrix, inertias).transpose());
  std::size_t rank = 0;
  for (Eigen::Index k = 0; k < std::min(matrix.rows(), matrix.cols()); ++k)
    rank += std::abs(qr.matrixQR()(k, k)) > tolerance ? 1 : 0;
  return rank;
}

}  // namespace

UsualStates::UsualStates(Mechanics& mechanics) : mechanics_(mechanics) {
  if (mechanics.dynamics.n() == 0) return;
  RepeatedNumbers numbers;
  UsualPlaces places(mechanics, 0, numbers);
  for (int k = 0; k < k_states && places.next(k_solved); ++k) {
    State state{places.equations().position(), {}, places.rounding()};
    for (std::size_t i = 0; i < mechanics.dynamics.n(); ++i) state.speeds.push_back(numbers());
    states_.push_back(std::move(state));
  }
}

evaluate::Evaluator<double> UsualStates::values_at(const State& state) const {
  evaluate::Evaluator<double> values(mechanics_.graph, evaluate::Arithmetic<double>());
  bind_parameters(mechanics_, values);
  values.bind(mechanics_.symbols.time, 0);
  for (const auto i : mechanics_.symbols.configuration.indices())
    values.bind(mechanics_.symbols.configuration[i].symbol, state.configuration[i.value]);
  for (const auto i : mechanics_.symbols.speeds.indices())
    values.bind(mechanics_.symbols.speeds[i].symbol, state.speeds[i.value]);
  return values;
}

std::optional<std::size_t> UsualStates::rank(const strategy::Matrix& rows, double tolerance) const {
  if (!are_known()) return std::nullopt;
  if (rows.empty()) return 0;
  const strategy::Vector inertias = strategy::inertias(mechanics_.dynamics);
  std::size_t largest = 0;
  for (const State& state : states_) {
    evaluate::Evaluator<double> values = values_at(state);
    std::vector<double> sizes;
    for (const ir::Expr inertia : inertias) sizes.push_back(values(inertia.id()).value_or(0));
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(sizes.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        const auto value = values(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].id());
        if (!value || !std::isfinite(*value)) return std::nullopt;
        matrix(i, j) = *value;
      }
    }
    largest = std::max(largest, rank_of(matrix, sizes, std::max(tolerance, state.rounding)));
  }
  return largest;
}

double rank_tolerance(const model::Model& model) {
  const double least = std::sqrt(std::numeric_limits<double>::epsilon()) / 16;
  return model.rank_tolerance ? std::max(least, support::to_double(*model.rank_tolerance)) : least;
}

std::size_t rank_to(double tolerance, const strategy::Matrix& rows, Mechanics& mechanics) {
  if (!mechanics.usual_states) mechanics.usual_states = std::make_shared<UsualStates>(mechanics);
  if (const auto rank = mechanics.usual_states->rank(rows, tolerance)) return *rank;
  return generic_rank(GenericPoint(mechanics)(rows));
}

std::size_t usual_rank(const strategy::Matrix& rows, Mechanics& mechanics) {
  return rank_to(mechanics.model.rank_tolerance ? rank_tolerance(mechanics.model) : k_rounding, rows, mechanics);
}

std::size_t usual_rank(Mechanics& mechanics) {
  if (!mechanics.usual_rank) mechanics.usual_rank = usual_rank(mechanics.dynamics.b, mechanics);
  return *mechanics.usual_rank;
}

std::size_t rank_that_holds(Mechanics& mechanics) {
  if (mechanics.vanishing.empty()) return usual_rank(mechanics);
  strategy::Matrix rows;
  for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
    if (mechanics.vanishing.count(mu) == 0) rows.push_back(mechanics.dynamics.b[mu]);
  }
  return rows.empty() ? 0 : usual_rank(rows, mechanics);
}

std::size_t mobility(Mechanics& mechanics) { return mechanics.dynamics.n() - rank_that_holds(mechanics); }

std::string mobility_in_words(Mechanics& mechanics) {
  const std::size_t n = mechanics.dynamics.n(), l = mechanics.dynamics.l();
  if (l == 0 || n * (n + l) > k_most_entries) return "";
  const std::size_t rank = rank_that_holds(mechanics);
  const std::string of_rank = rank < l ? fmt::format(" of rank {}", rank) : "";
  return fmt::format("mobility {} ({} speed{}, {} constraint{}{})", n - rank, n, n == 1 ? "" : "s", l,
                     l == 1 ? "" : "s", of_rank);
}

}  // namespace gaussgen
