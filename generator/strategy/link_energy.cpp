#include "strategy/link_energy.hpp"

#include "ir/contract.hpp"
#include "strategy/massed_links.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// 2 T = m v·v + 2 m v·(ω × c) + ω·I ω about the origin of a link.
class KineticEnergy {
 public:
  KineticEnergy(const MassedLinks& links, LinkMotion& motion, Steps& steps)
      : links_(links), motion_(motion), steps_(steps) {}

  Expr twice_of(std::size_t i) const {
    const MassProperties& rest = links_.rest(i);
    const Vector3& omega = motion_.omega(i);
    Expr twice = dot(omega, ir::multiply(rest.inertia, omega));
    if (!links_.at_origin(i).is_zero()) {
      const Vector3& v = motion_.velocity(i, steps_);
      twice += links_.at_origin(i) * dot(v, v);
    }
    if (is_zero(rest.first)) return twice;
    return twice + ir::Rational(2) * dot(motion_.velocity(i, steps_), cross(omega, rest.first));
  }

 private:
  const MassedLinks& links_;
  LinkMotion& motion_;
  Steps& steps_;
};

/// field·r of the origins, m²/s².
Vector levels(const MassedLinks& links, LinkMotion& motion, Expr zero, Steps& steps) {
  Vector result;
  for (std::size_t i = 0; i < links.links().size(); ++i) {
    const Link& link = links.links()[i];
    Expr level = link.parent == k_ground ? zero : result[link.parent];
    if (link.kind == Link::Kind::shift)
      level = steps.name(level + dot(motion.fall_at(i), link.offset), "level_" + link.name);
    result.push_back(level);
  }
  return result;
}

}  // namespace

LinkEnergy energy_of_links(const kinematics::Linkage& linkage, const Vector3& field, Steps& steps) {
  ir::Graph& graph = field[0].graph();
  const MassedLinks links(linkage, graph);
  LinkMotion motion(links.links(), field, "");
  motion.find_velocities(steps);
  steps.begin(
      "velocities of the origins of links, each in the axes of its link, and levels of these places in the field");
  const KineticEnergy kinetic(links, motion, steps);
  const Expr zero(graph, graph.constant(0));
  const Vector level = levels(links, motion, zero, steps);
  LinkEnergy result{zero, zero};
  for (std::size_t i = 0; i < links.links().size(); ++i) {
    result.kinetic += ir::Rational(1) / 2 * kinetic.twice_of(i);
    result.of_field -= links.at_origin(i) * level[i];
    if (!is_zero(links.rest(i).first)) result.of_field -= dot(motion.fall_at(i), links.rest(i).first);
  }
  return result;
}

}  // namespace gaussgen::strategy
