#pragma once
// Which expressions of places are the same for whoever moves along with what carries all of these places.

#include <cstddef>
#include <optional>
#include <set>

#include "ir/vector3.hpp"
#include "model/model.hpp"

namespace gaussgen::kinematics {

class Expressions;

/// A distance of two bodies, or a component of it along an axis of a third, depends on the coordinates between them alone: formed in the
/// axes of the last frame that carries all of them, it has those of no other, where sums from the ground on have all up to there.
class RelativePlaces {
 public:
  RelativePlaces(const model::Model& model, Expressions& expressions) : model_(model), expressions_(expressions) {}

  /// Whether an expression, or a part of it, names places or axes.
  /// Angular velocities are those in space.
  bool has_spins(const model::Ast& ast) const;
  bool has_places(const model::Ast& ast) const;

  /// The last frame that carries all places and axes in an expression whose value is the same seen from there; nothing where that is
  /// space, or as good as space.
  std::optional<std::size_t> carrier(const model::Ast& ast);

  /// The last frame that carries all of these; space where that does not move.
  std::size_t moving_carrier(const std::set<std::size_t>& frames) const;

 private:
  /// How axes of a frame turn against space, in any motion.
  struct Turning {
    bool is_any = false;
    std::optional<std::size_t> axis;  ///< the only one about which they turn
  };

  void collect(const model::Ast& ast, std::set<std::size_t>& frames) const;
  std::size_t common_carrier(const std::set<std::size_t>& frames) const;
  bool moves(std::size_t frame) const;
  Turning turning(std::size_t frame) const;
  bool has_cases(const model::Ast& ast) const;
  bool is_the_same_from(std::size_t frame, const model::Ast& ast) const;

  const model::Model& model_;
  Expressions& expressions_;
};

}  // namespace gaussgen::kinematics
