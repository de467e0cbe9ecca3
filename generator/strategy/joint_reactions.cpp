#include "strategy/joint_reactions.hpp"

#include "strategy/joint_inertia.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::AppliedForce;
using kinematics::ConstraintAction;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;
using kinematics::FullIndex;
using kinematics::JointPlace;

namespace {

std::string name_of(const model::Model& model, std::size_t frame) {
  return frame == model::k_space ? "space" : model.frames[frame].name.text;
}

class JointSums {
 public:
  JointSums(const model::Model& model, const Dynamics& dynamics, const Solution& solution, Steps& steps)
      : model_(model),
        kinematics_(*dynamics.kinematics),
        solution_(solution),
        steps_(steps),
        joints_(*kinematics_.joints),
        tree_(joint_tree(model)),
        inertia_(inertia(dynamics)),
        sums_(inertia_.own),
        has_unfelt_(joints_.size(), false) {}

  std::vector<JointReaction> run() {
    take_loads_away();
    for (const ConstraintIndex mu : kinematics_.constraints.indices()) {
      for (const ConstraintAction& action : kinematics_.constraints[mu].actions) {
        if (is_zero(action.direction)) continue;
        take_away(action.frame, solution_.multipliers[mu.value] * action.direction, action.point);
      }
    }
    for (const std::size_t j : tree_.inward) add_up(j);
    std::vector<JointReaction> result;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const std::size_t frame = joints_[j].frame;
      result.push_back({joints_[j].name, model_.frames[frame].name.text, name_of(model_, model_.frames[frame].parent),
                        sums_[j].force, sums_[j].moment});
    }
    return result;
  }

 private:
  JointInertia inertia(const Dynamics& dynamics) {
    std::optional<JointInertia> result = inertia_by_links(model_, tree_, dynamics, solution_, steps_);
    return result ? std::move(*result) : inertia_by_bodies(model_, tree_, dynamics, solution_, steps_);
  }

  std::size_t carrier(std::size_t frame) const { return frame == model::k_space ? k_no_joint : tree_.carrier[frame]; }

  void take_loads_away() {
    for (const AppliedForce& load : kinematics_.applied) {
      const std::size_t j = carrier(load.frame);
      if (j == k_no_joint) continue;
      has_unfelt_[j] = has_unfelt_[j] || !is_zero(load.unfelt_force) || !is_zero(load.unfelt_moment);
      const bool counts = inertia_.counts_loads;
      take_away(load.frame, counts ? load.unfelt_force : load.force, load.point);
      sums_[j].moment = sums_[j].moment - (counts ? load.unfelt_moment : load.moment);
    }
  }

  void take_away(std::size_t frame, const Vector3& force, const Vector3& point) {
    const std::size_t j = carrier(frame);
    if (j == k_no_joint) return;
    sums_[j].force = sums_[j].force - force;
    sums_[j].moment = sums_[j].moment - cross(point - joints_[j].point, force);
  }

  // Each is complete once the joints that it carries have been added.
  void add_up(std::size_t j) {
    const JointPlace& joint = joints_[j];
    Wrench& sum = sums_[j];
    if (const std::optional<Expr> moment = moment_of_turn(j)) sum.moment[inertia_.turns[j]->axis] = *moment;
    steps_.begin("what " + model_.frames[joint.frame].name.text + " feels in joint " + joint.name +
                     ": Newton and Euler for all that it carries",
                 joint.name);
    sum = {steps_.name(sum.force, "force_in_" + joint.name), steps_.name(sum.moment, "moment_in_" + joint.name)};
    const std::size_t before = tree_.before[j];
    if (before == k_no_joint) return;
    has_unfelt_[before] = has_unfelt_[before] || has_unfelt_[j];
    sums_[before].force = sums_[before].force + sum.force;
    sums_[before].moment = sums_[before].moment + sum.moment + cross(inertia_.arms[j], sum.force);
  }

  // A turn does no work but by what acts along its coordinate: for this speed the equation of motion says what the moment is
  // (theory section 4), and the sum over all that the joint carries need not be formed.
  std::optional<Expr> moment_of_turn(std::size_t j) const {
    const std::optional<FreeTurn>& turn = inertia_.turns[j];
    if (!turn || has_unfelt_[j]) return std::nullopt;
    const FullIndex i = kinematics_.symbols.full(FreeIndex{turn->speed});
    if (!kinematics_.carried_force[i].is_zero()) return std::nullopt;
    Expr along = kinematics_.other_force[i];
    for (const ConstraintIndex mu : kinematics_.constraints.indices()) {
      if (!kinematics_.constraints[mu].carried[i].is_zero()) return std::nullopt;
      along += solution_.multipliers[mu.value] * kinematics_.constraints[mu].beside[i];
    }
    return along / turn->factor;
  }

  const model::Model& model_;
  const kinematics::Kinematics& kinematics_;
  const Solution& solution_;
  Steps& steps_;
  const std::vector<JointPlace>& joints_;
  JointTree tree_;
  JointInertia inertia_;
  std::vector<Wrench> sums_;
  std::vector<bool> has_unfelt_;
};

}  // namespace

std::vector<JointReaction> joint_reactions(const model::Model& model, const Dynamics& dynamics,
                                           const Solution& solution, Steps& steps) {
  return JointSums(model, dynamics, solution, steps).run();
}

}  // namespace gaussgen::strategy
