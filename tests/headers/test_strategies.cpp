// What each strategy emits compiles, says the same of accelerations, and differentiates what it says.

#include <algorithm>
#include <cmath>
#include <vector>

#include "by_metric/swinging_tray.hpp"
#include "by_multipliers/swinging_tray.hpp"
#include "by_tree/swinging_tray.hpp"
#include "catch_shim.hpp"

namespace {

constexpr double k_rounding = 1e-10;  ///< of the largest value: some thousand operations, of condition 10^3 at most
constexpr double k_step = 1e-6;
constexpr double k_of_quotient = 1e-7;  ///< of the largest value: rounding over the step

using Values = std::vector<double>;

void agree(const Values& found, const Values& expected, double tolerance) {
  REQUIRE(found.size() == expected.size());
  double largest = 0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(std::abs(found[i] - expected[i]) <= tolerance * largest);
}

/// One of the headers, of which these are the types.
template <class Parameters, class State, class Inputs, class Derivative, class Jacobian, class Pattern>
struct Emitted {
  decltype(prepare(Parameters{})) prepared = prepare(Parameters{});
  State state{};

  /// At a state beside the initial one, so that no angle is special.
  Emitted() {
    CHECK(initial_state(prepared, state) == gauss::Status::ok);
    double by = 0.01;
    for (double& value : state.values) value += (by += 0.003);
    CHECK(project(0.0, state, prepared, state) == gauss::Status::ok);
  }

  Values rates() const {
    Derivative result{};
    CHECK(rhs(0.0, state, Inputs{}, prepared, result) == gauss::Status::ok);
    return {std::begin(result.values), std::end(result.values)};
  }

  /// Row by row. Each component of the state is a variable by itself, so that off the constraints it depends on the strategy.
  Values by_state() const {
    Jacobian entries{};
    CHECK(jacobian(0.0, state, Inputs{}, prepared, entries) == gauss::Status::ok);
    Values result(static_cast<std::size_t>(Pattern::rows) * Pattern::columns);
    dense(entries, Pattern{}, result.data());
    return result;
  }

  Values quotients() {
    Values result(static_cast<std::size_t>(Pattern::rows) * Pattern::columns);
    for (std::size_t j = 0; j < Pattern::columns; ++j) {
      const double value = state.values[j];
      state.values[j] = value + k_step;
      const Values above = rates();
      state.values[j] = value - k_step;
      const Values below = rates();
      state.values[j] = value;
      for (std::size_t i = 0; i < Pattern::rows; ++i)
        result[i * Pattern::columns + j] = (above[i] - below[i]) / (2 * k_step);
    }
    return result;
  }
};

#define GAUSS_EMITTED_BY(strategy)                                                              \
  Emitted<strategy::swinging_tray::Parameters<double>, strategy::swinging_tray::State<double>,  \
          strategy::swinging_tray::Inputs<double>, strategy::swinging_tray::Derivative<double>, \
          strategy::swinging_tray::Jacobian<double>, strategy::swinging_tray::JacobianByState>

}  // namespace

TEST_CASE("each strategy has the same accelerations") {
  const Values by_tree = GAUSS_EMITTED_BY(by_tree)().rates();
  agree(GAUSS_EMITTED_BY(by_metric)().rates(), by_tree, k_rounding);
  agree(GAUSS_EMITTED_BY(by_multipliers)().rates(), by_tree, k_rounding);
}

TEST_CASE("each strategy has the Jacobian of its own accelerations") {
  const auto differentiates = [](auto emitted) { agree(emitted.by_state(), emitted.quotients(), k_of_quotient); };
  differentiates(GAUSS_EMITTED_BY(by_tree)());
  differentiates(GAUSS_EMITTED_BY(by_metric)());
  differentiates(GAUSS_EMITTED_BY(by_multipliers)());
}
