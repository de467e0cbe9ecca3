#include "position_equations.hpp"

#include <algorithm>
#include <cmath>

#include "evaluation.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

namespace {

constexpr double k_first_step = 1e-3;
constexpr double k_rounding = 1e-14;  ///< of what a derivative is made of
constexpr double k_gone = 1e-10;      ///< of what an equation is made of, over a span: less is what a place is off by
constexpr double k_turn = 6.283185307179586;

}  // namespace

double Linearised::square() const {
  double sum = 0;
  for (const double value : f) sum += value * value;
  return sum;
}

double Linearised::left() const {
  double largest = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f[i] != 0) largest = std::max(largest, std::abs(f[i]) / size[i]);
  }
  return largest;
}

double Linearised::amplification(const Vector& spans) const {
  double largest = 1;
  for (std::size_t i = 0; i < f.size(); ++i) {
    double squares = 0;
    for (std::size_t k = 0; k < spans.size(); ++k) squares += std::pow(j[i][k] * spans[k], 2);
    if (squares > std::pow(k_gone * size[i], 2)) largest = std::max(largest, size[i] / std::sqrt(squares));
  }
  return largest;
}

void Linearised::measure_by(const Vector& spans) {
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t k = 0; k < spans.size(); ++k) size[i] += std::abs(j[i][k]) * spans[k];
  }
}

bool Linearised::is_solved(double part) const {
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (std::abs(f[i]) > part * size[i]) return false;
  }
  return true;
}

PositionEquations::PositionEquations(Mechanics& mechanics, std::vector<bool> movable, double time)
    : mechanics_(mechanics),
      movable_(std::move(movable)),
      time_(time),
      values_(mechanics.graph, evaluate::Arithmetic<Number>(evaluate::Arithmetic<double>())) {
  for (const auto mu : mechanics.kinematics.constraints.indices()) {
    if (mechanics.kinematics.constraints[mu].f) rows_.push_back(mu);
  }
  weights_.assign(rows_.size(), 1);
}

bool PositionEquations::start() {
  bind_parameters(mechanics_, values_);
  bind(mechanics_.symbols.time, time_);
  Vector q;
  const strategy::Vector all = strategy::guessed_state(mechanics_.model, mechanics_.expressions);
  for (std::size_t i = 0; i < mechanics_.symbols.configuration.size(); ++i) {
    const auto value = values_(all[i].id());
    if (!value) return false;
    q.push_back(value->value);
  }
  set(std::move(q));
  guess_ = q_;
  return true;
}

void PositionEquations::bind(ir::SymbolId symbol, double value) { values_.bind(symbol, {value, std::abs(value)}); }

void PositionEquations::set(Vector q) {
  for (const auto first : mechanics_.symbols.first_quaternion_component) {
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) square += q[first.value + i] * q[first.value + i];
    for (std::size_t i = 0; i < 4; ++i) q[first.value + i] /= std::sqrt(square);
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    bind(mechanics_.symbols.configuration[kinematics::ConfigurationIndex{i}].symbol, q[i]);
  }
  q_ = std::move(q);
}

void PositionEquations::set(Vector q, std::vector<bool> movable) {
  movable_ = std::move(movable);
  weights_.assign(rows_.size(), 1);
  set(std::move(q));
}

void PositionEquations::move(const Vector& along_speeds) {
  for (const auto i : mechanics_.symbols.speeds.indices()) {
    const auto at_rest = values_(mechanics_.kinematics.speeds_at_rest[i].id());
    bind(mechanics_.symbols.speeds[i].symbol, (at_rest ? at_rest->value : 0) + along_speeds[i.value]);
  }
  Vector q = q_;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto rate = values_(mechanics_.kinematics.configuration_rates[kinematics::ConfigurationIndex{i}].id());
    if (rate) q[i] += rate->value;
  }
  set(std::move(q));
}

void PositionEquations::leave_symmetry(const Vector& spans) {
  Vector displacement;
  for (std::size_t i = 0; i < spans.size(); ++i)
    displacement.push_back(movable_[i] ? k_first_step * spans[i] * (1 + 0.37 * static_cast<double>(i)) : 0);
  move(displacement);
}

void PositionEquations::weigh() {
  const auto here = linearised();
  for (std::size_t i = 0; here && i < rows_.size(); ++i) {
    double largest = 0;
    for (const double entry : here->j[i]) largest = std::max(largest, std::abs(entry));
    if (largest > 0) weights_[i] /= largest;
  }
}

bool PositionEquations::may_be_angle(std::size_t variable) const {
  const std::string& unit = mechanics_.symbols.configuration[kinematics::ConfigurationIndex{variable}].unit;
  return unit == "rad" || unit.empty();
}

bool PositionEquations::unwind(std::size_t variable) {
  const double off = q_[variable] - guess_[variable], least = std::remainder(off, k_turn);
  if (!may_be_angle(variable) || std::abs(off - least) < 1) return false;
  Vector q = q_;
  q[variable] = guess_[variable] + least;
  set(std::move(q));
  return true;
}

bool PositionEquations::add(ir::Expr f, const kinematics::ConstraintRow& row, const std::vector<bool>& moves,
                            double weight, Linearised& result) {
  const auto value = values_(f.id());
  if (!value || !std::isfinite(value->value)) return false;
  result.f.push_back(weight * value->value);
  result.size.push_back(weight * value->scale);
  result.j.emplace_back();
  for (const auto alpha : mechanics_.symbols.speeds.indices()) {
    const auto entry = values_(row.beta[mechanics_.symbols.full(alpha)].id());
    if (!entry || !std::isfinite(entry->value)) return false;
    const bool is_rounding = std::abs(entry->value) <= k_rounding * entry->scale;
    result.j.back().push_back(moves[alpha.value] && !is_rounding ? weight * entry->value : 0);
  }
  return true;
}

std::optional<Linearised> PositionEquations::linearised() {
  Linearised result;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const kinematics::ConstraintRow& row = mechanics_.kinematics.constraints[rows_[i]];
    if (!add(*row.f, row, movable_, weights_[i], result)) return std::nullopt;
  }
  return result;
}

std::optional<Linearised> PositionEquations::of_speeds(const Vector& u, const std::vector<bool>& open) {
  for (const auto i : mechanics_.symbols.speeds.indices()) bind(mechanics_.symbols.speeds[i].symbol, u[i.value]);
  Linearised result;
  for (const kinematics::ConstraintRow& row : mechanics_.kinematics.constraints) {
    if (!add(row.phi, row, open, 1, result)) return std::nullopt;
  }
  return result;
}

PositionEquations::Vector PositionEquations::speeds() {
  const strategy::Vector all = strategy::guessed_state(mechanics_.model, mechanics_.expressions);
  Vector u;
  for (std::size_t i = mechanics_.symbols.configuration.size(); i < all.size(); ++i) {
    const auto value = values_(all[i].id());
    u.push_back(value ? value->value : 0);
  }
  return u;
}

PositionEquations::Vector PositionEquations::inertias() {
  Vector result;
  for (const ir::Expr inertia : strategy::inertias(mechanics_.dynamics)) {
    const auto value = values_(inertia.id());
    result.push_back(value ? value->value : 0);
  }
  return result;
}

std::vector<PositionEquations::Vector> PositionEquations::metric() {
  const std::size_t n = movable_.size();
  std::vector<Vector> result(n, Vector(n, 0));
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (!movable_[a] || !movable_[b]) continue;
      if (const auto entry = values_(mechanics_.dynamics.g[a][b].id())) result[a][b] = entry->value;
    }
  }
  return result;
}

}  // namespace gaussgen
