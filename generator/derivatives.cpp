#include "derivatives.hpp"

#include <algorithm>
#include <functional>

#include "ir/cost.hpp"
#include "ir/reverse.hpp"

namespace gaussgen {

using ir::Expr;
using ir::SymbolId;
using strategy::Matrix;
using strategy::Vector;

namespace {

std::vector<SymbolId> symbols_of(const std::vector<Variable>& variables) {
  std::vector<SymbolId> symbols;
  for (const Variable& variable : variables) symbols.push_back(variable.symbol);
  return symbols;
}

bool is_parameter(const Mechanics& mechanics, SymbolId symbol) {
  return mechanics.graph.symbol(symbol).symbol_class == ir::SymbolClass::parameter;
}

}  // namespace

std::vector<Variable> state_variables(const Mechanics& mechanics) {
  std::vector<Variable> variables;
  for (const auto& q : mechanics.symbols.configuration) variables.push_back({q.symbol, q.name});
  for (const auto& u : mechanics.symbols.speeds) variables.push_back({u.symbol, u.name});
  return variables;
}

std::vector<Variable> input_variables(const Mechanics& mechanics) {
  std::vector<Variable> variables;
  for (const SymbolId input : mechanics.symbols.inputs)
    variables.push_back({input, mechanics.graph.symbol(input).name});
  return variables;
}

std::vector<DerivativeMethod> derivative_methods(const Mechanics& mechanics) {
  std::vector<DerivativeMethod> methods{DerivativeMethod::forward};
  if (strategy::has_tree_tangent(mechanics.dynamics, mechanics.solution)) methods.push_back(DerivativeMethod::links);
  const bool has_quaternions = !mechanics.symbols.first_quaternion_component.empty();
  if (has_quaternions && !mechanics.solution.is_of_metric) return methods;
  methods.push_back(DerivativeMethod::implicit);
  methods.push_back(DerivativeMethod::reverse);
  return methods;
}

Variable time_variable(const Mechanics& mechanics) { return {mechanics.symbols.time, "t"}; }

Derivatives::Derivatives(Mechanics& mechanics, std::vector<Variable> variables, DerivativeMethod method,
                         strategy::Steps& steps)
    : mechanics_(mechanics),
      variables_(std::move(variables)),
      method_(method),
      steps_(steps),
      dependence_(mechanics.graph, symbols_of(variables_)) {
  // They are the same for every right-hand side, and found by numbers.
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  if (method_ == DerivativeMethod::implicit && dynamics.l() > 0) dependent_rows_ = dynamics.dependent_rows(dynamics.g);
  if (method_ == DerivativeMethod::links)
    tangent_.emplace(strategy::tree_tangent(dynamics, mechanics.solution, mechanics.epsilon(), steps_));
}

void Derivatives::by(std::size_t variable) {
  begin(variable);
  if (mechanics_.dynamics.n() == 0) return;
  const std::string& name = variables_[variable].name;
  if (method_ == DerivativeMethod::implicit) solve(name);
  if (method_ == DerivativeMethod::links) solve_along_links(name);
}

strategy::Dynamics Derivatives::sides_by(std::size_t variable) {
  begin(variable);
  return sides(variables_[variable].name);
}

void Derivatives::begin(std::size_t variable) {
  const auto& [symbol, name] = variables_[variable];
  along_.emplace(mechanics_.graph);
  along_->seed(symbol, Expr(mechanics_.graph, mechanics_.graph.constant(1)));
  along_->name_rates("_by_" + name);
  if (is_parameter(mechanics_, symbol)) {
    seed_formulas(symbol);
  } else {
    along_->skip_others(dependence_, variable);
  }
}

Vector Derivatives::operator()(const Vector& functions) {
  Vector result;
  for (const Expr function : functions) result.push_back((*along_)(function));
  return result;
}

// Formulas stand in any order, but in no circle: after as many rounds as there are of them, every rate is known.
void Derivatives::seed_formulas(SymbolId symbol) {
  const std::vector<model::Parameter>& parameters = mechanics_.model.parameters;
  std::vector<Expr> rates(parameters.size(), Expr(mechanics_.graph, mechanics_.graph.constant(0)));
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (!parameters[i].is_formula || mechanics_.symbols.parameters[i] == symbol) continue;
      const Expr rate = (*along_)(mechanics_.expressions(parameters[i].value));
      if (rate == rates[i]) continue;
      rates[i] = rate;
      along_->seed(mechanics_.symbols.parameters[i], rate);
      has_changed = true;
    }
  }
}

strategy::Dynamics Derivatives::sides(const std::string& name) {
  const strategy::Dynamics& given = mechanics_.dynamics;
  const strategy::Solution& solution = mechanics_.solution;
  strategy::Dynamics other = given;
  other.dependent_rows = [rows = dependent_rows_](const Matrix&) { return rows; };
  other.names.prefix = "by_" + name + "_";
  steps_.begin("by " + name + ": forces f' - g' a + b'^T lambda and drifts drift' + b' a");
  const auto& along = [this](Expr function) { return (*along_)(function); };
  for (std::size_t i = 0; i < given.n(); ++i) {
    Expr force = along(given.f[i]);
    for (std::size_t j = 0; j < given.n(); ++j) force -= along(given.g[i][j]) * solution.accelerations[j];
    for (std::size_t mu = 0; mu < given.l(); ++mu) force += along(given.b[mu][i]) * solution.multipliers[mu];
    other.f[i] = steps_.name(force, "f_" + given.labels[i] + "_by_" + name);
  }
  for (std::size_t mu = 0; mu < given.l(); ++mu) {
    Expr drift = along(given.b_drift[mu]);
    for (std::size_t j = 0; j < given.n(); ++j) drift += along(given.b[mu][j]) * solution.accelerations[j];
    other.b_drift[mu] = steps_.name(drift, "drift_" + given.constraints[mu] + "_by_" + name);
  }
  return other;
}

void Derivatives::solve(const std::string& name) {
  const strategy::Dynamics& given = mechanics_.dynamics;
  const strategy::Solution& solution = mechanics_.solution;
  const strategy::Solution rates = solved_again(mechanics_, sides(name), steps_);
  for (std::size_t i = 0; i < given.n(); ++i) along_->take(solution.accelerations[i], rates.accelerations[i]);
  for (std::size_t mu = 0; mu < given.l(); ++mu) along_->take(solution.multipliers[mu], rates.multipliers[mu]);
}

// Derivatives of the terms are the disturbances; what these do to the links at rest is the derivative of the accelerations.
void Derivatives::solve_along_links(const std::string& name) {
  ir::Directional response(mechanics_.graph);
  response.name_rates("_by_" + name);
  std::vector<bool> is_disturbed(tangent_->terms.size(), false);
  for (std::size_t d = 0; d < tangent_->terms.size(); ++d) {
    const Expr rate = tangent_->solved((*along_)(tangent_->terms[d]));
    if (rate.is_zero()) continue;
    response.seed(tangent_->disturbances[d], rate.named("disturbance_by_" + name));
    is_disturbed[d] = true;
  }
  std::vector<bool> is_known(mechanics_.dynamics.n(), false);
  for (std::size_t i = 0; i < tangent_->limbs.size(); ++i) {
    const strategy::Limb& limb = tangent_->limbs[i];
    const auto moves_itself = [&](std::size_t d) { return is_disturbed[d]; };
    if (is_known[limb.speeds[0]] || std::any_of(limb.disturbances.begin(), limb.disturbances.end(), moves_itself))
      continue;
    follow(limb, i, response);
    for (const std::size_t u : limb.speeds) is_known[u] = true;
  }
  for (std::size_t i = 0; i < mechanics_.dynamics.n(); ++i) {
    const Expr rate = response(tangent_->accelerations[i]);
    along_->take(mechanics_.solution.accelerations[i],
                 steps_.name(rate, "a_" + mechanics_.dynamics.labels[i] + "_by_" + name));
  }
}

// What a limb does for each component of the acceleration before it is the same in all columns.
void Derivatives::follow(const strategy::Limb& limb, std::size_t index, ir::Directional& response) {
  const Expr one(mechanics_.graph, mechanics_.graph.constant(1)), zero = one - one;
  Matrix& per_component = responses_[index];
  for (std::size_t c = per_component.size(); c < limb.before.size(); ++c) {
    ir::Directional per(mechanics_.graph);
    per.name_rates("_per_" + mechanics_.graph.label(limb.before[c].id()));
    for (const Expr other : limb.before) per.take(other, zero);
    per.take(limb.before[c], one);
    per_component.emplace_back();
    for (const std::size_t u : limb.speeds)
      per_component.back().push_back(
          per(tangent_->accelerations[u]).named("response_of_" + mechanics_.dynamics.labels[u]));
  }
  for (std::size_t k = 0; k < limb.speeds.size(); ++k) {
    Expr rate = zero;
    for (std::size_t c = 0; c < limb.before.size(); ++c) rate += per_component[c][k] * response(limb.before[c]);
    response.take(tangent_->accelerations[limb.speeds[k]], rate);
  }
}

Vector state_rates(const Mechanics& mechanics) {
  Vector rates = mechanics.kinematics.configuration_rates.values();
  rates.insert(rates.end(), mechanics.solution.accelerations.begin(), mechanics.solution.accelerations.end());
  return rates;
}

namespace {

/// Rows of the Jacobian backwards. For a row i, g m = e_i + bᵀ l with b m = 0 is the same system with a force of 1 along i; then
/// a_i' = mᵀ (f' - g' a + b'ᵀ λ) + lᵀ (drift' + b' a): the derivatives of f, g, b and drift, each with a weight.
class Rows {
 public:
  Rows(Mechanics& mechanics, const std::vector<Variable>& variables, strategy::Steps& steps)
      : mechanics_(mechanics), steps_(steps), reverse_(mechanics.graph, symbols_of(variables)) {
    const strategy::Dynamics& dynamics = mechanics.dynamics;
    if (dynamics.l() > 0) dependent_rows_ = dynamics.dependent_rows(dynamics.g);
  }

  Vector of_rate(Expr rate) { return reverse_({{rate, number(1)}}, "bar"); }

  Vector of_acceleration(std::size_t i) {
    const strategy::Dynamics& given = mechanics_.dynamics;
    const strategy::Solution& solution = mechanics_.solution;
    const std::string name = "along_" + given.labels[i];
    strategy::Dynamics other = given;
    other.dependent_rows = [rows = dependent_rows_](const Matrix&) { return rows; };
    other.names.prefix = name + "_";
    other.f.assign(given.n(), number(0));
    other.f[i] = number(1);
    other.b_drift.assign(given.l(), number(0));
    steps_.begin("what a force of 1 along " + given.labels[i] + " does");
    const strategy::Solution response = solved_again(mechanics_, other, steps_);
    const Vector& m = response.accelerations;
    std::vector<ir::Weighted> sum;
    for (std::size_t j = 0; j < given.n(); ++j) {
      sum.push_back({given.f[j], m[j]});
      for (std::size_t k = 0; k < given.n(); ++k) sum.push_back({given.g[j][k], -(m[j] * solution.accelerations[k])});
    }
    for (std::size_t mu = 0; mu < given.l(); ++mu) {
      const Expr l = response.multipliers[mu];
      sum.push_back({given.b_drift[mu], l});
      for (std::size_t j = 0; j < given.n(); ++j)
        sum.push_back({given.b[mu][j], solution.multipliers[mu] * m[j] + l * solution.accelerations[j]});
    }
    return reverse_(sum, name);
  }

 private:
  Expr number(int value) const { return {mechanics_.graph, mechanics_.graph.constant(value)}; }

  Mechanics& mechanics_;
  strategy::Steps& steps_;
  ir::Reverse reverse_;
  std::vector<std::size_t> dependent_rows_;
};

Matrix jacobian_by_rows(Mechanics& mechanics, const std::vector<Variable>& variables, strategy::Steps& steps) {
  Rows rows(mechanics, variables, steps);
  Matrix result;
  for (const Expr rate : mechanics.kinematics.configuration_rates) result.push_back(rows.of_rate(rate));
  for (std::size_t i = 0; i < mechanics.dynamics.n(); ++i) result.push_back(rows.of_acceleration(i));
  return result;
}

}  // namespace

Matrix jacobian(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method,
                strategy::Steps& steps) {
  if (method == DerivativeMethod::reverse) return jacobian_by_rows(mechanics, variables, steps);
  const Vector rates = state_rates(mechanics);
  Derivatives derivatives(mechanics, variables, method, steps);
  Matrix result(rates.size());
  for (std::size_t k = 0; k < derivatives.count(); ++k) {
    derivatives.by(k);
    for (std::size_t i = 0; i < rates.size(); ++i) result[i].push_back(derivatives(rates[i]));
  }
  return result;
}

namespace {

constexpr std::size_t k_samples = 8;

/// Somewhere in each eighth of them: what is far from the ground takes more operations, or fewer, and nothing may depend on a place.
std::vector<std::size_t> sample_of(std::size_t count) {
  std::vector<std::size_t> result;
  const std::size_t samples = std::min(k_samples, count);
  for (std::size_t k = 0; k < samples; ++k) result.push_back((2 * k + 1) * count / (2 * samples));
  return result;
}

/// `next` forms a column or row, of which there are `count`.
double extrapolated(ir::Graph& graph, std::size_t count, const std::function<Vector(std::size_t)>& next) {
  const std::vector<std::size_t> sample = sample_of(count);
  std::vector<ir::NodeId> roots;
  double first = 0, all = 0;
  for (const std::size_t k : sample) {
    for (const Expr entry : next(k)) roots.push_back(entry.id());
    all = ir::operations(graph, roots);
    if (k == sample.front()) first = all;
  }
  if (sample.size() < 2) return all;
  return first + (all - first) / static_cast<double>(sample.size() - 1) * static_cast<double>(count - 1);
}

}  // namespace

double predicted_operations(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method) {
  strategy::Steps steps;
  if (method == DerivativeMethod::reverse) {
    Rows rows(mechanics, variables, steps);
    return extrapolated(mechanics.graph, mechanics.dynamics.n(),
                        [&](std::size_t i) { return rows.of_acceleration(i); });
  }
  Derivatives derivatives(mechanics, variables, method, steps);
  return extrapolated(mechanics.graph, variables.size(), [&](std::size_t k) {
    derivatives.by(k);
    return derivatives(mechanics.solution.accelerations);
  });
}

}  // namespace gaussgen
