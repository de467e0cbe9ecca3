#pragma once
// The frames of a model as a tree of elementary motions, each resolved in the axes that it leads to: what the body-by-body
// strategy walks along (theory section 4; docs/decisions/0007).

#include <optional>
#include <string>
#include <vector>

#include "ir/substitute.hpp"
#include "kinematics/expressions.hpp"

namespace gaussgen::kinematics {

inline constexpr std::size_t k_ground = static_cast<std::size_t>(-1);

/// How much a motion accelerates with one speed: the column of its velocity, in the axes of the link (of a turn, along its
/// axis: one entry).
struct Freedom {
  FreeIndex speed;
  ir::Vector3 column;
};

/// One elementary motion against the link before it.
struct Link {
  enum class Kind {
    shift,  ///< the origin moves, the axes stay
    turn,   ///< about one of the axes
    spin,   ///< likewise, of something that is the same all around this axis: its axes need not turn with it
    free,   ///< any turn, by a quaternion
    ball,   ///< likewise, of something that is the same in all directions: its axes do not turn with it
  };
  Kind kind = Kind::shift;
  std::size_t parent = k_ground;
  std::size_t frame = 0;  ///< index into Model::frames: whose position or attitude it is part of
  std::string name;

  ir::Vector3 offset;             ///< m, of a shift
  std::size_t axis = 0;           ///< of a turn or spin
  std::optional<ir::Expr> rate;   ///< of a turn, rad/s: of the new axes against those before, about the axis
  std::optional<ir::Expr> angle;  ///< likewise, rad
  ir::Matrix3 matrix;             ///< of a free turn: from the new axes to those before
  ir::Vector3 velocity;           ///< of the offset; or the relative angular velocity, in the new axes
  ir::Vector3 drift;              ///< its derivative without accelerations
  std::vector<Freedom> freedoms;

  /// Where speeds are angular velocities along the axes before a free turn: what they are by components in the new ones. Each of the freedoms then
  /// is one of these components.
  std::optional<ir::Matrix3> to_speeds;
  std::optional<ir::Vector3>
      velocity_before;  ///< rad/s, in the axes before the turn, where these are those of the speeds
};

/// Whether what turns leaves its axes behind.
inline bool keeps_axes(const Link& link) { return link.kind == Link::Kind::spin || link.kind == Link::Kind::ball; }

/// What has mass, on the link that carries it.
struct Part {
  std::size_t body = 0;  ///< index into Model::bodies
  std::size_t link = k_ground;
  ir::Expr mass;
  ir::Vector3 centre;   ///< m, in the axes of the link, from its origin
  ir::Matrix3 inertia;  ///< about the mass centre, in the axes of the link; zero for particles
};

/// Where the origin of a frame is on the tree, and how its axes lie there.
struct Place {
  std::size_t link = k_ground;
  ir::Vector3 position;  ///< m, in the axes of the link, from its origin
  ir::Matrix3 axes;      ///< from those of the frame to those of the link
  bool is_fixed = true;  ///< nothing of it moves against the link
};

struct Linkage {
  std::vector<Link> links;                   ///< parents first
  std::vector<Part> parts;                   ///< those that move
  std::vector<std::optional<Place>> places;  ///< of frames; nothing where they turn by a quaternion and carry nothing
  std::vector<std::size_t> ends;  ///< of frames: their last links; k_ground where they carry nothing with mass
};

/// Makes freedoms columns again where speeds are along the axes before a free turn: each moves all three components.
void mix_speeds(Link& link);

/// The same links, of all of which freedoms are columns.
Linkage with_mixed_speeds(Linkage linkage);

/// Of parameters and numbers alone.
bool is_fixed(const ir::Vector3& v);

/// Links that carry nothing with mass are left out. `hold` puts the laws of held coordinates in.
Linkage build_linkage(const model::Model& model, const Symbols& symbols, Expressions& expressions,
                      ir::Substitution& hold);

}  // namespace gaussgen::kinematics
