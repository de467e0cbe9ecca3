#include "kinematics/hold.hpp"

namespace gaussgen::kinematics {

using ir::Expr;

ir::Substitution held_laws(const model::Model& model, Expressions& expressions, const Symbols& symbols) {
  ir::Substitution substitution(expressions.graph());
  for (const HeldCoordinate& held : symbols.held) {
    const Expr c = expressions(*model.coordinates[held.model_index].held_at).named(held.name);
    const Expr c_dot = expressions.rate(c).named(held.name + "_dot");
    substitution.replace(held.symbol, c);
    substitution.replace(held.rate, c_dot);
    substitution.replace(held.acceleration, expressions.rate(c_dot).named(held.name + "_ddot"));
  }
  return substitution;
}

void hold_coordinates(Holder& hold, Kinematics& kinematics) {
  for (const HeldCoordinate& held : kinematics.symbols.held) {
    Expr acceleration(kinematics.field[0].graph(), kinematics.field[0].graph().use(held.acceleration));
    hold(acceleration);
    kinematics.held_acceleration.push_back(acceleration);
  }
  hold(kinematics.constraints);
  for (ConstraintRow& row : kinematics.idle_slips) hold(row);
  hold(kinematics.configuration_rates);
  hold(kinematics.speeds_at_rest);
  hold(kinematics.body_force);
  hold(kinematics.field);
  hold(kinematics.applied);
  hold(kinematics.loads);
  hold(kinematics.other_force);
  hold(kinematics.carried_force);
  for (Expr& guard : kinematics.guards) hold(guard);
  for (Expr& limit : kinematics.guard_limits) hold(limit);
  for (ConstraintRow& row : kinematics.switches.contacts) hold(row);
  for (std::vector<ConstraintRow>& rows : kinematics.switches.frictions) {
    for (ConstraintRow& row : rows) hold(row);
  }
  for (std::vector<Expr>& limits : kinematics.switches.limits) {
    for (Expr& limit : limits) hold(limit);
  }
  for (std::vector<Expr>& values : kinematics.quantities) {
    for (Expr& value : values) hold(value);
  }
}

}  // namespace gaussgen::kinematics
