#include "conserved_energy.hpp"

#include <algorithm>

#include "ir/substitute.hpp"
#include "ir/traverse.hpp"

namespace gaussgen {

namespace {

using ir::Expr;

bool has_potential(const model::Force& force) {
  if (const auto* spring = std::get_if<model::Spring>(&force.law)) return !spring->damping;
  if (const auto* spring = std::get_if<model::CoordinateSpring>(&force.law)) return !spring->damping;
  return std::holds_alternative<model::UniformField>(force.law) || std::holds_alternative<model::Potential>(force.law);
}

class ConservedEnergy {
 public:
  explicit ConservedEnergy(Mechanics& mechanics) : mechanics_(mechanics), at_rest_(mechanics.graph) {
    for (const auto& speed : mechanics.symbols.speeds) at_rest_.replace(speed.symbol, mechanics.expressions.number(0));
  }

  bool operator()(Expr kinetic, Expr potential) {
    const auto& forces = mechanics_.model.forces;
    const auto& rows = mechanics_.kinematics.constraints;
    return std::all_of(forces.begin(), forces.end(), has_potential) && is_of_state(potential) && is_of_state(kinetic) &&
           at_rest_(kinetic).is_zero() &&
           std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return is_homogeneous(row); }) &&
           are_coordinates_scleronomic();
  }

 private:
  /// Rates of the configuration are linear in the speeds then. T vanishes at rest only where it is a quadratic form of them.
  bool are_coordinates_scleronomic() {
    for (const auto i : mechanics_.symbols.configuration.indices()) {
      const Expr rate = mechanics_.kinematics.configuration_rates[i];
      if (!is_of_state(rate) || !at_rest_(rate).is_zero()) return false;
    }
    for (const auto& held : mechanics_.symbols.held) {
      const Expr law = mechanics_.expressions(*mechanics_.model.coordinates[held.model_index].held_at);
      if (!is_of_state(law)) return false;
    }
    return true;
  }

  bool is_homogeneous(const kinematics::ConstraintRow& row) {
    return row.is_linear && is_of_state(row.phi) && at_rest_(row.phi).is_zero();
  }

  /// And of parameters, but not of time and inputs.
  bool is_of_state(Expr expression) const {
    const std::vector<ir::NodeId> nodes = ir::post_order(mechanics_.graph, {expression.id()});
    return std::none_of(nodes.begin(), nodes.end(), [&](ir::NodeId id) {
      const ir::Node& node = mechanics_.graph[id];
      return node.kind == ir::Kind::symbol &&
             (node.symbol == mechanics_.symbols.time ||
              mechanics_.graph.symbol(node.symbol).symbol_class == ir::SymbolClass::input);
    });
  }

  Mechanics& mechanics_;
  ir::Substitution at_rest_;
};

}  // namespace

bool conserves_energy(Mechanics& mechanics, ir::Expr kinetic, ir::Expr potential) {
  return ConservedEnergy(mechanics)(kinetic, potential);
}

}  // namespace gaussgen
