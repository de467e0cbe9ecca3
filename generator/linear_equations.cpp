#include "linear_equations.hpp"

#include <cmath>
#include <limits>

#include "analysis/blocks.hpp"
#include "derivatives.hpp"
#include "evaluate/decimal.hpp"
#include "evaluation.hpp"
#include "model_values.hpp"

namespace gaussgen {

using analysis::Real;
using cln::cl_F;
using evaluate::Arithmetic;
using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::FreeIndex;
using strategy::Matrix;
using strategy::Vector;

namespace {

Matrix derivatives_of(const Vector& functions, const std::vector<Variable>& variables) {
  Matrix result(functions.size());
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (const Variable& variable : variables) result[i].push_back(ir::partial(functions[i], variable.symbol));
  }
  return result;
}

/// Columns first to last - 1.
Matrix columns(const Matrix& matrix, std::size_t first, std::size_t last) {
  Matrix result;
  for (const Vector& row : matrix)
    result.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(first),
                        row.begin() + static_cast<std::ptrdiff_t>(last));
  return result;
}

/// q̇ of quaternions by angular velocities, as half their product with (0, ω) is linear in these; coordinates by themselves.
Matrix turns_of(const Mechanics& mechanics) {
  const kinematics::Symbols& symbols = mechanics.symbols;
  const std::size_t plain = symbols.plain_count();
  Matrix result(symbols.configuration.size());
  for (const ConfigurationIndex i : symbols.configuration.indices()) {
    for (const FreeIndex a : symbols.speeds.indices()) {
      const bool is_turn = i.value >= plain && a.value >= plain;
      result[i.value].push_back(is_turn
                                    ? ir::partial(mechanics.kinematics.configuration_rates[i], symbols.speeds[a].symbol)
                                    : mechanics.expressions.number(i.value == a.value ? 1 : 0));
    }
  }
  return result;
}

Matrix rates_along_motion(const Mechanics& mechanics, const Matrix& turns) {
  ir::Directional along(turns[0][0].graph());
  for (const ConfigurationIndex i : mechanics.symbols.configuration.indices())
    along.seed(mechanics.symbols.configuration[i].symbol, mechanics.kinematics.configuration_rates[i]);
  Matrix result;
  for (const Vector& row : turns) {
    result.emplace_back();
    for (const Expr entry : row) result.back().push_back(along(entry));
  }
  return result;
}

double plain_number(const Arithmetic<double>&, Real value) { return static_cast<double>(value); }
cl_F plain_number(const Arithmetic<cl_F>& arithmetic, Real value) { return arithmetic.number(evaluate::exact(value)); }

double root(double value) { return std::sqrt(value); }
cl_F root(const cl_F& value) { return cln::sqrt(value); }

}  // namespace

Real to_real(double value) { return value; }

Real to_real(const cl_F& value) {
  const double head = evaluate::to_double(value);
  if (!std::isfinite(head)) return head;
  return static_cast<Real>(head) + static_cast<Real>(evaluate::to_double(value - cln::cl_float(head, value)));
}

LinearEquations::LinearEquations(Mechanics& mechanics) : rates(state_rates(mechanics)) {
  std::vector<Variable> variables = state_variables(mechanics);
  const std::size_t n_state = variables.size(), n_q = mechanics.symbols.configuration.size();
  for (const Variable& input : input_variables(mechanics)) variables.push_back(input);
  variables.push_back(time_variable(mechanics));
  strategy::Steps steps;
  const Matrix all = jacobian(mechanics, variables, DerivativeMethod::implicit, steps);
  by_state = columns(all, 0, n_state);
  by_inputs = columns(all, n_state, variables.size() - 1);
  by_time = columns(all, variables.size() - 1, variables.size());
  turns = turns_of(mechanics);
  turn_rates = rates_along_motion(mechanics, turns);
  variables.resize(n_state);
  for (const auto& row : mechanics.kinematics.constraints) {
    if (row.f) positions.push_back(*row.f);
    velocities.push_back(row.phi);
  }
  velocities_by_state = derivatives_of(velocities, variables);
  variables.resize(n_q);
  positions_by_configuration = derivatives_of(positions, variables);
}

template <class T>
StatePoint<T>::StatePoint(Mechanics& mechanics, const LinearEquations& equations, const support::Rational& time,
                          Arithmetic<T> arithmetic)
    : mechanics_(mechanics), equations_(equations), values_(mechanics.graph, std::move(arithmetic)) {
  bind_parameters(mechanics_, values_);
  set_time(time);
}

template <class T>
bool StatePoint<T>::start() {
  Vector nodes;
  for (const InitialValue& value : initial_values(mechanics_, values_))
    nodes.emplace_back(mechanics_.graph, value.node);
  auto state = values(nodes);
  if (!state) return false;
  set(*std::move(state));
  return true;
}

template <class T>
void StatePoint<T>::set(State state) {
  const kinematics::Symbols& symbols = mechanics_.symbols;
  for (const auto first : symbols.first_quaternion_component) {
    T* const e = &state[first.value];
    const T norm = root(T(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]));
    for (int i = 0; i < 4; ++i) e[i] = e[i] / norm;
  }
  std::size_t next = 0;
  for (const auto& q : symbols.configuration) values_.bind(q.symbol, state[next++]);
  for (const auto& u : symbols.speeds) values_.bind(u.symbol, state[next++]);
  state_ = std::move(state);
}

template <class T>
void StatePoint<T>::set_time(const support::Rational& time) {
  values_.bind(mechanics_.symbols.time, number(time));
}

template <class T>
T StatePoint<T>::number(const support::Rational& value) const {
  return values_.arithmetic().number(value);
}

template <class T>
T StatePoint<T>::number(Real value) const {
  return plain_number(values_.arithmetic(), value);
}

// A turn by more than a little goes along the great circle that it begins, as a steady one does.
template <class T>
void StatePoint<T>::move(const analysis::Vector& change, const T& unit) {
  const analysis::Matrix turns = matrix(equations_.turns);
  const auto n_q = turns.rows(), n = turns.cols();
  const auto plain = static_cast<Eigen::Index>(mechanics_.symbols.plain_count());
  State state = state_;
  const auto add = [&](Eigen::Index i, Real by) {
    T& value = state[static_cast<std::size_t>(i)];
    value = value + unit * number(by);
  };
  for (Eigen::Index i = 0; i < plain; ++i) add(i, change[i]);
  const Real size = to_real(unit);
  for (Eigen::Index first = plain; first < n_q; first += 4) {
    const analysis::Vector way = turns.middleRows(first, 4) * change.head(n);
    const Real angle = way.norm() * size;
    const bool is_small = std::abs(angle) < 1e-3L;
    for (Eigen::Index i = first; i < first + 4; ++i) {
      T& value = state[static_cast<std::size_t>(i)];
      if (!is_small) value = value * number(std::cos(angle));
      value = value + unit * number(is_small ? way[i - first] : way[i - first] * std::sin(angle) / angle);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) add(n_q + i, change[n + i]);
  set(std::move(state));
}

template <class T>
std::optional<std::vector<T>> StatePoint<T>::values(const Vector& nodes) {
  std::vector<T> result;
  for (const Expr node : nodes) {
    const auto value = values_(node.id());
    if (!value) {
      note({node});
      return std::nullopt;
    }
    result.push_back(*value);
  }
  return result;
}

template <class T>
void StatePoint<T>::note(const Vector& nodes) {
  for (const Expr node : nodes) {
    const auto trouble = values_.trouble(node.id());
    if (trouble) trouble_ = trouble->reason + " in " + trouble->name;
  }
}

template <class T>
std::string StatePoint<T>::trouble() {
  return trouble_;
}

/// NaN where it has no value.
template <class T>
analysis::Matrix StatePoint<T>::matrix(const Matrix& nodes) {
  const auto rows = static_cast<Eigen::Index>(nodes.size());
  const auto count = static_cast<Eigen::Index>(nodes.empty() ? 0 : nodes[0].size());
  analysis::Matrix result(rows, count);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const Expr node = nodes[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      const auto value = values_(node.id());
      result(i, j) = value ? to_real(*value) : std::numeric_limits<Real>::quiet_NaN();
      if (!value) note({node});
    }
  }
  return result;
}

template <class T>
std::optional<LinearNumbers> StatePoint<T>::numbers() {
  const auto column = [this](const Vector& nodes) {
    Matrix one;
    for (const Expr node : nodes) one.push_back({node});
    return nodes.empty() ? analysis::Vector(0) : analysis::Vector(matrix(one).col(0));
  };
  const analysis::Matrix turns = matrix(equations_.turns), by_state = matrix(equations_.by_state);
  const auto n_q = turns.rows(), n = turns.cols();
  // From rates of the configuration to displacements: turns has full rank, and of quaternions columns of length 1/2.
  analysis::Matrix back = turns.transpose();
  for (Eigen::Index a = 0; a < n; ++a) back.row(a) /= turns.col(a).squaredNorm();
  const auto in_displacements = [&](const analysis::Matrix& rows) {
    analysis::Matrix result(2 * n, rows.cols());
    result.topRows(n) = analysis::product(back, rows.topRows(n_q));
    result.bottomRows(n) = rows.bottomRows(n);
    return result;
  };
  // δπ' of δq' = T δπ' + T' δπ.
  const auto by_displacements = [&](bool of_sizes) {
    const auto sized = [&](const analysis::Matrix& m) { return of_sizes ? analysis::Matrix(m.cwiseAbs()) : m; };
    const analysis::Matrix moving = sized(matrix(equations_.turn_rates));
    analysis::Matrix columns(n_q + n, 2 * n), result(2 * n, 2 * n);
    columns.leftCols(n) = sized(by_state.leftCols(n_q)) * sized(turns);
    columns.rightCols(n) = sized(by_state.rightCols(n));
    columns.topRows(n_q).leftCols(n) += of_sizes ? moving : analysis::Matrix(-moving);
    result.topRows(n) = sized(back) * columns.topRows(n_q);
    result.bottomRows(n) = columns.bottomRows(n);
    return result;
  };
  LinearNumbers result;
  result.rates = in_displacements(column(equations_.rates)).col(0);
  result.by_state = analysis::without_rounding(by_displacements(false), by_displacements(true));
  result.by_inputs = in_displacements(matrix(equations_.by_inputs));
  result.by_time = in_displacements(matrix(equations_.by_time)).col(0);
  result.positions = column(equations_.positions);
  result.velocities = column(equations_.velocities);
  if (!equations_.positions.empty()) {
    result.positions_by_state = matrix(equations_.positions_by_configuration) * turns;
  } else {
    result.positions_by_state = analysis::Matrix(0, n);
  }
  const auto l = static_cast<Eigen::Index>(equations_.velocities.size());
  result.velocities_by_state = analysis::Matrix(l, 2 * n);
  if (l > 0) {
    const analysis::Matrix by = matrix(equations_.velocities_by_state);
    result.velocities_by_state.leftCols(n) = by.leftCols(n_q) * turns;
    result.velocities_by_state.rightCols(n) = by.rightCols(n);
  }
  const bool is_defined = result.rates.allFinite() && result.by_state.allFinite() && result.by_inputs.allFinite() &&
                          result.by_time.allFinite() && result.positions.allFinite() && result.velocities.allFinite() &&
                          result.positions_by_state.allFinite() && result.velocities_by_state.allFinite();
  return is_defined ? std::optional(std::move(result)) : std::nullopt;
}

template class StatePoint<double>;
template class StatePoint<cl_F>;

}  // namespace gaussgen
