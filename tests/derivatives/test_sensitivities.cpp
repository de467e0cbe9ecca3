// Derivatives by parameters against difference quotients, for every model; formulas follow.

#include <algorithm>

#include "agreement/model_files.hpp"
#include "artefacts.hpp"
#include "catch_shim.hpp"
#include "derivatives.hpp"
#include "numbers.hpp"

using namespace gaussgen;
using derivatives::Numbers;

namespace {

constexpr std::size_t k_most_parameters = 8;
constexpr int k_states = 2;

std::vector<ir::NodeId> ids(const std::vector<strategy::Vector>& lists) {
  std::vector<ir::NodeId> result;
  for (const strategy::Vector& list : lists) {
    for (const ir::Expr value : list) result.push_back(value.id());
  }
  return result;
}

std::vector<ir::NodeId> derivatives_in(const emit::Group& group) {
  std::vector<ir::NodeId> result;
  for (const emit::Field& field : group.fields) result.insert(result.end(), field.values.begin(), field.values.end());
  return result;
}

ir::SymbolId symbol_of(const Mechanics& mechanics, const std::string& name) {
  for (std::size_t i = 0; i < mechanics.model.parameters.size(); ++i) {
    if (mechanics.model.parameters[i].name.text == name) return mechanics.symbols.parameters[i];
  }
  throw std::logic_error(name);
}

}  // namespace

TEST_CASE("sensitivities of every model are difference quotients of accelerations, multipliers and held reactions") {
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    model::Model model = agreement::load(file);
    for (const model::Parameter& parameter : model.parameters) {
      if (!parameter.is_formula && model.sensitivities.size() < k_most_parameters)
        model.sensitivities.push_back(parameter.name);
    }
    Mechanics mechanics(model, {});
    const auto artefacts = build_artefact("sensitivities", mechanics);
    REQUIRE(artefacts.size() == 1);
    REQUIRE(artefacts[0].groups.size() == model.sensitivities.size());
    const auto functions = ids({state_rates(mechanics), mechanics.solution.multipliers, mechanics.held_reactions});
    agreement::RandomStates states(mechanics.symbols, 3);
    int seen = 0;
    double worst = 0;
    for (int tries = 0; seen < k_states && tries < 10 * k_states; ++tries) {
      Numbers numbers(mechanics, states.next());
      if (numbers(functions).empty()) continue;
      ++seen;
      for (const emit::Group& group : artefacts[0].groups) {
        INFO("by " << group.name);
        const auto quotient = numbers.quotient(functions, symbol_of(mechanics, group.name));
        const auto found = numbers(derivatives_in(group));
        REQUIRE(found.size() == functions.size());
        REQUIRE(quotient.size() == functions.size());
        worst = std::max(worst, derivatives::deviation(found, quotient));
      }
    }
    CHECK(seen == k_states);
    std::printf("%-30s %10.2g\n", file.c_str(), worst);
    CHECK(worst < derivatives::k_tolerance);
  }
}

TEST_CASE("a formula that follows from a parameter counts, and the last of a chain of them") {
  // A ball on a slope: x_ddot = g sin(alpha)/(1 + J/(m r^2)) is 5/7 g sin(alpha) with J = 2/5 m r^2, whatever m is.
  const model::Model read = agreement::load("sphere_on_incline");
  const bool has_formula = std::any_of(read.parameters.begin(), read.parameters.end(),
                                       [](const model::Parameter& parameter) { return parameter.is_formula; });
  REQUIRE(has_formula);
  model::Model model = read;
  model.sensitivities = {model::Name{"m", model.name.span}};
  Mechanics mechanics(model, {});
  const auto artefacts = build_artefact("sensitivities", mechanics);
  agreement::RandomStates states(mechanics.symbols, 5);
  Numbers numbers(mechanics, states.next());
  for (const emit::Field& field : artefacts.at(0).groups.at(0).fields) {
    if (field.name != "rhs") continue;
    for (const cln::cl_F& value : numbers(field.values)) CHECK(std::abs(evaluate::to_double(value)) < 1e-50);
  }
}

TEST_CASE("without named parameters, and with numbers in their place, there is no such function") {
  const model::Model plain = agreement::load("double_pendulum");
  Mechanics none(plain, {});
  CHECK(build_artefact("sensitivities", none).empty());
  model::Model model = plain;
  model.sensitivities = {model.parameters[0].name};
  MechanicsOptions options;
  options.fold = true;
  Mechanics folded(model, options);
  CHECK(build_artefact("sensitivities", folded).empty());
}
