#include "strategy/cut_wrenches.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::AppliedForce;
using kinematics::ConstraintAction;
using kinematics::ConstraintIndex;
using kinematics::Cut;
using kinematics::FreeIndex;
using kinematics::FullIndex;

namespace {

class CutSums {
 public:
  CutSums(const model::Model& model, CutTree tree, const Dynamics& dynamics, const Solution& solution, Steps& steps)
      : model_(model),
        kinematics_(*dynamics.kinematics),
        solution_(solution),
        steps_(steps),
        tree_(std::move(tree)),
        inertia_(inertia(dynamics)),
        sums_(inertia_.own),
        has_unfelt_(sums_.size(), false) {}

  std::vector<Wrench> run() {
    take_loads_away();
    for (const ConstraintIndex mu : kinematics_.constraints.indices()) {
      for (const ConstraintAction& action : kinematics_.constraints[mu].actions) {
        if (is_zero(action.direction)) continue;
        take_away(action.frame, solution_.multipliers[mu.value] * action.direction, action.point);
      }
    }
    for (const std::size_t j : tree_.inward) add_up(j);
    return std::move(sums_);
  }

 private:
  CutInertia inertia(const Dynamics& dynamics) {
    return links_tell_apart(model_, tree_, solution_) ? inertia_by_links(tree_, dynamics, solution_, steps_)
                                                      : inertia_by_bodies(model_, tree_, dynamics, solution_, steps_);
  }

  std::size_t carrier(std::size_t frame) const { return frame == model::k_space ? k_no_cut : tree_.carrier[frame]; }

  void take_loads_away() {
    for (const AppliedForce& load : kinematics_.applied) {
      const std::size_t j = carrier(load.frame);
      if (j == k_no_cut) continue;
      has_unfelt_[j] = has_unfelt_[j] || !is_zero(load.unfelt_force) || !is_zero(load.unfelt_moment);
      const bool counts = inertia_.counts_loads;
      take_away(load.frame, counts ? load.unfelt_force : load.force, load.point);
      sums_[j].moment = sums_[j].moment - (counts ? load.unfelt_moment : load.moment);
    }
  }

  void take_away(std::size_t frame, const Vector3& force, const Vector3& point) {
    const std::size_t j = carrier(frame);
    if (j == k_no_cut) return;
    sums_[j].force = sums_[j].force - force;
    sums_[j].moment = sums_[j].moment - cross(point - tree_.cuts[j].point, force);
  }

  // Each is complete once the joints that it carries have been added.
  void add_up(std::size_t j) {
    const Cut& cut = tree_.cuts[j];
    Wrench& sum = sums_[j];
    if (const std::optional<Expr> moment = moment_of_turn(j)) sum.moment[inertia_.turns[j]->axis] = *moment;
    const std::string from = cut.is_joint ? "in joint " + cut.name : "from its parent";
    steps_.begin(
        "what " + model_.frames[cut.frame].name.text + " feels " + from + ": Newton and Euler for all that it carries",
        cut.is_joint ? cut.name : "");
    sum = {steps_.name(sum.force, "force_in_" + cut.name), steps_.name(sum.moment, "moment_in_" + cut.name)};
    const std::size_t before = tree_.before[j];
    if (before == k_no_cut) return;
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
  CutTree tree_;
  CutInertia inertia_;
  std::vector<Wrench> sums_;
  std::vector<bool> has_unfelt_;
};

}  // namespace

std::vector<Wrench> cut_wrenches(const model::Model& model, CutTree tree, const Dynamics& dynamics,
                                 const Solution& solution, Steps& steps) {
  return CutSums(model, std::move(tree), dynamics, solution, steps).run();
}

}  // namespace gaussgen::strategy
