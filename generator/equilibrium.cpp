#include "equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "evaluation.hpp"
#include "ir/substitute.hpp"
#include "model_values.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

using cln::cl_F;
using evaluate::Paired;
using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::FreeIndex;

namespace {

constexpr int k_most_steps = 200;
constexpr int k_more_digits = 15;
constexpr int k_most_descents = 4;
constexpr int k_steps_of_descent = 300;
constexpr double k_shortest_descent = 1e-4;
constexpr double k_solved = 1e-12;        ///< of the largest term, in double
constexpr double k_balanced = 1e-6;       ///< after the last digits, of the largest term at the start
constexpr double k_rank = 1e-10;          ///< of the largest singular value
constexpr double k_largest_step = 0.5;    ///< of angles, and of lengths in units of themselves
constexpr double k_shortest_step = 1e-6;  ///< of a full step
constexpr int k_later = 731;              ///< ms: no part of anybody's period

double to_double(const cl_F& value) { return cln::double_approx(value); }

class Search {
 public:
  Search(const model::Model& model, const support::Rational& time, int digits)
      : mechanics_(model, {}),
        digits_(digits),
        values_(mechanics_.graph, evaluate::Arithmetic<Paired>(digits + k_more_digits, k_more_digits)) {
    bind_parameters(mechanics_, values_);
    set_time(time);
    pose();
  }

  struct Rest {
    std::vector<support::Rational> position, speeds;
    bool lasts = true;
  };

  /// Nothing, with the reason in `why`.
  std::optional<Rest> run(std::string& why) {
    if (!start()) {
      why = "the initial position has no value";
      return std::nullopt;
    }
    const Linearised at_start = linearised();
    if (!at_start.is_defined) {
      why = "at rest at the initial position there is no force: " + undefined_part();
      return std::nullopt;
    }
    double left = approach();
    // From far away: let it sink, and try again.
    for (int i = 0; i < k_most_descents && !(left <= k_solved); ++i) {
      if (i == 0) start();
      sink();
      left = approach();
    }
    if (!(left <= k_solved)) {
      why = why_not(left);
      return std::nullopt;
    }
    polish();
    if (!is_balanced(at_start)) {
      why = "no equilibrium was found near the initial position: towards the nearest one forces grow without bound";
      return std::nullopt;
    }
    Rest rest;
    for (const cl_F& q : position_) rest.position.push_back(rounded(q));
    for (const Expr speed : mechanics_.kinematics.speeds_at_rest)
      rest.speeds.push_back(rounded(value_of(speed.id()).value_or(number(support::Rational(0)))));
    rest.lasts = is_at_rest_at(time_ + support::Rational(k_later) / 1000);
    return rest;
  }

 private:
  struct Linearised {
    Eigen::MatrixXd matrix;
    std::vector<cl_F> residual;
    Eigen::VectorXd scale;  ///< of each row
    bool is_defined = true;

    double norm() const {
      double largest = 0;
      for (std::size_t i = 0; i < residual.size(); ++i)
        largest = std::max(largest, std::abs(to_double(residual[i])) / scale[static_cast<Eigen::Index>(i)]);
      return largest;
    }
  };

  // What is left of Newton's method beyond the digits that are asked for is no part of the answer.
  support::Rational rounded(const cl_F& value) const {
    const support::Rational grid = cln::expt(support::Rational(10), digits_ + k_more_digits / 2);
    return cln::round1(cln::rational(value) * grid) / grid;
  }

  /// f - g u̇ + bᵀ λ at rest, then the equations of positions, then φ and b u̇ + its drift at rest, which are zero in every position
  /// unless a constraint drives the model. u̇ is how speeds at rest change with time: those against what moves.
  void pose() {
    const strategy::Dynamics& dynamics = mechanics_.dynamics;
    ir::Graph& graph = mechanics_.graph;
    ir::Substitution at_rest(graph);
    strategy::Vector changes;
    for (const FreeIndex a : mechanics_.symbols.speeds.indices()) {
      at_rest.replace(mechanics_.symbols.speeds[a].symbol, mechanics_.kinematics.speeds_at_rest[a]);
      changes.push_back(ir::partial(mechanics_.kinematics.speeds_at_rest[a], mechanics_.symbols.time));
    }
    for (const Expr acceleration : mechanics_.solution.accelerations) accelerations_.push_back(at_rest(acceleration));
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu)
      lambda_.push_back(graph.declare(ir::SymbolClass::input, "multiplier_" + std::to_string(mu + 1)));
    for (std::size_t a = 0; a < dynamics.n(); ++a) {
      terms_.push_back({at_rest(dynamics.f[a])});
      for (std::size_t mu = 0; mu < dynamics.l(); ++mu)
        terms_.back().push_back(at_rest(dynamics.b[mu][a]) * mechanics_.expressions.symbol(lambda_[mu]));
      for (std::size_t b = 0; b < dynamics.n(); ++b) terms_.back().push_back(-at_rest(dynamics.g[a][b]) * changes[b]);
    }
    for (const auto& row : mechanics_.kinematics.constraints) {
      if (row.f) terms_.push_back({*row.f});
    }
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
      add_drive(mu, {at_rest(mechanics_.kinematics.constraints[kinematics::ConstraintIndex{mu}].phi)});
      std::vector<Expr> drift{at_rest(dynamics.b_drift[mu])};
      for (std::size_t b = 0; b < dynamics.n(); ++b) drift.push_back(at_rest(dynamics.b[mu][b]) * changes[b]);
      add_drive(mu, std::move(drift));
    }
    for (const std::vector<Expr>& terms : terms_) {
      Expr sum = terms.front();
      for (std::size_t i = 1; i < terms.size(); ++i) sum += terms[i];
      equations_.push_back(sum);
    }
    for (const FreeIndex a : mechanics_.symbols.speeds.indices()) derivatives_.push_back(along_speed(a));
    for (const ir::SymbolId multiplier : lambda_) {
      derivatives_.emplace_back();
      for (const Expr equation : equations_) derivatives_.back().push_back(ir::partial(equation, multiplier));
    }
  }

  void add_drive(std::size_t constraint, std::vector<Expr> terms) {
    if (std::all_of(terms.begin(), terms.end(), [](Expr term) { return term.is_zero(); })) return;
    drives_.emplace_back(terms_.size(), constraint);
    terms_.push_back(std::move(terms));
  }

  /// The constraint that asks for motion most; empty if none does.
  std::string what_moves_it() {
    const Linearised here = linearised();
    double largest = k_balanced;
    std::string name;
    for (const auto& [row, constraint] : drives_) {
      const double asked = std::abs(to_double(here.residual[row])) / here.scale[static_cast<Eigen::Index>(row)];
      if (!(asked > largest)) continue;
      largest = asked;
      name = mechanics_.dynamics.constraints[constraint];
    }
    return name;
  }

  std::vector<Expr> along_speed(FreeIndex a) {
    ir::Directional along(mechanics_.graph);
    rates_.emplace_back();
    for (const ConfigurationIndex i : mechanics_.symbols.configuration.indices()) {
      rates_.back().push_back(
          ir::partial(mechanics_.kinematics.configuration_rates[i], mechanics_.symbols.speeds[a].symbol));
      along.seed(mechanics_.symbols.configuration[i].symbol, rates_.back().back());
    }
    std::vector<Expr> column;
    for (const Expr equation : equations_) column.push_back(along(equation));
    return column;
  }

  template <class Number>
  cl_F number(const Number& value) const {
    return values_.arithmetic().fine().number(value);
  }

  void bind(ir::SymbolId symbol, const cl_F& value) { values_.bind(symbol, values_.arithmetic().number(value)); }

  std::optional<cl_F> value_of(ir::NodeId node) {
    const auto value = values_(node);
    return value ? std::optional<cl_F>(value->fine) : std::nullopt;
  }

  std::string undefined_part() {
    for (const Expr equation : equations_) {
      if (const auto trouble = values_.trouble(equation.id())) return trouble->reason + " in " + trouble->name;
    }
    return "a derivative has no value";
  }

  std::string why_not(double left) {
    const std::string none = "no equilibrium was found near the initial position: ";
    if (!std::isfinite(left)) return none + "the search ends where there is no force: " + undefined_part();
    const std::string mover = what_moves_it();
    if (mover.empty()) return none + fmt::format("forces of {:.1e} of the largest remain", left);
    return fmt::format("no position was found near the initial one at which constraint '{}' lets the model rest",
                       mover);
  }

  /// A pole looks like an equilibrium to whoever measures forces by how fast they change.
  bool is_balanced(const Linearised& at_start) {
    const Linearised here = linearised();
    for (std::size_t i = 0; i < here.residual.size(); ++i) {
      const double size = at_start.scale[static_cast<Eigen::Index>(i)];
      if (!(std::abs(to_double(here.residual[i])) <= k_balanced * size)) return false;
    }
    return here.is_defined;
  }

  /// Multipliers may be others then.
  bool is_at_rest_at(const support::Rational& time) {
    const std::vector<cl_F> before = position_;
    set_time(time);
    if (!(approach() <= k_solved)) return false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double moved = std::abs(to_double(position_[i] - before[i]));
      if (!(moved <= k_balanced * (1 + std::abs(to_double(before[i]))))) return false;
    }
    return true;
  }

  void set_time(const support::Rational& time) {
    time_ = time;
    bind(mechanics_.symbols.time, number(time));
  }

  /// Of a state.
  std::optional<std::vector<cl_F>> position_of(const std::vector<ir::NodeId>& state) {
    std::vector<cl_F> position;
    for (std::size_t i = 0; i < mechanics_.symbols.configuration.size(); ++i) {
      const auto value = value_of(state[i]);
      if (!value) return std::nullopt;
      position.push_back(*value);
    }
    return position;
  }

  /// Where the model starts, or at its guesses if these lead nowhere.
  bool start() {
    std::vector<ir::NodeId> initial, guess;
    for (const InitialValue& value : initial_values(mechanics_)) initial.push_back(value.node);
    for (const Expr value : strategy::guessed_state(mechanics_.model, mechanics_.expressions))
      guess.push_back(value.id());
    auto position = position_of(initial);
    if (!position) position = position_of(guess);
    if (!position) return false;
    set(*std::move(position), std::vector<cl_F>(lambda_.size(), number(support::Rational(0))));
    return true;
  }

  void set(std::vector<cl_F> position, std::vector<cl_F> multipliers) {
    for (const auto first : mechanics_.symbols.first_quaternion_component) normalise(&position[first.value]);
    for (const ConfigurationIndex i : mechanics_.symbols.configuration.indices())
      bind(mechanics_.symbols.configuration[i].symbol, position[i.value]);
    for (std::size_t mu = 0; mu < lambda_.size(); ++mu) bind(lambda_[mu], multipliers[mu]);
    position_ = std::move(position);
    multipliers_ = std::move(multipliers);
  }

  static void normalise(cl_F* e) {
    const cl_F norm = cln::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
    for (int i = 0; i < 4; ++i) e[i] = e[i] / norm;
  }

  Linearised linearised() {
    const auto rows = static_cast<Eigen::Index>(equations_.size());
    const auto columns = static_cast<Eigen::Index>(derivatives_.size());
    Linearised at{Eigen::MatrixXd::Zero(rows, columns), {}, Eigen::VectorXd::Zero(rows), true};
    for (Eigen::Index i = 0; i < rows; ++i) {
      const std::size_t row = static_cast<std::size_t>(i);
      const auto value = value_of(equations_[row].id());
      at.is_defined = at.is_defined && value.has_value();
      at.residual.push_back(value.value_or(number(support::Rational(0))));
      for (Eigen::Index j = 0; j < columns; ++j) {
        const auto entry = value_of(derivatives_[static_cast<std::size_t>(j)][row].id());
        at.is_defined = at.is_defined && entry.has_value();
        if (entry) at.matrix(i, j) = to_double(*entry);
      }
      // What the sum is made of, and what a displacement by 1 changes.
      at.scale[i] = at.matrix.row(i).lpNorm<Eigen::Infinity>();
      for (const Expr term : terms_[row]) {
        if (const auto size = value_of(term.id())) at.scale[i] = std::max(at.scale[i], std::abs(to_double(*size)));
      }
      if (at.scale[i] == 0) at.scale[i] = 1;
    }
    return at;
  }

  /// The least change in columns of one size with matrix * change = -residual, in units of `unit`.
  Eigen::VectorXd change(const Linearised& at, const cl_F& unit) const {
    Eigen::VectorXd right(at.matrix.rows());
    for (Eigen::Index i = 0; i < right.size(); ++i)
      right[i] = -to_double(at.residual[static_cast<std::size_t>(i)] / unit) / at.scale[i];
    Eigen::MatrixXd matrix = at.scale.cwiseInverse().asDiagonal() * at.matrix;
    Eigen::VectorXd sizes = matrix.colwise().norm();
    for (double& size : sizes) size = size > 0 ? 1 / size : 1;
    matrix = matrix * sizes.asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(k_rank);
    decomposition.compute(matrix);
    return sizes.asDiagonal() * decomposition.solve(right);
  }

  void move(const Eigen::VectorXd& change, const cl_F& unit) {
    std::vector<cl_F> position = position_;
    for (std::size_t a = 0; a < rates_.size(); ++a) {
      const cl_F along = unit * number(change[static_cast<Eigen::Index>(a)]);
      for (std::size_t i = 0; i < position.size(); ++i) {
        if (const auto rate = value_of(rates_[a][i].id())) position[i] = position[i] + *rate * along;
      }
    }
    std::vector<cl_F> multipliers = multipliers_;
    for (std::size_t mu = 0; mu < multipliers.size(); ++mu) {
      const double by = change[static_cast<Eigen::Index>(rates_.size() + mu)];
      multipliers[mu] = multipliers[mu] + unit * number(by);
    }
    set(std::move(position), std::move(multipliers));
  }

  /// A step of Newton's method may leave the neighbourhood in which it means anything.
  double allowed(const Eigen::VectorXd& change) const {
    double largest = 0;
    for (std::size_t a = 0; a < rates_.size(); ++a) {
      const bool is_length = mechanics_.symbols.speeds[FreeIndex{a}].is_of_length();
      const double size = is_length ? 1 + std::abs(to_double(position_[a])) : 1;
      largest = std::max(largest, std::abs(change[static_cast<Eigen::Index>(a)]) / size);
    }
    return largest > k_largest_step ? k_largest_step / largest : 1;
  }

  /// What remains, of the largest terms.
  double approach() {
    const cl_F one = number(support::Rational(1));
    Linearised here = linearised();
    for (int i = 0; i < k_most_steps && here.is_defined && here.norm() > k_solved; ++i) {
      const Eigen::VectorXd full = change(here, one);
      const auto from = std::pair(position_, multipliers_);
      double part = allowed(full);
      Linearised there = here;
      for (bool is_better = false; !is_better && part > k_shortest_step; part /= 2) {
        set(from.first, from.second);
        move(part * full, one);
        there = linearised();
        is_better = there.is_defined && there.norm() < here.norm() * (1 - part / 10);
      }
      // Where no shorter step helps, the last one leads out of a valley.
      here = std::move(there);
    }
    return here.is_defined ? here.norm() : HUGE_VAL;
  }

  /// Along the accelerations that the model has at rest, as through syrup: forces of springs and weights do work there until they
  /// are in balance. Steps are short, and shorter where the way turns back.
  void sink() {
    const cl_F one = number(support::Rational(1));
    double limit = k_largest_step / 4;
    Eigen::VectorXd before = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rates_.size() + lambda_.size()));
    for (int i = 0; i < k_steps_of_descent && limit > k_shortest_descent; ++i) {
      Eigen::VectorXd way = Eigen::VectorXd::Zero(before.size());
      for (std::size_t a = 0; a < rates_.size(); ++a) {
        const auto acceleration = value_of(accelerations_[a].id());
        if (acceleration) way[static_cast<Eigen::Index>(a)] = to_double(*acceleration);
      }
      const double largest = way.lpNorm<Eigen::Infinity>();
      if (!(largest > 0)) return;
      way *= limit / largest;
      if (way.dot(before) < 0) limit /= 2;
      move(way, one);
      before = way;
    }
  }

  /// With the matrix in double, each step is good for some ten digits.
  void polish() {
    for (int done = 0; done < digits_ + k_more_digits; done += 8) {
      const Linearised here = linearised();
      cl_F unit = number(support::Rational(0));
      for (const cl_F& value : here.residual) unit = cln::max(unit, cln::abs(value));
      if (cln::zerop(unit)) return;
      move(change(here, unit), unit);
    }
  }

  Mechanics mechanics_;
  support::Rational time_;
  int digits_;
  evaluate::Evaluator<Paired> values_;
  std::vector<Expr> accelerations_;  ///< at rest
  std::vector<ir::SymbolId> lambda_;
  std::vector<std::vector<Expr>> terms_;  ///< of each equation
  std::vector<std::pair<std::size_t, std::size_t>>
      drives_;  ///< rows of these that a constraint may drive, and its index
  std::vector<Expr> equations_;
  std::vector<std::vector<Expr>> derivatives_;  ///< by speeds, then multipliers, of each equation
  std::vector<std::vector<Expr>> rates_;        ///< ∂q̇/∂u by speeds, of each q
  std::vector<cl_F> position_;
  std::vector<cl_F> multipliers_;
};

void set_start(model::Model& model, const Search::Rest& rest) {
  const std::vector<support::Rational>& position = rest.position;
  std::size_t next = 0;
  for (model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    coordinate.initial_rate = model::number(rest.speeds[next], coordinate.name.span);
    coordinate.initial = model::number(position[next++], coordinate.name.span);
    coordinate.guess.reset();
    coordinate.rate_guess.reset();
  }
  for (model::Orientation& orientation : model.orientations) {
    for (model::Ast& component : orientation.initial)
      component = model::number(position[next++], orientation.name.span);
    orientation.is_open = false;
    for (auto& component : orientation.initial_angular_velocity) component = model::number(0, orientation.name.span);
  }
}

}  // namespace

Equilibrium go_to_equilibrium(model::Model& model, const support::Rational& time, int digits) {
  Equilibrium result;
  const auto rest = Search(model, time, digits).run(result.failure);
  if (!rest) return result;
  set_start(model, *rest);
  result.lasts = rest->lasts;
  return result;
}

}  // namespace gaussgen
