#include "rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "evaluation.hpp"

namespace gaussgen {

using evaluate::Arithmetic;
using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::FreeIndex;

namespace {

constexpr std::uint32_t k_states = 12;
constexpr std::array<double, 3> k_nearness{1e-1, 1e-2, 1e-3};  ///< rad, from being aligned
constexpr double k_right_angle = 1.5707963267948966;

/// In (-1, 1), without a pattern that a model could have: fractions of multiples of the golden ratio (Weyl), exact in both types.
class Scatter {
 public:
  explicit Scatter(std::uint32_t start) : index_(start) {}
  double operator()() { return 2 * (static_cast<double>(++index_ * 2654435769U) / 4294967296.0) - 1; }

 private:
  std::uint32_t index_;
};

template <class State>
void bind(State& state, ir::SymbolId symbol, double value) {
  state.rounded.bind(symbol, value);
  state.precise.bind(symbol, value);
}

}  // namespace

Rounding::Rounding(Mechanics& mechanics) : mechanics_(mechanics) {
  for (std::uint32_t i = 0; i < k_states; ++i) states_.push_back(state(i));
}

/// As the run has them: rounding of the model's own numbers is none of the solution.
void Rounding::bind_parameters_of(State& state) {
  bind_parameters(mechanics_, state.rounded);
  for (const auto* symbols : {&mechanics_.symbols.parameters, &mechanics_.symbols.inputs}) {
    for (const ir::SymbolId symbol : *symbols) {
      if (const auto value = state.rounded(mechanics_.expressions.symbol(symbol).id())) bind(state, symbol, *value);
    }
  }
}

Rounding::State Rounding::state(std::uint32_t number) {
  const kinematics::Symbols& symbols = mechanics_.symbols;
  State state{{mechanics_.graph, Arithmetic<double>()}, {mechanics_.graph, Arithmetic<long double>()}};
  bind_parameters_of(state);
  bind(state, symbols.time, 0);
  Scatter scattered(1000 * number);
  const double near = k_nearness[number % k_nearness.size()];
  for (std::size_t i = 0; i < mechanics_.model.coordinates.size(); ++i) {
    const auto& [is_held, index] = symbols.coordinates[i];
    if (is_held) continue;
    const double start =
        state.rounded(mechanics_.expressions(mechanics_.model.coordinates[i].start()).id()).value_or(0);
    const double turns = std::floor(2 * scattered()), apart = scattered();
    const bool is_length = symbols.speeds[FreeIndex{index}].is_of_length() && start != 0;
    bind(state, symbols.configuration[ConfigurationIndex{index}].symbol,
         is_length ? start + apart * std::abs(start) : turns * k_right_angle + near * apart);
  }
  for (const ConfigurationIndex first : symbols.first_quaternion_component) {
    std::array<double, 4> e{};
    for (double& component : e) component = scattered();
    const double size = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
    for (std::size_t j = 0; j < e.size(); ++j)
      bind(state, symbols.configuration[ConfigurationIndex{first.value + j}].symbol, e[j] / size);
  }
  for (const kinematics::Speed& speed : symbols.speeds) bind(state, speed.symbol, scattered());
  return state;
}

double Rounding::operator()(const strategy::Solution& solution) {
  struct Sizes {
    long double largest = 0, difference = 0;
  };
  std::map<std::string, Sizes> by_unit;
  const auto add = [&](State& state, Expr e, const std::string& unit) {
    const auto rounded = state.rounded(e.id());
    const auto precise = state.precise(e.id());
    if (!rounded || !precise) return;
    Sizes& sizes = by_unit[unit];
    sizes.largest = std::max(sizes.largest, std::abs(*precise));
    sizes.difference = std::max(sizes.difference, std::abs(*precise - *rounded));
  };
  const auto& constraints = mechanics_.kinematics.constraints;
  for (State& state : states_) {
    for (const FreeIndex a : mechanics_.symbols.speeds.indices())
      add(state, solution.accelerations[a.value], mechanics_.symbols.speeds[a].unit);
    for (const auto mu : constraints.indices())
      add(state, solution.multipliers[mu.value], "of a multiplier: " + constraints[mu].unit);
  }
  double result = 0;
  for (const auto& [unit, sizes] : by_unit) {
    if (sizes.largest > 0) result = std::max(result, static_cast<double>(sizes.difference / sizes.largest));
  }
  return result;
}

}  // namespace gaussgen
