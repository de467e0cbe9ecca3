#pragma once
// Which frames of a model move together, and which body feels what acts on one.

#include <optional>

#include "kinematics/expressions.hpp"
#include "kinematics/indices.hpp"

namespace gaussgen::kinematics {

class Carriers {
 public:
  Carriers(const model::Model& model, Expressions& expressions) : model_(model), expressions_(expressions) {}

  /// What a force on a frame pushes. Of points that are fixed, the motion is that of their frame, too.
  std::size_t pushed(std::size_t frame) const;

  /// The body that feels what acts on a frame: on it, or on one to which it is fixed, though not by a joint, whose reaction is
  /// asked for. Else the only one that is fixed to the same frame: of several, nobody said which.
  std::optional<BodyIndex> body_of(std::size_t frame) const;

  bool are_fixed_together(std::size_t a, std::size_t b) const { return root_of(a) == root_of(b); }
  bool is_carried_by_joint(std::size_t frame) const;

 private:
  std::optional<BodyIndex> only_body_on(std::size_t root) const;
  std::size_t root_of(std::size_t frame) const;
  bool is_fixed_to_parent(std::size_t frame) const;
  bool is_fixed(const model::Frame& frame) const;

  const model::Model& model_;
  Expressions& expressions_;
};

}  // namespace gaussgen::kinematics
