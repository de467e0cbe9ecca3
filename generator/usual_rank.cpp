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
#include "nearest_position.hpp"
#include "repeated_numbers.hpp"
#include "strategy/projection.hpp"
#include "usual_places.hpp"

namespace gaussgen {

namespace {

/// Of speeds times speeds and constraints.
constexpr std::size_t k_most_entries = 10'000;

constexpr int k_states = 3;
constexpr double k_solved =
    1e-10;  ///< of what an equation is made of: double roots are found so far, and the rank follows what is left
constexpr double k_double_root = 1e-6;  ///< likewise, where a place may be off by the root of rounding
constexpr double k_rounding = 1e-12;  ///< of a row where others are of length 1, at positions that are good to rounding

Eigen::MatrixXd of_unit_rows(Eigen::MatrixXd matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double size = matrix.row(i).norm();
    if (size > 0) matrix.row(i) /= size;
  }
  return matrix;
}

/// That none of the others follows from, the one that is farthest from those before first.
std::vector<std::size_t> independent_rows(const Eigen::MatrixXd& matrix, double tolerance) {
  std::vector<std::size_t> rows;
  if (matrix.size() == 0) return rows;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(of_unit_rows(matrix).transpose());
  for (Eigen::Index k = 0; k < std::min(matrix.rows(), matrix.cols()); ++k) {
    if (std::abs(qr.matrixQR()(k, k)) > tolerance)
      rows.push_back(static_cast<std::size_t>(qr.colsPermutation().indices()(k)));
  }
  return rows;
}

std::size_t rank_of(const Eigen::MatrixXd& matrix, double tolerance) {
  return independent_rows(matrix, tolerance).size();
}

}  // namespace

UsualStates::UsualStates(Mechanics& mechanics) : mechanics_(mechanics) {
  if (mechanics.dynamics.n() == 0) return;
  RepeatedNumbers numbers;
  UsualPlaces places(mechanics, 0, numbers);
  const auto state_here = [&] {
    State state{places.equations().position(), {}, places.rounding()};
    for (std::size_t i = 0; i < mechanics.dynamics.n(); ++i) state.speeds.push_back(numbers());
    return state;
  };
  for (int k = 0; k < k_states && places.next(k_solved); ++k) states_.push_back(state_here());
  if (places.came_back()) {
    places.go_back();
    alone_ = state_here();
  }
  if (!are_known() && !alone_) return;
  places.go_beside();
  beside_ = state_here();
  // Where branches meet, all that were found may be on another one than that on which the model starts.
  if (!are_known()) return;
  const Approach start = long_approach(mechanics, strategy::open_positions(mechanics.model, mechanics.expressions), 0);
  if (!start.is_solved) return;
  places.equations().set(start.position);
  states_.push_back(state_here());
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

std::optional<std::vector<std::size_t>> UsualStates::independent(const strategy::Matrix& rows, double tolerance) const {
  if (!are_known()) return std::nullopt;
  std::vector<std::size_t> most;
  for (std::size_t k = 0; k < states_.size() && !rows.empty(); ++k) {
    const auto here = rows_that_last(states_[k], rows);
    if (!here) return std::nullopt;
    std::vector<std::size_t> found = independent_rows(*here, std::max(tolerance, states_[k].rounding));
    if (found.size() > most.size()) most = std::move(found);
  }
  return most;
}

std::optional<std::size_t> UsualStates::rank_where_alone(const strategy::Matrix& rows) const {
  if (!alone_ || rows.empty()) return std::nullopt;
  const auto here = rows_that_last(*alone_, rows);
  return here ? std::optional(rank_of(*here, std::max(k_double_root, alone_->rounding))) : std::nullopt;
}

// A row that is small beside what it is elsewhere is what the place is off by, as that of a bar in line with others.
std::optional<Eigen::MatrixXd> UsualStates::rows_that_last(const State& state, const strategy::Matrix& rows) const {
  auto here = rows_at(state, rows);
  const auto beside = rows_at(*beside_, rows);
  if (!here || !beside) return here;
  for (Eigen::Index i = 0; i < here->rows(); ++i) {
    if (here->row(i).norm() <= k_double_root * beside->row(i).norm()) here->row(i).setZero();
  }
  return here;
}

/// Over speeds of which inertias are 1.
std::optional<Eigen::MatrixXd> UsualStates::rows_at(const State& state, const strategy::Matrix& rows) const {
  evaluate::Evaluator<double> values = values_at(state);
  std::vector<double> sizes;
  for (const ir::Expr inertia : strategy::inertias(mechanics_.dynamics))
    sizes.push_back(values(inertia.id()).value_or(0));
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(sizes.size()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      const auto value = values(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].id());
      if (!value || !std::isfinite(*value)) return std::nullopt;
      matrix(i, j) = *value;
    }
  }
  if (matrix.size() > 0) matrix *= scales_of_columns(sizes, matrix).asDiagonal();
  return matrix;
}

double rank_tolerance(const model::Model& model) {
  const double least = std::sqrt(std::numeric_limits<double>::epsilon()) / 16;
  return model.rank_tolerance ? std::max(least, support::to_double(*model.rank_tolerance)) : least;
}

namespace {

const UsualStates& usual_states(Mechanics& mechanics) {
  if (!mechanics.usual_states) mechanics.usual_states = std::make_shared<UsualStates>(mechanics);
  return *mechanics.usual_states;
}

}  // namespace

std::size_t rank_to(double tolerance, const strategy::Matrix& rows, Mechanics& mechanics) {
  if (const auto found = usual_states(mechanics).independent(rows, tolerance)) return found->size();
  return generic_rank(GenericPoint(mechanics)(rows));
}

namespace {

double usual_tolerance(const model::Model& model) { return model.rank_tolerance ? rank_tolerance(model) : k_rounding; }

}  // namespace

std::size_t usual_rank(const strategy::Matrix& rows, Mechanics& mechanics) {
  return rank_to(usual_tolerance(mechanics.model), rows, mechanics);
}

std::vector<std::size_t> usual_base(Mechanics& mechanics) {
  const strategy::Matrix& rows = mechanics.dynamics.b;
  if (auto found = usual_states(mechanics).independent(rows, usual_tolerance(mechanics.model))) return *found;
  const evaluate::Matrix here = GenericPoint(mechanics)(rows);
  const std::vector<std::size_t> dependent = dependent_rows(multiply(here, transposed(here)));
  std::vector<std::size_t> base;
  for (std::size_t mu = 0; mu < rows.size(); ++mu) {
    if (std::find(dependent.begin(), dependent.end(), mu) == dependent.end()) base.push_back(mu);
  }
  return base;
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

std::optional<std::size_t> locked_motions(Mechanics& mechanics) {
  const auto rank = usual_states(mechanics).rank_where_alone(mechanics.dynamics.b);
  return rank && *rank < mechanics.dynamics.n() ? std::optional(mechanics.dynamics.n() - *rank) : std::nullopt;
}

std::size_t mobility(Mechanics& mechanics) {
  return locked_motions(mechanics) ? 0 : mechanics.dynamics.n() - rank_that_holds(mechanics);
}

std::string mobility_in_words(Mechanics& mechanics) {
  const std::size_t n = mechanics.dynamics.n(), l = mechanics.dynamics.l();
  if (l == 0 || n * (n + l) > k_most_entries) return "";
  const auto locked = locked_motions(mechanics);
  const std::size_t rank = locked ? n - *locked : rank_that_holds(mechanics);
  const std::string of_rank = rank < l ? fmt::format(" of rank {}", rank) : "";
  const std::string where = locked ? fmt::format(": {} motion{} to first order, which lead{} to no other place near",
                                                 *locked, *locked == 1 ? "" : "s", *locked == 1 ? "s" : "")
                                   : "";
  return fmt::format("mobility {} ({} speed{}, {} constraint{}{}{})", mobility(mechanics), n, n == 1 ? "" : "s", l,
                     l == 1 ? "" : "s", of_rank, where);
}

}  // namespace gaussgen
