#include "strategy/joint_inertia.hpp"

#include <algorithm>
#include <numeric>

#include "ir/contract.hpp"
#include "strategy/link_axes.hpp"
#include "strategy/reactions.hpp"
#include "strategy/tree_motion.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using kinematics::BodyIndex;
using kinematics::JointPlace;
using kinematics::k_ground;
using kinematics::Link;

JointTree joint_tree(const model::Model& model) {
  JointTree tree;
  std::vector<std::size_t> own(model.frames.size(), k_no_joint);
  for (std::size_t j = 0; j < model.joints.size(); ++j) own[model.joints[j].frame] = j;
  const auto carrier = [&](std::size_t frame) { return frame == model::k_space ? k_no_joint : tree.carrier[frame]; };
  // Frames come after their parents.
  for (std::size_t f = 0; f < model.frames.size(); ++f) {
    const std::size_t before = carrier(model.frames[f].parent);
    tree.carrier.push_back(own[f] == k_no_joint ? before : own[f]);
  }
  for (const model::Joint& joint : model.joints) tree.before.push_back(carrier(model.frames[joint.frame].parent));
  tree.inward.resize(model.joints.size());
  std::iota(tree.inward.begin(), tree.inward.end(), std::size_t{0});
  std::sort(tree.inward.begin(), tree.inward.end(),
            [&](std::size_t a, std::size_t b) { return model.joints[a].frame > model.joints[b].frame; });
  return tree;
}

namespace {

JointInertia nothing(const kinematics::Kinematics& kinematics) {
  const std::vector<JointPlace>& joints = *kinematics.joints;
  const Vector3 zero = ir::zero3(kinematics.field[0].graph());
  return {std::vector<Wrench>(joints.size(), Wrench{zero, zero}), std::vector<Vector3>(joints.size(), zero),
          std::vector<std::optional<FreeTurn>>(joints.size()), true};
}

void add(Wrench& sum, const Wrench& wrench, const Vector3& arm) {
  sum.force = sum.force + wrench.force;
  sum.moment = sum.moment + wrench.moment + cross(arm, wrench.force);
}

}  // namespace

JointInertia inertia_by_bodies(const model::Model& model, const JointTree& tree, const Dynamics& dynamics,
                               const Solution& solution, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  JointInertia result = nothing(kinematics);
  const std::vector<JointPlace>& joints = *kinematics.joints;
  const std::vector<BodyReaction> bodies = body_reactions(dynamics, solution, steps);
  for (const BodyIndex i : kinematics.bodies->indices()) {
    const std::size_t frame = model.bodies[i.value].frame;
    const std::size_t j = frame == model::k_space ? k_no_joint : tree.carrier[frame];
    if (j == k_no_joint) continue;
    const BodyReaction& body = bodies[i.value];
    add(result.own[j], {body.force, body.moment.value_or(ir::zero3(kinematics.field[0].graph()))},
        (*kinematics.bodies)[i].position - joints[j].point);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (tree.before[j] != k_no_joint) result.arms[j] = joints[j].point - joints[tree.before[j]].point;
  }
  return result;
}

namespace {

class LinkInertia {
 public:
  LinkInertia(const model::Model& model, const JointTree& tree, const kinematics::Kinematics& kinematics,
              const TreeMotion& motion, Steps& steps)
      : model_(model),
        tree_(tree),
        motion_(motion),
        links_(motion.linkage.links),
        steps_(steps),
        graph_(kinematics.field[0].graph()),
        axes_(links_, graph_),
        in_space_(links_.size()),
        arms_(links_.size(), ir::zero3(graph_)),
        before_(links_.size(), ir::zero3(graph_)),
        result_(nothing(kinematics)) {
    result_.counts_loads = false;
  }

  bool tells_joints_apart() const {
    for (const model::Body& body : model_.bodies) {
      if (body.frame != model::k_space && motion_.linkage.ends[body.frame] == k_ground) return false;
    }
    for (const kinematics::Part& part : motion_.linkage.parts) {
      if (carrier(part.link) != tree_.carrier[model_.bodies[part.body].frame]) return false;
    }
    return true;
  }

  JointInertia run(const std::vector<JointPlace>& joints) {
    steps_.begin("axes and places of the links, and accelerations of their origins against free fall, in space");
    for (std::size_t i = 0; i < links_.size(); ++i) find_arm(i);
    for (std::size_t i = 0; i < links_.size(); ++i) add_link(i);
    for (std::size_t j = 0; j < joints.size(); ++j) find_joint(j, joints);
    return std::move(result_);
  }

 private:
  std::size_t carrier(std::size_t link) const { return tree_.carrier[links_[link].frame]; }

  bool is_of_joint(std::size_t link, std::size_t joint) const {
    return joint != k_no_joint && model_.joints[joint].frame == links_[link].frame;
  }

  // From the origin of the child of the joint that carries the link, and from that of the joint that carries the one before.
  void find_arm(std::size_t i) {
    const std::size_t before = motion_.carriers[i];
    if (before != k_ground) before_[i] = arms_[before];
    if (links_[i].kind == Link::Kind::shift) {
      const Vector3 shift = ir::multiply(axes_.of(i, steps_), scaled(motion_.length, links_[i].offset));
      before_[i] = before_[i] + steps_.name(shift, "shift_" + links_[i].name);
    }
    if (!is_of_joint(i, carrier(i))) arms_[i] = before_[i];
  }

  // With a mass at the origin, where the axes of no link matter, and the rest in the axes of this one.
  void add_link(std::size_t i) {
    const MassProperties& own = motion_.properties[i];
    const Expr moved = motion_.moved[i];
    add_to(carrier(i), {force(i, own.mass - moved), ir::zero3(graph_)}, arms_[i]);
    add_to(carrier(i), resolved(i, about_origin(i)), arms_[i]);
    if (!moved.is_zero()) add_to(carrier(motion_.carriers[i]), {force(i, moved), ir::zero3(graph_)}, before_[i]);
  }

  void add_to(std::size_t joint, const Wrench& wrench, const Vector3& arm) {
    if (joint != k_no_joint) add(result_.own[joint], wrench, arm);
  }

  Vector3 force(std::size_t i, Expr mass) {
    if (mass.is_zero()) return ir::zero3(graph_);
    return ((motion_.mass * motion_.length) * mass) * origin(i);
  }

  /// Acceleration in the unit of length.
  const Vector3& origin(std::size_t i) {
    const std::size_t at = motion_.origins[i];
    if (at == k_ground) return motion_.fall;
    if (!in_space_[at]) {
      const Vector3 a = ir::multiply(axes_.of(at, steps_), motion_.accelerations[at].linear);
      in_space_[at] = steps_.name(a, "a_space_" + links_[at].name);
    }
    return *in_space_[at];
  }

  // Newton and Euler for a body of which the mass centre is not the origin (theory section 6), but for m a.
  Wrench about_origin(std::size_t i) const {
    const MassProperties& own = motion_.properties[i];
    const auto& [a, alpha] = motion_.accelerations[i];
    const Vector3& omega = motion_.omega[i];
    const Vector3 force = cross(alpha, own.first) + cross(omega, cross(omega, own.first));
    const Vector3 spin = cross(omega, ir::multiply(own.inertia, omega));
    const Vector3 moment = ir::multiply(own.inertia, alpha) + spin + cross(own.first, a);
    const ir::Rational per_force = motion_.mass * motion_.length;
    return {scaled(per_force, force), scaled(per_force * motion_.length, moment)};
  }

  Wrench resolved(std::size_t i, const Wrench& wrench) {
    const Matrix3& axes = axes_.of(i, steps_);
    return {ir::multiply(axes, wrench.force), ir::multiply(axes, wrench.moment)};
  }

  void find_joint(std::size_t j, const std::vector<JointPlace>& joints) {
    const std::size_t frame = model_.joints[j].frame, end = motion_.linkage.ends[frame];
    const std::size_t before = tree_.before[j];
    if (end == k_ground) {
      if (before != k_no_joint) result_.arms[j] = joints[j].point - joints[before].point;
      return;
    }
    std::size_t first = end;
    while (motion_.carriers[first] != k_ground && links_[motion_.carriers[first]].frame == frame) {
      first = motion_.carriers[first];
    }
    // A link of another frame: the joint adds nothing that moves or leads elsewhere.
    result_.arms[j] = links_[first].frame == frame ? before_[first] : arms_[first];
    if (links_[end].frame == frame) result_.turns[j] = free_turn(end);
  }

  std::optional<FreeTurn> free_turn(std::size_t i) {
    const std::optional<SoleFreedom>& sole = motion_.sole[i];
    if (!sole) return std::nullopt;
    const Vector3 along = column(axes_.of(i, steps_), links_[i].axis);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_alone = along[(k + 1) % 3].is_zero() && along[(k + 2) % 3].is_zero();
      if (is_alone && (along[k].is_one() || (-along[k]).is_one()))
        return FreeTurn{k, sole->speed, along[k] * sole->factor};
    }
    return std::nullopt;
  }

  const model::Model& model_;
  const JointTree& tree_;
  const TreeMotion& motion_;
  const std::vector<Link>& links_;
  Steps& steps_;
  ir::Graph& graph_;
  LinkAxes axes_;
  std::vector<std::optional<Vector3>> in_space_;
  std::vector<Vector3> arms_, before_;
  JointInertia result_;
};

}  // namespace

std::optional<JointInertia> inertia_by_links(const model::Model& model, const JointTree& tree, const Dynamics& dynamics,
                                             const Solution& solution, Steps& steps) {
  if (!solution.motion) return std::nullopt;
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  LinkInertia inertia(model, tree, kinematics, *solution.motion, steps);
  if (!inertia.tells_joints_apart()) return std::nullopt;
  return inertia.run(*kinematics.joints);
}

}  // namespace gaussgen::strategy
