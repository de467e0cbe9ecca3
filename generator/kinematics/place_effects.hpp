#pragma once
// What forces at places do along the coordinates, and what of it bodies feel.

#include "kinematics/body_motions.hpp"
#include "kinematics/carriers.hpp"

namespace gaussgen::kinematics {

using Components = support::Indexed<FullIndex, ir::Expr>;

/// At a place that wanders over a body the body feels it where the place is now; what it does along the way of the place no body
/// feels, on a part without mass nothing of it, and a particle no moment.
struct PlaceEffect {
  Components felt, unfelt;
};

/// A force with its moment about a point, on what is there of a frame, in space.
struct Push {
  std::size_t frame = model::k_space;
  ir::Vector3 point, force, moment;
};

class PlaceEffects {
 public:
  PlaceEffects(const Symbols& symbols, Expressions& expressions, Partials& partials, BodyMotions& motions,
               const Carriers& carriers)
      : symbols_(symbols), expressions_(expressions), partials_(partials), motions_(motions), carriers_(carriers) {}

  /// `body`: that feels what acts on the frame.
  PlaceEffect operator()(const Push& push, std::optional<BodyIndex> body) const;

  bool is_felt_whole(const Push& push, BodyIndex body) const;
  ir::Vector3 moment_about(BodyIndex body, const Push& push) const;

 private:
  Components generalized(const Push& push) const;
  Components at_centre(BodyIndex body, const ir::Vector3& force) const;
  bool has_unfelt_moment(const Push& push, BodyIndex body) const;
  ir::Expr number(int value) const { return expressions_.number(value); }

  const Symbols& symbols_;
  Expressions& expressions_;
  Partials& partials_;
  BodyMotions& motions_;
  const Carriers& carriers_;
};

}  // namespace gaussgen::kinematics
