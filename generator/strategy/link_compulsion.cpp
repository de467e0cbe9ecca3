#include "strategy/link_compulsion.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "strategy/forces_from_rest.hpp"
#include "strategy/link_axes.hpp"
#include "strategy/link_motion.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::BodyLoad;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::Part;

namespace {

class LinkDeviations {
 public:
  LinkDeviations(const kinematics::Linkage& linkage, const kinematics::Kinematics& kinematics, const Vector& candidate,
                 Steps& steps)
      : links_(linkage.links),
        kinematics_(kinematics),
        candidate_(candidate),
        steps_(steps),
        motion_(links_, -kinematics.field, "candidate_"),
        axes_(links_, kinematics.field[0].graph()) {
    motion_.find_velocities(steps);
    steps.begin("candidate accelerations against free fall, each in the axes of its link");
    for (std::size_t i = 0; i < links_.size(); ++i) accelerations_.push_back(outward(i));
  }

  /// m a - F, in the axes of the link.
  Vector3 force(const Part& part) {
    const auto& [a, alpha] = accelerations_[part.link];
    const Vector3& omega = motion_.omega(part.link);
    const Vector3 at_centre = a + cross(alpha, part.centre) + cross(omega, cross(omega, part.centre));
    return part.mass * at_centre - in_axes(part, kinematics_.loads[part.body].force);
  }

  /// d(I ω)/dt - M, likewise, about the mass centre.
  Vector3 moment(const Part& part) {
    const Vector3& omega = motion_.omega(part.link);
    const Vector3 spin = cross(omega, ir::multiply(part.inertia, omega));
    return ir::multiply(part.inertia, accelerations_[part.link].angular) + spin -
           in_axes(part, kinematics_.loads[part.body].moment);
  }

 private:
  LinkAcceleration outward(std::size_t i) {
    const Link& link = links_[i];
    const Vector3 none = ir::zero3(kinematics_.field[0].graph());
    const LinkAcceleration before =
        link.parent == k_ground ? LinkAcceleration{motion_.fall(), none} : accelerations_[link.parent];
    LinkAcceleration now{motion_.turned(i, before.linear), motion_.turned(i, before.angular)};
    const bool is_shift = link.kind == Link::Kind::shift;
    Vector3& moved = is_shift ? now.linear : now.angular;
    if (is_shift) moved = moved + cross(before.angular, link.offset);
    moved = moved + motion_.drift(i, steps_);
    for (const kinematics::Freedom& freedom : link.freedoms)
      moved = moved + candidate_[freedom.speed.value] * freedom.column;
    return {steps_.name(now.linear, "candidate_a_" + link.name),
            steps_.name(now.angular, "candidate_alpha_" + link.name)};
  }

  Vector3 in_axes(const Part& part, const Vector3& v) {
    return is_zero(v) ? v : ir::multiply(transposed(axes_.of(part.link, steps_)), v);
  }

  const std::vector<Link>& links_;
  const kinematics::Kinematics& kinematics_;
  const Vector& candidate_;
  Steps& steps_;
  LinkMotion motion_;
  LinkAxes axes_;
  std::vector<LinkAcceleration> accelerations_;
};

bool has_inertia(const Part& part) {
  return !std::all_of(part.inertia.begin(), part.inertia.end(), [](const Vector3& row) { return is_zero(row); });
}

/// A candidate without what forces of no body do, and the condition under which it cannot be trusted.
struct Spread {
  Vector candidate;
  Expr singular;
};

/// Where constraints are there, Z may have a minimum though the metric has no inverse.
bool has_metric(const Dynamics& dynamics) { return dynamics.l() == 0 || dynamics.dependent_rows(dynamics.g).empty(); }

std::optional<Spread> spread_forces(const Dynamics& dynamics, const kinematics::Linkage& linkage,
                                    const Vector& candidate, Expr epsilon, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  Spread result{candidate, {epsilon.graph(), epsilon.graph().constant(0)}};
  const Vector& forces = kinematics.other_force.values();
  if (std::all_of(forces.begin(), forces.end(), [](Expr Q) { return Q.is_zero(); })) return result;
  if (kinematics.symbols.held.size() > 0 || !has_metric(dynamics)) return std::nullopt;
  const std::optional<Candidate> found = accelerated_from_rest(linkage, kinematics, forces, epsilon);
  if (!found) return std::nullopt;
  steps.append(found->steps);
  for (std::size_t u = 0; u < candidate.size(); ++u) result.candidate[u] -= found->solution.accelerations[u];
  result.singular = found->solution.singular_mass_matrix;
  return result;
}

}  // namespace

std::optional<Compulsion> compulsion_of_links(const Dynamics& dynamics, const kinematics::Linkage& given,
                                              const Vector& candidate, Expr epsilon, Steps& steps) {
  if (given.parts.size() != dynamics.kinematics->loads.size()) return std::nullopt;
  const std::optional<Spread> spread = spread_forces(dynamics, given, candidate, epsilon, steps);
  if (!spread) return std::nullopt;
  const kinematics::Linkage linkage = with_mixed_speeds(given);
  LinkDeviations deviations(linkage, *dynamics.kinematics, spread->candidate, steps);
  Expr twice(epsilon.graph(), epsilon.graph().constant(0));
  for (const Part& part : linkage.parts) {
    const std::string& name = linkage.links[part.link].name;
    steps.begin("deviation of what " + name +
                " carries from free motion, m a - F and d(I omega)/dt - M (theory.md, section 6)");
    const Vector3 force = steps.name(deviations.force(part), "deviation_" + name);
    twice += dot(force, force) * pow(part.mass, -1);
    if (!has_inertia(part)) continue;
    const Vector3 torque = steps.name(deviations.moment(part), "torque_" + name);
    twice += square_in_inverse_inertia({part.inertia, false, name}, torque, epsilon, steps);
  }
  return Compulsion{ir::Rational(1) / 2 * twice, spread->singular};
}

}  // namespace gaussgen::strategy
