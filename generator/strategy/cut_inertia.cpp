#include "strategy/cut_inertia.hpp"

#include <algorithm>
#include <numeric>

#include "ir/contract.hpp"
#include "strategy/body_reactions.hpp"
#include "strategy/link_origins.hpp"
#include "strategy/tree_motion.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using kinematics::BodyIndex;
using kinematics::k_ground;
using kinematics::Link;

CutTree cut_tree(const model::Model& model, std::vector<kinematics::Cut> cuts) {
  CutTree tree{std::move(cuts), {}, {}, {}};
  std::vector<std::size_t> own(model.frames.size(), k_no_cut);
  for (std::size_t j = 0; j < tree.cuts.size(); ++j) own[tree.cuts[j].frame] = j;
  const auto carrier = [&](std::size_t frame) { return frame == model::k_space ? k_no_cut : tree.carrier[frame]; };
  // Frames come after their parents.
  for (std::size_t f = 0; f < model.frames.size(); ++f) {
    const std::size_t before = carrier(model.frames[f].parent);
    tree.carrier.push_back(own[f] == k_no_cut ? before : own[f]);
  }
  for (const kinematics::Cut& cut : tree.cuts) tree.before.push_back(carrier(model.frames[cut.frame].parent));
  tree.inward.resize(tree.cuts.size());
  std::iota(tree.inward.begin(), tree.inward.end(), std::size_t{0});
  std::sort(tree.inward.begin(), tree.inward.end(),
            [&](std::size_t a, std::size_t b) { return tree.cuts[a].frame > tree.cuts[b].frame; });
  return tree;
}

namespace {

CutInertia nothing(const CutTree& tree, ir::Graph& graph) {
  const Vector3 zero = ir::zero3(graph);
  const std::size_t count = tree.cuts.size();
  return {std::vector<Wrench>(count, Wrench{zero, zero}), std::vector<Vector3>(count, zero),
          std::vector<std::optional<FreeTurn>>(count), true};
}

void add(Wrench& sum, const Wrench& wrench, const Vector3& arm) {
  sum.force = sum.force + wrench.force;
  sum.moment = sum.moment + wrench.moment + cross(arm, wrench.force);
}

}  // namespace

CutInertia inertia_by_bodies(const model::Model& model, const CutTree& tree, const Dynamics& dynamics,
                             const Solution& solution, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  CutInertia result = nothing(tree, kinematics.field[0].graph());
  const std::vector<BodyReaction> bodies = body_reactions_by_speeds(dynamics, solution, steps);
  for (const BodyIndex i : kinematics.bodies->indices()) {
    const std::size_t frame = model.bodies[i.value].frame;
    const std::size_t j = frame == model::k_space ? k_no_cut : tree.carrier[frame];
    if (j == k_no_cut) continue;
    const BodyReaction& body = bodies[i.value];
    add(result.own[j], {body.force, body.moment.value_or(ir::zero3(kinematics.field[0].graph()))},
        (*kinematics.bodies)[i].position - tree.cuts[j].point);
  }
  for (std::size_t j = 0; j < tree.cuts.size(); ++j) {
    if (tree.before[j] != k_no_cut) result.arms[j] = tree.cuts[j].point - tree.cuts[tree.before[j]].point;
  }
  return result;
}

namespace {

class LinkInertia {
 public:
  LinkInertia(const CutTree& tree, const kinematics::Kinematics& kinematics, const TreeMotion& motion, Steps& steps)
      : tree_(tree),
        motion_(motion),
        links_(motion.linkage.links),
        steps_(steps),
        graph_(kinematics.field[0].graph()),
        origins_(motion, graph_, steps),
        shifts_(links_.size(), ir::zero3(graph_)),
        arms_(links_.size(), ir::zero3(graph_)),
        before_(links_.size(), ir::zero3(graph_)),
        result_(nothing(tree, graph_)) {
    result_.counts_loads = false;
  }

  CutInertia run() {
    steps_.begin("axes and places of the links, and accelerations of their origins against free fall, in space");
    for (std::size_t i = 0; i < links_.size(); ++i) find_arm(i);
    for (std::size_t i = 0; i < links_.size(); ++i) add_link(i);
    for (std::size_t j = 0; j < tree_.cuts.size(); ++j) find_cut(j);
    return std::move(result_);
  }

 private:
  std::size_t carrier(std::size_t link) const {
    return link == k_ground ? k_no_cut : tree_.carrier[links_[link].frame];
  }

  bool is_of_cut(std::size_t link, std::size_t cut) const {
    return cut != k_no_cut && tree_.cuts[cut].frame == links_[link].frame;
  }

  // From the origins of the cut that carries the link, and of the one that carries the link before.
  void find_arm(std::size_t i) {
    const std::size_t before = motion_.carriers[i];
    if (links_[i].kind == Link::Kind::shift) {
      const Vector3 shift = ir::multiply(origins_.axes(i), scaled(motion_.length, links_[i].offset));
      shifts_[i] = steps_.name(shift, "shift_" + links_[i].name);
    }
    before_[i] = from(carrier(before), i);
    if (!is_of_cut(i, carrier(i))) arms_[i] = from(carrier(i), i);
  }

  // A cut to which no link of its own leads is where the link before ends.
  Vector3 from(std::size_t cut, std::size_t i) const {
    const std::size_t before = motion_.carriers[i];
    return before != k_ground && carrier(before) == cut ? arms_[before] + shifts_[i] : shifts_[i];
  }

  // With a mass at the origin, where the axes of no link matter, and the rest in the axes of this one.
  void add_link(std::size_t i) {
    const MassProperties& own = motion_.properties[i];
    const Expr moved = motion_.moved[i];
    add_to(carrier(i), {force(i, own.mass - moved), ir::zero3(graph_)}, arms_[i]);
    add_to(carrier(i), resolved(i, about_origin(i)), arms_[i]);
    if (!moved.is_zero()) add_to(carrier(motion_.carriers[i]), {force(i, moved), ir::zero3(graph_)}, before_[i]);
  }

  void add_to(std::size_t cut, const Wrench& wrench, const Vector3& arm) {
    if (cut != k_no_cut) add(result_.own[cut], wrench, arm);
  }

  Vector3 force(std::size_t i, Expr mass) {
    if (mass.is_zero()) return ir::zero3(graph_);
    return ((motion_.mass * motion_.length) * mass) * origins_.acceleration(i);
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
    const Matrix3& axes = origins_.axes(i);
    return {ir::multiply(axes, wrench.force), ir::multiply(axes, wrench.moment)};
  }

  void find_cut(std::size_t j) {
    const std::size_t frame = tree_.cuts[j].frame, end = motion_.linkage.ends[frame];
    const std::size_t before = tree_.before[j];
    if (end == k_ground) {
      if (before != k_no_cut) result_.arms[j] = tree_.cuts[j].point - tree_.cuts[before].point;
      return;
    }
    std::size_t first = end;
    while (motion_.carriers[first] != k_ground && links_[motion_.carriers[first]].frame == frame) {
      first = motion_.carriers[first];
    }
    if (links_[first].frame == frame) {
      result_.arms[j] = from(before, first);
    } else if (carrier(first) == before) {
      // A link of another frame: nothing moves here or leads elsewhere.
      result_.arms[j] = arms_[first];
    }
    if (links_[end].frame == frame) result_.turns[j] = free_turn(end);
  }

  std::optional<FreeTurn> free_turn(std::size_t i) {
    const std::optional<SoleFreedom>& sole = motion_.sole[i];
    if (!sole) return std::nullopt;
    const Vector3 along = column(origins_.axes(i), links_[i].axis);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_alone = along[(k + 1) % 3].is_zero() && along[(k + 2) % 3].is_zero();
      if (is_alone && (along[k].is_one() || (-along[k]).is_one()))
        return FreeTurn{k, sole->speed, along[k] * sole->factor};
    }
    return std::nullopt;
  }

  const CutTree& tree_;
  const TreeMotion& motion_;
  const std::vector<Link>& links_;
  Steps& steps_;
  ir::Graph& graph_;
  LinkOrigins origins_;
  std::vector<Vector3> shifts_, arms_, before_;
  CutInertia result_;
};

}  // namespace

bool links_tell_apart(const model::Model& model, const CutTree& tree, const Solution& solution) {
  if (!solution.motion) return false;
  const kinematics::Linkage& linkage = solution.motion->linkage;
  for (const model::Body& body : model.bodies) {
    if (body.frame == model::k_space || tree.carrier[body.frame] == k_no_cut) continue;
    if (linkage.ends[body.frame] == k_ground) return false;
  }
  return std::all_of(linkage.parts.begin(), linkage.parts.end(), [&](const kinematics::Part& part) {
    return tree.carrier[linkage.links[part.link].frame] == tree.carrier[model.bodies[part.body].frame];
  });
}

CutInertia inertia_by_links(const CutTree& tree, const Dynamics& dynamics, const Solution& solution, Steps& steps) {
  return LinkInertia(tree, *dynamics.kinematics, *solution.motion, steps).run();
}

}  // namespace gaussgen::strategy
