#include "newton/specimen.hpp"

#include "ir/differentiate.hpp"
#include "strategy/body_reactions.hpp"
#include "strategy/joint_reactions.hpp"

namespace agreement::newton {

using gaussgen::evaluate::Arithmetic;

Specimen::Specimen(gaussgen::model::Model read)
    : model(std::move(read)),
      mechanics(model, {}),
      fixed(constants(model)),
      evaluator_(mechanics.graph, Arithmetic<double>()) {
  gaussgen::strategy::Steps steps;
  // Both ways are chosen by operations; the recursion over links is what can be wrong.
  auto bodies = body_reactions_by_links(model, mechanics.dynamics, mechanics.solution, steps);
  if (!bodies) bodies = body_reactions_by_speeds(mechanics.dynamics, mechanics.solution, steps);
  for (const auto& body : *bodies) {
    bodies_.push_back({body.force, body.moment.value_or(gaussgen::ir::zero3(mechanics.graph))});
  }
  for (const auto& joint : gaussgen::strategy::joint_reactions(model, mechanics.dynamics, mechanics.solution, steps)) {
    joints_.push_back({joint.force, joint.moment});
  }
  add_energy_rate();
  gaussgen::bind_parameters(mechanics, evaluator_);
}

void Specimen::add_energy_rate() {
  const auto& symbols = mechanics.symbols;
  gaussgen::ir::Directional along(mechanics.graph);
  along.seed(symbols.time, mechanics.expressions.number(1));
  for (const auto i : symbols.configuration.indices()) {
    along.seed(symbols.configuration[i].symbol, mechanics.kinematics.configuration_rates[i]);
  }
  for (const auto i : symbols.speeds.indices()) {
    along.seed(symbols.speeds[i].symbol, mechanics.expressions.symbol(symbols.speeds[i].acceleration));
  }
  energy_rate_ = along(mechanics.covariant->kinetic_energy + *mechanics.kinematics.potential).id();
}

double Specimen::value(gaussgen::ir::NodeId node) { return evaluator_(node).value_or(std::nan("")); }

Wrench Specimen::wrench(const Nodes& nodes) {
  Wrench result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.force[static_cast<Eigen::Index>(i)] = value(nodes[0][i].id());
    result.moment[static_cast<Eigen::Index>(i)] = value(nodes[1][i].id());
  }
  return result;
}

bool Specimen::at(const State& now) {
  state = now;
  bind(mechanics.symbols, state, evaluator_);
  condition = mechanics.dynamics.n() == 0 ? 1 : scaling(evaluator_, mechanics.dynamics).condition;
  if (!(condition <= k_largest_condition)) return false;
  const auto all = [&](const gaussgen::strategy::Vector& v) {
    std::vector<double> result;
    for (const auto e : v) result.push_back(value(e.id()));
    return result;
  };
  a = all(mechanics.solution.accelerations);
  lambda = all(mechanics.solution.multipliers);
  R = all(mechanics.held_reactions);
  on_bodies.clear();
  in_joints.clear();
  for (const Nodes& nodes : bodies_) on_bodies.push_back(wrench(nodes));
  for (const Nodes& nodes : joints_) in_joints.push_back(wrench(nodes));
  for (const auto i : mechanics.symbols.speeds.indices()) {
    evaluator_.bind(mechanics.symbols.speeds[i].acceleration, a[i.value]);
  }
  kinetic = value(mechanics.covariant->kinetic_energy.id());
  potential = value(mechanics.kinematics.potential->id());
  energy_rate = value(energy_rate_);
  return true;
}

}  // namespace agreement::newton
