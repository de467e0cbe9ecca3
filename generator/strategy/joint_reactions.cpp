#include "strategy/joint_reactions.hpp"

#include "strategy/reactions.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::BodyIndex;
using kinematics::ConstraintIndex;

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
        bodies_(body_reactions(dynamics, solution, steps)) {}

  JointReaction of(const kinematics::JointPlace& joint) {
    force_ = ir::zero3(kinematics_.field[0].graph());
    moment_ = force_;
    at_ = &joint.point;
    for (const BodyIndex i : kinematics_.bodies->indices()) {
      if (is_carried(model_.bodies[i.value].frame, joint.frame))
        add(bodies_[i.value], (*kinematics_.bodies)[i].position);
    }
    for (const kinematics::AppliedForce& force : kinematics_.applied) {
      if (!is_carried(force.frame, joint.frame)) continue;
      take_away(force.unfelt_force, force.point);
      moment_ = moment_ - force.unfelt_moment;
    }
    for (const ConstraintIndex mu : kinematics_.constraints.indices()) {
      for (const kinematics::ConstraintAction& action : kinematics_.constraints[mu].actions) {
        if (!is_carried(action.frame, joint.frame)) continue;
        take_away(solution_.multipliers[mu.value] * action.direction, action.point);
      }
    }
    const std::string& child = model_.frames[joint.frame].name.text;
    steps_.begin("what " + child + " feels in joint " + joint.name + ": Newton and Euler for all that it carries",
                 joint.name);
    return {joint.name, child, name_of(model_, model_.frames[joint.frame].parent),
            steps_.name(force_, "force_in_" + joint.name), steps_.name(moment_, "moment_in_" + joint.name)};
  }

 private:
  bool is_carried(std::size_t frame, std::size_t by) const {
    for (std::size_t at = frame; at != model::k_space; at = model_.frames[at].parent) {
      if (at == by) return true;
    }
    return false;
  }

  void add(const BodyReaction& sum, const Vector3& centre) {
    force_ = force_ + sum.force;
    moment_ = moment_ + cross(centre - *at_, sum.force);
    if (sum.moment) moment_ = moment_ + *sum.moment;
  }

  void take_away(const Vector3& force, const Vector3& point) {
    force_ = force_ - force;
    moment_ = moment_ - cross(point - *at_, force);
  }

  const model::Model& model_;
  const kinematics::Kinematics& kinematics_;
  const Solution& solution_;
  Steps& steps_;
  std::vector<BodyReaction> bodies_;
  const Vector3* at_ = nullptr;
  Vector3 force_ = ir::zero3(kinematics_.field[0].graph());
  Vector3 moment_ = force_;
};

}  // namespace

std::vector<JointReaction> joint_reactions(const model::Model& model, const Dynamics& dynamics,
                                           const Solution& solution, Steps& steps) {
  std::vector<JointReaction> reactions;
  JointSums sums(model, dynamics, solution, steps);
  for (const kinematics::JointPlace& joint : *dynamics.kinematics->joints) reactions.push_back(sums.of(joint));
  return reactions;
}

}  // namespace gaussgen::strategy
