#pragma once
// Rows of constraints, and of what would be constraints if it stuck or touched.

#include <vector>

#include "kinematics/place_effects.hpp"

namespace gaussgen::kinematics {

/// Up to this number of rates derivatives by each of them are short.
inline constexpr std::size_t k_few_rates = 6;

class ConstraintRows {
 public:
  ConstraintRows(const model::Model& model, const Symbols& symbols, Expressions& expressions, Partials& partials,
                 BodyMotions& motions, const Carriers& carriers, const PlaceEffects& effects)
      : model_(model),
        symbols_(symbols),
        expressions_(expressions),
        partials_(partials),
        motions_(motions),
        carriers_(carriers),
        effects_(effects) {}

  /// With what it does on places that no body feels.
  ConstraintRow operator()(const model::Constraint& constraint);

  /// Its places only, of one that holds whatever the speeds are.
  ConstraintRow of_idle_slip(const model::Constraint& constraint);

  ConstraintRow of_contact(const model::Contact& contact);

  /// Each of the slips, as if it were 0.
  std::vector<ConstraintRow> of_slips(const model::Friction& law);

 private:
  ConstraintRow empty_row(const model::Constraint& constraint) const;
  ConstraintRow row_of(const model::Constraint& constraint);
  Components gradient(const ConstraintRow& row);
  void state(const model::VelocityLaw& law, ConstraintRow& row);
  void state(const model::PositionLaw& law, ConstraintRow& row);
  void state(const model::SlipLaw& law, ConstraintRow& row);
  template <class Phi>
  void find_actions(Phi phi, ConstraintRow& row);
  void find_carried(ConstraintRow& row);
  void find_wandering(ConstraintRow& row);
  bool moves_body(FullIndex i);
  ir::Vector3 velocity_over(std::size_t carrier, std::size_t place);
  ir::Expr number(int value) const { return expressions_.number(value); }
  ir::Expr partial(ir::Expr function, FullIndex i) { return partials_(function, i); }

  const model::Model& model_;
  const Symbols& symbols_;
  Expressions& expressions_;
  Partials& partials_;
  BodyMotions& motions_;
  const Carriers& carriers_;
  const PlaceEffects& effects_;
};

}  // namespace gaussgen::kinematics
