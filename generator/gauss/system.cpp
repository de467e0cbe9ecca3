#include "gauss/system.hpp"

#include "gauss/force.hpp"

namespace gaussgen::gauss {

System build_system(const model::Model& model) {
  System system;
  system.chart = std::make_unique<Chart>(model);
  const Chart& chart = *system.chart;
  system.bodies = body_motions(model, chart);
  system.kinetic = kinetic_form(system.bodies, chart);
  system.metric = metric(system.kinetic, chart, system.bindings);
  system.connection = connection(system.kinetic, chart, system.bindings);
  system.Q = active_force(model, system.bodies, chart, system.bindings);
  system.invariant = invariant_accelerations(system.connection, system.metric, system.Q, chart);
  system.compulsion = compulsion(system.invariant, system.metric, chart);
  return system;
}

}  // namespace gaussgen::gauss
