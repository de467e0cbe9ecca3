#include "strategy/joint_reactions.hpp"

#include "strategy/cut_wrenches.hpp"

namespace gaussgen::strategy {

namespace {

std::string name_of(const model::Model& model, std::size_t frame) {
  return frame == model::k_space ? "space" : model.frames[frame].name.text;
}

}  // namespace

std::vector<JointReaction> joint_reactions(const model::Model& model, const Dynamics& dynamics,
                                           const Solution& solution, Steps& steps) {
  const std::vector<kinematics::Cut>& joints = *dynamics.kinematics->joints;
  const std::vector<Wrench> wrenches = cut_wrenches(model, cut_tree(model, joints), dynamics, solution, steps);
  std::vector<JointReaction> result;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const model::Frame& child = model.frames[joints[j].frame];
    result.push_back(
        {joints[j].name, child.name.text, name_of(model, child.parent), wrenches[j].force, wrenches[j].moment});
  }
  return result;
}

}  // namespace gaussgen::strategy
