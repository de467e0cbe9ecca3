#include "kinematics/carriers.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::kinematics {

using ir::Expr;

std::size_t Carriers::pushed(std::size_t frame) const {
  const std::size_t carrier = model::pushed_by_force_on(model_, frame);
  for (std::size_t at = frame; at != carrier; at = model_.frames[at].parent) {
    if (!is_fixed(model_.frames[at])) return carrier;
  }
  return frame;
}

std::optional<BodyIndex> Carriers::body_of(std::size_t frame) const {
  for (std::size_t at = frame; at != model::k_space; at = model_.frames[at].parent) {
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (model_.bodies[i].frame == at) return BodyIndex{i};
    }
    if (!is_fixed_to_parent(at)) return only_body_on(at);
  }
  return std::nullopt;
}

std::optional<BodyIndex> Carriers::only_body_on(std::size_t root) const {
  std::optional<BodyIndex> only;
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    if (root_of(model_.bodies[i].frame) != root) continue;
    if (only) return std::nullopt;
    only = BodyIndex{i};
  }
  return only;
}

/// The first frame below space, or below a motion or a joint, that a frame is fixed to.
std::size_t Carriers::root_of(std::size_t frame) const {
  while (frame != model::k_space && is_fixed_to_parent(frame)) frame = model_.frames[frame].parent;
  return frame;
}

bool Carriers::is_fixed_to_parent(std::size_t frame) const {
  return !is_carried_by_joint(frame) && is_fixed(model_.frames[frame]);
}

bool Carriers::is_carried_by_joint(std::size_t frame) const {
  return std::any_of(model_.joints.begin(), model_.joints.end(),
                     [&](const model::Joint& joint) { return joint.frame == frame; });
}

bool Carriers::is_fixed(const model::Frame& frame) const {
  if (std::holds_alternative<model::QuaternionOrientation>(frame.attitude)) return false;
  const auto is_constant = [&](const model::Ast& ast) {
    const Expr value = expressions_(ast);
    return ir::is_of_parameters(value.graph(), value.id());
  };
  if (!std::all_of(frame.position.begin(), frame.position.end(), is_constant)) return false;
  const auto* turns = std::get_if<model::Turns>(&frame.attitude);
  return turns == nullptr ||
         std::all_of(turns->begin(), turns->end(), [&](const model::Turn& turn) { return is_constant(turn.angle); });
}

}  // namespace gaussgen::kinematics
