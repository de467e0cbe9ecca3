#include "rest_place.hpp"

#include <algorithm>
#include <cmath>

#include "evaluation.hpp"
#include "model_values.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

using cln::cl_F;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using evaluate::Arithmetic;
using evaluate::Paired;
using evaluate::Scaled;
using ir::Expr;
using kinematics::ConfigurationIndex;

namespace {

constexpr double k_short = 0.01;       ///< of steps along constraints, of angles and lengths
constexpr double k_most_short = 1000;  ///< of these in one step of the search

double plain_value(double value) { return value; }
const cl_F& plain_value(const Paired& value) { return value.fine; }

double wrapped(const Arithmetic<double>&, double value) { return value; }
Paired wrapped(const Arithmetic<Paired>& arithmetic, const cl_F& value) { return arithmetic.number(value); }

double number_of(const Arithmetic<double>& arithmetic, const support::Rational& value) {
  return arithmetic.number(value);
}
double number_of(const Arithmetic<double>&, double value) { return value; }
template <class Number>
cl_F number_of(const Arithmetic<Paired>& arithmetic, const Number& value) {
  return arithmetic.fine().number(value);
}

template <class Real>
void normalise(Real* e) {
  using std::sqrt;
  const Real norm = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
  for (int i = 0; i < 4; ++i) e[i] = e[i] / norm;
}

template <class Real>
std::vector<Real> sum(std::vector<Real> a, const std::vector<Real>& b, const Real& times) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + times * b[i];
  return a;
}

}  // namespace

template <class T>
RestPlace<T>::RestPlace(Mechanics& mechanics, const RestEquations& rest, const support::Rational& time,
                        Arithmetic<T> arithmetic)
    : mechanics_(mechanics),
      rest_(rest),
      values_(mechanics.graph, std::move(arithmetic)),
      sizes_(mechanics.graph, Arithmetic<Scaled<double>>(Arithmetic<double>())) {
  bind_parameters(mechanics_, values_);
  bind_parameters(mechanics_, sizes_);
  set_time(time);
}

template <class T>
bool RestPlace<T>::start() {
  std::vector<ir::NodeId> initial, guess;
  for (const InitialValue& value : initial_values(mechanics_, values_)) initial.push_back(value.node);
  for (const Expr value : strategy::guessed_state(mechanics_.model, mechanics_.expressions))
    guess.push_back(value.id());
  auto position = position_of(initial);
  if (!position) position = position_of(guess);
  if (!position) return false;
  set(*std::move(position), Vector(rest_.multipliers.size(), number(0.0)));
  return true;
}

template <class T>
void RestPlace<T>::set(Vector position, Vector multipliers) {
  for (const auto first : mechanics_.symbols.first_quaternion_component) normalise(&position[first.value]);
  bind_position(position);
  for (std::size_t mu = 0; mu < multipliers.size(); ++mu) bind(rest_.multipliers[mu], multipliers[mu]);
  position_ = std::move(position);
  multipliers_ = std::move(multipliers);
}

template <class T>
void RestPlace<T>::set_time(const support::Rational& time) {
  bind(mechanics_.symbols.time, number(time));
}

template <class T>
void RestPlace<T>::move(const VectorXd& change, const Real& unit, bool is_held) {
  const auto n = static_cast<Eigen::Index>(mechanics_.dynamics.n());
  const VectorXd speeds = change.head(n);
  Vector position = is_held ? along_path(speeds, unit) : sum(position_, rates(speeds), unit);
  Vector multipliers = multipliers_;
  for (std::size_t mu = 0; mu < multipliers.size(); ++mu)
    multipliers[mu] = multipliers[mu] + unit * number(change[n + static_cast<Eigen::Index>(mu)]);
  set(std::move(position), std::move(multipliers));
}

template <class T>
typename RestPlace<T>::Real RestPlace<T>::number(const support::Rational& value) const {
  return number_of(values_.arithmetic(), value);
}

template <class T>
typename RestPlace<T>::Real RestPlace<T>::number(double value) const {
  return number_of(values_.arithmetic(), value);
}

template <class T>
std::optional<typename RestPlace<T>::Real> RestPlace<T>::value_of(ir::NodeId node) {
  const auto value = values_(node);
  return value ? std::optional<Real>(plain_value(*value)) : std::nullopt;
}

template <class T>
double RestPlace<T>::plain(Expr expression) {
  const auto value = value_of(expression.id());
  return value ? to_double(*value) : 0;
}

template <class T>
double RestPlace<T>::size_of(Expr expression) {
  const auto size = sizes_(expression.id());
  return size ? size->scale : 0;
}

template <class T>
MatrixXd RestPlace<T>::rows_of(const std::vector<std::vector<Expr>>& entries) {
  MatrixXd rows(static_cast<Eigen::Index>(entries.size()), static_cast<Eigen::Index>(mechanics_.dynamics.n()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index a = 0; a < rows.cols(); ++a)
      rows(i, a) = plain(entries[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)]);
  }
  return rows;
}

template <class T>
std::optional<std::string> RestPlace<T>::trouble(Expr expression) {
  const auto trouble = values_.trouble(expression.id());
  return trouble ? std::optional(trouble->reason + " in " + trouble->name) : std::nullopt;
}

template <class T>
void RestPlace<T>::bind(ir::SymbolId symbol, const Real& value) {
  values_.bind(symbol, wrapped(values_.arithmetic(), value));
  const double rounded = to_double(value);
  sizes_.bind(symbol, {rounded, std::abs(rounded)});
}

template <class T>
void RestPlace<T>::bind_position(const Vector& position) {
  for (const ConfigurationIndex i : mechanics_.symbols.configuration.indices())
    bind(mechanics_.symbols.configuration[i].symbol, position[i.value]);
}

template <class T>
std::optional<typename RestPlace<T>::Vector> RestPlace<T>::position_of(const std::vector<ir::NodeId>& state) {
  Vector position;
  for (std::size_t i = 0; i < mechanics_.symbols.configuration.size(); ++i) {
    const auto value = value_of(state[i]);
    if (!value) return std::nullopt;
    position.push_back(*value);
  }
  return position;
}

/// What rolls is where it rolls to: at each place as far as constraints on velocities allow the change there, while what equations of
/// positions leave changes evenly; by the classical method of Runge and Kutta in short steps.
template <class T>
typename RestPlace<T>::Vector RestPlace<T>::along_path(const VectorXd& speeds, const Real& unit) {
  const double length = speeds.size() == 0 ? 0 : speeds.lpNorm<Eigen::Infinity>() * std::abs(to_double(unit));
  const int count = static_cast<int>(std::min(std::ceil(length / k_short), k_most_short));
  const VectorXd closing = rows_of(rest_.closing) * speeds;
  short_steps_ += count;
  Vector position = position_;
  for (int i = 0; i < count; ++i) {
    const Real part = unit / number(static_cast<double>(count));
    const Real half = part / number(2.0), sixth = part / number(6.0);
    const Vector k1 = rates_at(position, speeds, closing);
    const Vector k2 = rates_at(sum(position, k1, half), speeds, closing);
    const Vector k3 = rates_at(sum(position, k2, half), speeds, closing);
    const Vector k4 = rates_at(sum(position, k3, part), speeds, closing);
    for (std::size_t q = 0; q < position.size(); ++q)
      position[q] = position[q] + sixth * (k1[q] + k4[q] + number(2.0) * (k2[q] + k3[q]));
  }
  return position;
}

/// q̇ of these speeds as far as constraints on velocities allow them at a place, and such that equations of positions change so fast; the
/// least change, as masses measure it, makes them fit.
template <class T>
typename RestPlace<T>::Vector RestPlace<T>::rates_at(const Vector& position, const VectorXd& speeds,
                                                     const VectorXd& closing) {
  bind_position(position);
  VectorXd roots(speeds.size());
  for (Eigen::Index a = 0; a < roots.size(); ++a) {
    const double mass = plain(rest_.metric[static_cast<std::size_t>(a)][static_cast<std::size_t>(a)]);
    roots[a] = mass > 0 ? std::sqrt(mass) : 1;
  }
  const MatrixXd held = rows_of(rest_.held), closed = rows_of(rest_.closing);
  MatrixXd b(held.rows() + closed.rows(), held.cols());
  b << held, closed;
  VectorXd missing(b.rows());
  missing << held * speeds, closed * speeds - closing;
  const MatrixXd weighted = b * roots.cwiseInverse().asDiagonal();
  return rates(speeds - weighted.completeOrthogonalDecomposition().solve(missing).cwiseQuotient(roots));
}

/// q̇ of speeds, at the place that is bound.
template <class T>
typename RestPlace<T>::Vector RestPlace<T>::rates(const VectorXd& speeds) {
  Vector result(position_.size(), number(0.0));
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t a = 0; a < rest_.rates[i].size(); ++a) {
      if (const auto rate = value_of(rest_.rates[i][a].id()))
        result[i] = result[i] + *rate * number(speeds[static_cast<Eigen::Index>(a)]);
    }
  }
  return result;
}

template class RestPlace<double>;
template class RestPlace<Paired>;

}  // namespace gaussgen
