#include "strategy/link_choice.hpp"

#include "ir/cost.hpp"

namespace gaussgen::strategy {

int operations_with(const Solution& solution, const Vector& values) {
  std::vector<ir::NodeId> roots;
  for (const Vector* each : {&solution.accelerations, &solution.multipliers, &values}) {
    for (const ir::Expr value : *each) roots.push_back(value.id());
  }
  return ir::operations(solution.singular_mass_matrix.graph(), roots);
}

}  // namespace gaussgen::strategy
