#include "reduction.hpp"

#include <algorithm>

#include "strategy/projection.hpp"

namespace gaussgen {

using analysis::Independent;
using analysis::Matrix;
using analysis::Real;
using analysis::Vector;

namespace {

constexpr double k_open = 1, k_stated = 1e-3, k_named = 1e3;
constexpr Real k_singular = 1e-12L;

std::vector<std::size_t> as_indices(Eigen::Index count) {
  std::vector<std::size_t> all;
  for (Eigen::Index i = 0; i < count; ++i) all.push_back(static_cast<std::size_t>(i));
  return all;
}

/// x over the dependent columns with rows * x = right, over the rows that determine them; nothing where these do not.
std::optional<Matrix> solved(const Matrix& rows, const Independent& choice, const Matrix& right) {
  if (choice.dependent.empty()) return Matrix(0, right.cols());
  const Matrix system = analysis::part(rows, choice.rows, choice.dependent);
  Eigen::FullPivLU<Matrix> solver(system);
  solver.setThreshold(k_singular);
  if (!solver.isInvertible()) return std::nullopt;
  return solver.solve(analysis::part(right, choice.rows, as_indices(right.cols()))).eval();
}

void put(Matrix& into, Eigen::Index offset, const std::vector<std::size_t>& rows, const Matrix& values) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    into.row(offset + static_cast<Eigen::Index>(rows[i])) = values.row(static_cast<Eigen::Index>(i));
}

}  // namespace

Preferences::Preferences(Mechanics& mechanics) {
  const auto worth = [](bool is_open) { return is_open ? k_open : k_stated; };
  for (const bool is_open : strategy::open_positions(mechanics.model, mechanics.expressions))
    positions.push_back(worth(is_open));
  for (const bool is_open : strategy::open_speeds(mechanics.model, mechanics.expressions))
    speeds.push_back(worth(is_open));
  for (const model::Name& name : mechanics.model.dependent) {
    for (const auto i : mechanics.symbols.speeds.indices()) {
      if (mechanics.symbols.speeds[i].label == name.text) speeds[i.value] = k_named;
    }
  }
}

IndependentChoice choose(const Preferences& preferences, const LinearNumbers& numbers) {
  const auto n = numbers.positions_by_state.cols();
  IndependentChoice choice;
  choice.positions = analysis::choose_independent(numbers.positions_by_state, preferences.positions);
  choice.speeds = analysis::choose_independent(numbers.velocities_by_state.rightCols(n), preferences.speeds);
  choice.all = choice.positions.independent;
  for (const std::size_t i : choice.speeds.independent) choice.all.push_back(static_cast<std::size_t>(n) + i);
  return choice;
}

std::optional<ReducedMotion> reduce(const LinearNumbers& numbers, const IndependentChoice& choice) {
  const auto n = numbers.positions_by_state.cols();
  const auto count = static_cast<Eigen::Index>(choice.all.size());
  const auto positions = static_cast<Eigen::Index>(choice.position_count());
  ReducedMotion result;
  Matrix& all = result.parametrised;
  all = Matrix::Zero(2 * n, count);
  for (Eigen::Index k = 0; k < count; ++k)
    all(static_cast<Eigen::Index>(choice.all[static_cast<std::size_t>(k)]), k) = 1;
  const Matrix& F = numbers.positions_by_state;
  const auto moved =
      solved(F, choice.positions, -analysis::part(F, as_indices(F.rows()), choice.positions.independent));
  if (!moved) return std::nullopt;
  Matrix dependent = Matrix::Zero(moved->rows(), count);
  dependent.leftCols(positions) = *moved;
  put(all, 0, choice.positions.dependent, dependent);
  // What displacements and independent speeds do to the constraints, the dependent speeds undo.
  const Matrix& C = numbers.velocities_by_state;
  const auto speeds = solved(C.rightCols(n), choice.speeds, -(C * all));
  if (!speeds) return std::nullopt;
  put(all, n, choice.speeds.dependent, *speeds);
  all = analysis::without_rounding(all, Matrix::Constant(all.rows(), count, all.cwiseAbs().maxCoeff()));
  const auto whole = as_indices(count);
  result.A = analysis::part(analysis::product(numbers.by_state, all), choice.all, whole);
  result.B = analysis::part(numbers.by_inputs, choice.all, as_indices(numbers.by_inputs.cols()));
  result.rates = analysis::part(numbers.rates, choice.all, {0}).col(0);
  result.by_time = analysis::part(numbers.by_time, choice.all, {0}).col(0);
  return result;
}

std::optional<Vector> closing(const LinearNumbers& numbers, const IndependentChoice& choice) {
  const auto n = numbers.positions_by_state.cols();
  Matrix change = Matrix::Zero(2 * n, 1);
  const auto moved = solved(numbers.positions_by_state, choice.positions, -numbers.positions);
  if (!moved) return std::nullopt;
  put(change, 0, choice.positions.dependent, *moved);
  const Vector left = numbers.velocities + numbers.velocities_by_state * change;
  const auto speeds = solved(numbers.velocities_by_state.rightCols(n), choice.speeds, -left);
  if (!speeds) return std::nullopt;
  put(change, n, choice.speeds.dependent, *speeds);
  return change.col(0);
}

}  // namespace gaussgen
