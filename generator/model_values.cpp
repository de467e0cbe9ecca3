#include "model_values.hpp"

#include <algorithm>
#include <cmath>

#include "evaluation.hpp"
#include "strategy/state_search.hpp"

namespace gaussgen {

using cln::cl_F;
using evaluate::Arithmetic;
using evaluate::Paired;
using evaluate::Scaled;
using support::Rational;

namespace {

/// Columns that are dependent up to this many digits are taken as dependent.
constexpr int k_rank_digits = 20;

/// Rounding of the finer run is smaller by this many orders.
constexpr int k_more_digits = 20;

/// Of the initial values that the graph finds.
constexpr int k_digits_found = 50;

/// Orders of magnitude between the parameters and 1: beside a mass of 1e80 one of 1 is 80 digits below.
int orders_apart(Mechanics& mechanics) {
  evaluate::Evaluator<double> values(mechanics.graph, Arithmetic<double>());
  bind_parameters(mechanics, values);
  double least = 0;
  double largest = 0;
  for (const model::Parameter& parameter : mechanics.model.parameters) {
    const std::optional<double> value = values(mechanics.expressions(parameter.value).id());
    if (!value || *value == 0 || !std::isfinite(*value)) continue;
    least = std::min(least, std::log10(std::abs(*value)));
    largest = std::max(largest, std::log10(std::abs(*value)));
  }
  return static_cast<int>(largest - least);
}

int carried(Mechanics& mechanics, int digits) { return 2 * (digits + orders_apart(mechanics)) + k_more_digits; }

}  // namespace

ModelValues::ModelValues(Mechanics& mechanics, const Rational& time, int digits)
    : graph_(mechanics.graph),
      carried_(carried(mechanics, digits)),
      values_(mechanics.graph, Arithmetic<Paired>(carried_, k_more_digits)),
      scales_(mechanics.graph, Arithmetic<Scaled<cl_F>>(values_.arithmetic().fine())) {
  bind(mechanics.symbols.time, values_.arithmetic().number(time));
  bind_parameters(mechanics, values_);
  bind_parameters(mechanics, scales_);
}

std::optional<cl_F> ModelValues::operator()(ir::NodeId node) {
  const std::optional<Paired> value = values_(node);
  return value ? std::optional<cl_F>(value->fine) : std::nullopt;
}

// A node without a first-order bound, such as sqrt(x) at 0, is taken as it is.
std::optional<cl_F> ModelValues::residual(ir::NodeId node, int digits) {
  const std::optional<cl_F> value = (*this)(node);
  if (!value) return value;
  const std::optional<Scaled<cl_F>> scaled = scales_(node);
  const bool is_small = scaled && cln::abs(*value) <= number(cln::expt(Rational(10), -digits)) * scaled->scale;
  return is_small ? number(Rational(0)) : *value;
}

bool ModelValues::is_true(ir::Expr condition) {
  const std::optional<Paired> value = values_(condition.id());
  return value && values_.arithmetic().is_true(*value);
}

// All before the first is bound: they may depend on each other's symbols.
std::vector<std::optional<Paired>> ModelValues::found(const Bindings& nodes) {
  std::vector<std::optional<Paired>> values;
  for (const auto& [symbol, node] : nodes) values.push_back(values_(node));
  return values;
}

void ModelValues::bind_defined(const Bindings& nodes) {
  const std::vector<std::optional<Paired>> values = found(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (values[i]) bind(nodes[i].first, *values[i]);
  }
}

bool ModelValues::bind(const Bindings& nodes) {
  const std::vector<std::optional<Paired>> values = found(nodes);
  if (std::any_of(values.begin(), values.end(), [](const auto& value) { return !value; })) return false;
  for (std::size_t i = 0; i < nodes.size(); ++i) bind(nodes[i].first, *values[i]);
  return true;
}

// Where half of the digits stay, the next step finds the other half.
Taken ModelValues::take_step(const Bindings& nodes) {
  const cl_F part = number(cln::expt(Rational(10), -(carried_ / 2 + 1)));
  std::vector<std::optional<cl_F>> before;
  for (const auto& [symbol, node] : nodes) before.push_back((*this)(graph_.use(symbol)));
  if (!bind(nodes)) return Taken::undefined;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const cl_F now = *(*this)(graph_.use(nodes[i].first));
    if (!before[i] || cln::abs(now - *before[i]) > part * cln::abs(now)) return Taken::moved;
  }
  return Taken::arrived;
}

void ModelValues::bind(ir::SymbolId symbol, const Paired& value) {
  values_.bind(symbol, value);
  scales_.bind(symbol, scales_.arithmetic().input(value.fine));
}

std::optional<evaluate::Matrix> ModelValues::operator()(const strategy::Matrix& matrix) {
  evaluate::Matrix result(matrix.size(), matrix.at(0).size(), number(Rational(0)));
  for (std::size_t i = 0; i < result.rows(); ++i) {
    for (std::size_t j = 0; j < result.columns(); ++j) {
      const std::optional<cl_F> entry = (*this)(matrix[i][j].id());
      if (!entry) return std::nullopt;
      result(i, j) = *entry;
    }
  }
  return result;
}

cl_F ModelValues::least_part() const { return number(cln::expt(Rational(10), -k_rank_digits)); }

std::optional<cl_F> ModelValues::relative_residual(ir::NodeId node) {
  const std::optional<cl_F> value = (*this)(node);
  if (!value || cln::zerop(*value)) return value;
  const std::optional<Scaled<cl_F>> scaled = scales_(node);
  return scaled && !cln::zerop(scaled->scale) ? std::optional<cl_F>(cln::abs(*value) / scaled->scale) : std::nullopt;
}

std::size_t ModelValues::rank(const evaluate::Matrix& matrix, const cl_F& part) const {
  return evaluate::rank(evaluate::equilibrated(matrix), part);
}

namespace {

std::vector<InitialValue> values_of(const kinematics::Symbols& symbols, const strategy::ProjectedState& state) {
  std::vector<InitialValue> result;
  for (const auto i : symbols.configuration.indices()) {
    const auto& q = symbols.configuration[i];
    result.push_back({q.symbol, q.name, q.unit, state.configuration[i.value].id()});
  }
  for (const auto i : symbols.speeds.indices()) {
    const auto& u = symbols.speeds[i];
    result.push_back({u.symbol, u.name, u.unit, state.speeds[i.value].id()});
  }
  return result;
}

std::vector<InitialValue> known_values(Mechanics& mechanics) {
  const ir::Expr never = mechanics.expressions.number(0);
  strategy::ProjectedState state{{}, {}, never, never, never};
  const std::size_t n_q = mechanics.symbols.configuration.size();
  for (std::size_t i = 0; i < mechanics.known_start->size(); ++i)
    (i < n_q ? state.configuration : state.speeds).push_back(mechanics.expressions.number((*mechanics.known_start)[i]));
  return values_of(mechanics.symbols, state);
}

Bindings bindings_of(const std::vector<InitialValue>& state) {
  Bindings nodes;
  for (const InitialValue& value : state) nodes.emplace_back(value.symbol, value.node);
  return nodes;
}

}  // namespace

std::vector<InitialValue> initial_values(Mechanics& mechanics, const std::function<Taken(const Bindings&)>& take_step) {
  if (mechanics.known_start) return known_values(mechanics);
  strategy::StateSearch search =
      strategy::initial_state(mechanics.model, mechanics.dynamics, mechanics.expressions,
                              mechanics.expressions.symbol(mechanics.symbols.time), false, mechanics.epsilon());
  std::vector<strategy::SearchStage>& stages = search.stages;
  if (stages.back().kind == strategy::SearchStage::Kind::check) stages.pop_back();
  for (const strategy::SearchStage& stage : stages) {
    std::vector<InitialValue> next = values_of(mechanics.symbols, stage.state);
    const bool is_last = &stage == &stages.back();
    Taken taken = Taken::moved;
    for (int step = is_last ? 1 : 0; step < stage.times && taken == Taken::moved; ++step)
      taken = take_step(bindings_of(next));
    if (is_last || taken == Taken::undefined) return next;
  }
  return {};
}

std::vector<InitialValue> initial_values(Mechanics& mechanics, ModelValues& values) {
  return initial_values(mechanics, [&](const Bindings& nodes) { return values.take_step(nodes); });
}

bool bind_initial_values(Mechanics& mechanics, const std::vector<InitialValue>& state, ModelValues& values) {
  const Bindings nodes = bindings_of(state);
  const bool is_defined = values.bind(nodes);
  if (!is_defined) values.bind_defined(nodes);
  for (const kinematics::HeldCoordinate& held : mechanics.symbols.held) {
    const ir::Expr c = mechanics.expressions(*mechanics.model.coordinates[held.model_index].held_at);
    const ir::Expr c_dot = mechanics.expressions.rate(c);
    values.bind({{held.symbol, c.id()}});
    values.bind({{held.rate, c_dot.id()}});
    values.bind({{held.acceleration, mechanics.expressions.rate(c_dot).id()}});
  }
  return is_defined;
}

void refine_initial_values(Mechanics& mechanics, int digits, ModelValues& values) {
  if (digits <= k_digits_found || mechanics.known_start) return;
  const std::vector<strategy::ProjectedState> steps =
      strategy::steps_to_initial_state(mechanics.model, mechanics.dynamics, mechanics.expressions, mechanics.epsilon());
  for (const strategy::ProjectedState& step : steps) {
    const Bindings nodes = bindings_of(values_of(mechanics.symbols, step));
    // Each step doubles the digits.
    for (int found = k_digits_found / 2; found < digits; found *= 2) values.bind(nodes);
  }
}

}  // namespace gaussgen
