#include "strategy/forces_from_rest.hpp"

#include "ir/contract.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::Kinematics;
using kinematics::Linkage;

Linkage at_rest(Linkage linkage, Expr zero) {
  const ir::Vector3 none{zero, zero, zero};
  for (kinematics::Link& link : linkage.links) {
    link.velocity = link.drift = none;
    if (link.rate) link.rate = zero;
    if (link.velocity_before) link.velocity_before = none;
  }
  return linkage;
}

Kinematics without_constraints(Kinematics kinematics) {
  kinematics.constraints = {};
  kinematics.idle_slips.clear();
  return kinematics;
}

std::optional<Candidate> accelerated_from_rest(const Linkage& linkage, const Kinematics& kinematics,
                                               const Vector& forces, Expr epsilon) {
  const Expr zero(epsilon.graph(), epsilon.graph().constant(0));
  const Linkage resting = at_rest(linkage, zero);
  const Kinematics unconstrained = without_constraints(kinematics);
  const auto no_rate = [zero](Expr) { return zero; };
  const auto vanishes = [](Expr e) { return e.is_zero(); };
  const TreeProblem problem{resting,
                            unconstrained.symbols,
                            {zero, zero, zero},
                            forces,
                            {unconstrained, {}, {}, no_rate, vanishes, {}, {}, {}, {}},
                            "spread_"};
  return cheapest_tree(problem, epsilon);
}

}  // namespace gaussgen::strategy
