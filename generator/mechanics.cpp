#include "mechanics.hpp"

#include "generic_point.hpp"

namespace gaussgen {

namespace {

std::vector<std::size_t> allowed_dependent(const Mechanics& mechanics) {
  std::vector<std::size_t> allowed;
  for (const model::Name& name : mechanics.model.dependent) {
    for (const auto i : mechanics.symbols.speeds.indices()) {
      if (mechanics.symbols.speeds[i].label == name.text) allowed.push_back(i.value);
    }
  }
  return allowed;
}

strategy::DependentRows rows_found_at_generic_point(ModelGraph& motion) {
  return [at_generic_point = std::make_shared<GenericPoint>(motion)](const strategy::Matrix& metric) {
    return dependent_rows((*at_generic_point)(metric));
  };
}

strategy::Solution solved(const Mechanics& mechanics, const MechanicsOptions& options, strategy::Steps& steps) {
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  if (dynamics.l() == 0) return strategy::solve_unconstrained(dynamics, mechanics.epsilon(), steps);
  if (!options.force_multipliers) {
    // The model's choice first, where it has one; structure_check says so if it is not safe.
    auto elimination = strategy::eliminate(dynamics, allowed_dependent(mechanics), steps);
    if (!elimination) elimination = strategy::eliminate(dynamics, {}, steps);
    if (elimination) return strategy::solve_by_elimination(dynamics, *elimination, mechanics.epsilon(), steps);
  }
  return strategy::solve_with_multipliers(dynamics, mechanics.epsilon(), steps);
}

// Rates of coordinates are speeds and need no name; those of quaternions are expressions.
void name_rates(Mechanics& mechanics) {
  const bool has_quaternions = !mechanics.symbols.first_quaternion_component.empty();
  if (!has_quaternions && mechanics.model.speeds.empty()) return;
  mechanics.steps.begin(mechanics.model.speeds.empty()
                            ? "rates of the quaternions: half the product with (0, omega) (theory.md, section 5)"
                            : "rates of the configuration from the speeds (theory.md, section 5)");
  for (const auto i : mechanics.symbols.configuration.indices()) {
    ir::Expr& rate = mechanics.kinematics.configuration_rates[i];
    rate = mechanics.steps.name(rate, mechanics.symbols.configuration[i].name + "_dot");
  }
}

}  // namespace

ModelGraph::ModelGraph(const model::Model& checked_model, bool fold, std::size_t most_nodes)
    : model(checked_model),
      graph(most_nodes),
      symbols(kinematics::declare_symbols(model, graph)),
      expressions(model, symbols, graph, fold) {}

KinematicModel::KinematicModel(const model::Model& checked_model, bool fold, std::size_t most_nodes)
    : ModelGraph(checked_model, fold, most_nodes),
      kinematics(kinematics::build_kinematics(model, graph, expressions, symbols)) {}

Mechanics::Mechanics(const model::Model& checked_model, const MechanicsOptions& options)
    : KinematicModel(checked_model, options.fold, options.most_nodes),
      covariant(kinematics::build_covariant(kinematics, graph)),
      dynamics(strategy::build_dynamics(kinematics, covariant, rows_found_at_generic_point(*this), steps)),
      solution(solved(*this, options, steps)),
      held_reactions(strategy::held_reactions(dynamics, solution, steps)) {
  name_rates(*this);
}

}  // namespace gaussgen
