#pragma once
// Where the frames of a model are and how they turn, on the graph.

#include <cstddef>
#include <optional>
#include <set>
#include <unordered_map>

#include "ir/differentiate.hpp"
#include "ir/vector3.hpp"
#include "kinematics/symbols.hpp"

namespace gaussgen::kinematics {

class Expressions;

/// Orientation of a body: `matrix` maps components along its axes to those in space, ω is given in `axes`.
struct Rotation {
  ir::Matrix3 matrix;
  ir::Vector3 omega;
  model::Axes axes = model::Axes::space;
};

/// From turned axes to those before, of a quaternion of unit length.
ir::Matrix3 quaternion_matrix(const std::array<ir::Expr, 4>& e);

/// About the mass centre, in the axes in which the model gives it.
ir::Matrix3 inertia_matrix(const model::Inertia& inertia, Expressions& expressions);

/// Frames are indices into Model::frames, or model::k_space. Each is placed once.
class Frames {
 public:
  /// Seen from `base`, as if that were space: of frames that it carries, and itself.
  Frames(const model::Model& model, const Symbols& symbols, Expressions& expressions,
         std::size_t base = model::k_space);

  /// m, space
  ir::Vector3 origin(std::size_t frame);

  /// From components along the frame's axes to those in space.
  ir::Matrix3 axes(std::size_t frame);

  /// Where a point of the frame is, in space; `inside` along the frame's axes from its origin, m.
  ir::Vector3 point(std::size_t frame, const ir::Vector3& inside);

  /// rad/s, in space or along the frame's own axes.
  ir::Vector3 omega(std::size_t frame, model::Axes axes);

  /// From here on the origin of a frame has the velocity of its parent's and what is between them as its rate, under a name, and turns about one axis
  /// add to each other likewise: of many frames on each other, sums from the ground on that are written once.
  void carry_velocities(std::size_t frame, ir::Directional& rates);

  /// Angular velocity against the parent, along the axes of the parent, rad/s.
  ir::Vector3 turning(std::size_t frame);

  Rotation rotation(std::size_t frame, model::Axes axes) { return {this->axes(frame), omega(frame, axes), axes}; }

 private:
  /// One turn against the axes before it, and its own angular velocity in those axes and in the turned ones.
  struct Step {
    ir::Matrix3 matrix;
    ir::Vector3 before;
    ir::Vector3 after;
    std::optional<std::size_t> axis;  ///< about x, y or z, by `angle`
    std::optional<ir::Expr> angle;
  };

  /// axes = base R(angle about axis). Turns about one axis that follow each other are one turn by the sum of their angles:
  /// fewer operations, and no digits lost in sums of products.
  struct Placed {
    ir::Vector3 origin;
    ir::Matrix3 base;
    std::optional<std::size_t> axis;
    std::optional<ir::Expr> angle;
    ir::Matrix3 axes;
    std::vector<Step> steps;
  };

  const Placed& placed(std::size_t frame);
  void carry_velocity(std::size_t frame, ir::Directional& rates);
  void carry_angle(std::size_t frame, ir::Directional& rates);
  Placed place(std::size_t frame);
  std::vector<Step> steps_of(const model::Attitude& attitude);
  Step turn(const model::Turn& turn);
  Step quaternion(std::size_t orientation);
  std::vector<ir::Vector3> turns_in_parent(std::size_t frame);
  ir::Vector3 omega_in_space(std::size_t frame);
  ir::Vector3 omega_in_body(std::size_t frame);
  ir::Matrix3 identity() const;

  const model::Model& model_;
  const Symbols& symbols_;
  Expressions& expressions_;
  std::size_t base_;
  std::unordered_map<std::size_t, Placed> placed_;
  std::set<std::size_t> carried_;
};

}  // namespace gaussgen::kinematics
