#include "kinematics/constraint_rows.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/reverse.hpp"
#include "ir/substitute.hpp"
#include "kinematics/place_symbols.hpp"
#include "kinematics/slip.hpp"
#include "model/rate.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;

ConstraintRow ConstraintRows::operator()(const model::Constraint& constraint) {
  ConstraintRow row = row_of(constraint);
  find_carried(row);
  find_wandering(row);
  return row;
}

ConstraintRow ConstraintRows::of_idle_slip(const model::Constraint& constraint) {
  ConstraintRow row = empty_row(constraint);
  state(std::get<model::SlipLaw>(constraint.law), row);
  return row;
}

ConstraintRow ConstraintRows::of_contact(const model::Contact& contact) {
  model::Constraint row;
  row.law = model::PositionLaw{contact.gap};
  return row_of(row);
}

std::vector<ConstraintRow> ConstraintRows::of_slips(const model::Friction& law) {
  std::vector<ConstraintRow> rows;
  for (const auto& slip : law.slips) {
    model::Constraint row;
    std::visit([&](const auto& of_slip) { row.law = of_slip; }, slip);
    rows.push_back(row_of(row));
  }
  return rows;
}

ConstraintRow ConstraintRows::empty_row(const model::Constraint& constraint) const {
  return {
      constraint.name.text, constraint.multiplier_unit, {}, number(0), {}, number(0), {}, true, {}, {}, {}, number(0)};
}

ConstraintRow ConstraintRows::row_of(const model::Constraint& constraint) {
  ConstraintRow row = empty_row(constraint);
  std::visit([&](const auto& law) { state(law, row); }, constraint.law);
  row.beta = gradient(row);
  for (const FullIndex i : row.beta.indices()) {
    if (row.beta[i].is_zero()) continue;
    for (const FullIndex j : row.beta.indices()) row.is_linear = row.is_linear && partial(row.beta[i], j).is_zero();
  }
  if (row.actions.empty()) row.beside = row.beta;
  row.beta_drift = expressions_.rate(row.phi);
  if (constraint.point) row.point = expressions_(*constraint.point);
  return row;
}

// Of many rates, from φ back along the links to each of them: forwards, every rate goes the whole way to φ by itself.
Components ConstraintRows::gradient(const ConstraintRow& row) {
  Components beta;
  if (symbols_.full_count() <= k_few_rates) {
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) beta.push_back(partial(row.phi, i));
    return beta;
  }
  std::vector<ir::SymbolId> rates;
  for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) rates.push_back(symbols_.rate(i));
  return Components(ir::Reverse(expressions_.graph(), rates)({{row.phi, number(1)}}, "beta_" + row.name));
}

void ConstraintRows::state(const model::VelocityLaw& law, ConstraintRow& row) {
  row.phi = expressions_(law.phi);
  find_actions([&] { return expressions_(law.phi); }, row);
}

void ConstraintRows::state(const model::PositionLaw& law, ConstraintRow& row) {
  row.f = expressions_(law.f);
  const model::Ast phi = model::rate_of(law);
  row.phi = expressions_(phi);
  find_actions([&] { return expressions_(phi); }, row);
}

// φ once more with the places in it as symbols: its derivatives by their rates are the forces on them per multiplier.
template <class Phi>
void ConstraintRows::find_actions(Phi phi, ConstraintRow& row) {
  PlaceSymbols places(expressions_.graph());
  expressions_.watch(&places);
  const Expr watched = phi();
  expressions_.watch(nullptr);
  if (places.all().empty()) return;
  ir::Substitution put_in(expressions_.graph()), put_in_at_rest(expressions_.graph());
  for (const auto& [frame, symbols] : places.all()) {
    const Vector3 origin = expressions_.frames().origin(frame);
    for (std::size_t i = 0; i < 3; ++i) {
      for (ir::Substitution* const put : {&put_in, &put_in_at_rest}) put->replace(symbols[i].place, origin[i]);
      put_in.replace(symbols[i].rate, expressions_.rate(origin[i]));
      put_in_at_rest.replace(symbols[i].rate, number(0));
    }
  }
  row.phi_beside = put_in_at_rest(watched);
  for (const auto& [frame, symbols] : places.all()) {
    Vector3 direction = ir::zero3(expressions_.graph());
    for (std::size_t i = 0; i < 3; ++i) direction[i] = put_in(ir::partial(watched, symbols[i].rate));
    row.actions.push_back({frame, expressions_.frames().origin(frame), direction,
                           LocalDirection{frame, model::k_space, direction, carriers_.pushed(frame)}});
  }
  for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) {
    const Expr along = partial(watched, i);
    row.beside.push_back(along.is_zero() ? along : put_in(along));
  }
}

void ConstraintRows::state(const model::SlipLaw& law, ConstraintRow& row) {
  const ContactLine line = contact_line(expressions_, law);
  row.phi = slip(expressions_, law, line);
  row.actions.push_back({law.frame, line.point, line.direction});
  row.actions.push_back({law.surface, line.point, -line.direction});
  if (const auto* const place = std::get_if<std::size_t>(&law.at)) {
    const Vector3 components = expressions_(law.direction);
    row.actions[0].local = {*place, law.axes, components, law.frame};
    row.actions[1].local = {*place, law.axes, -components, law.surface};
  }
  row.beside = Components(symbols_.full_count(), number(0));
}

void ConstraintRows::find_carried(ConstraintRow& row) {
  row.carried = Components(symbols_.full_count(), number(0));
  for (const ConstraintAction& action : row.actions) {
    if (action.frame == model::k_space) continue;
    const std::optional<BodyIndex> body = carriers_.body_of(carriers_.pushed(action.frame));
    const Push push{action.frame, action.point, action.direction, ir::zero3(expressions_.graph())};
    // Its effect along every rate is not asked for then.
    if (body && effects_.is_felt_whole(push, *body)) continue;
    const Components unfelt = effects_(push, body).unfelt;
    for (const FullIndex i : unfelt.indices()) row.carried[i] += unfelt[i];
  }
}

// A held coordinate takes this itself, as part of what it carries; along one that moves no body, no body feels it.
void ConstraintRows::find_wandering(ConstraintRow& row) {
  for (ConstraintAction& action : row.actions) {
    const Expr power = dot(action.direction, velocity_over(carriers_.pushed(action.frame), action.frame));
    action.along_way = power;
    for (const FreeIndex a : symbols_.speeds.indices()) {
      const FullIndex i = symbols_.full(a);
      const Expr along = partial(power, i);
      if (!along.is_zero() && moves_body(i)) row.beside[i] += along;
    }
  }
}

bool ConstraintRows::moves_body(FullIndex i) {
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const BodyMotion& body = motions_[BodyIndex{b}];
    if (!is_zero(body.J[i]) || (body.is_rigid && !is_zero(body.W[i]))) return true;
  }
  return false;
}

/// Of a place against what is there of its carrier, in space.
Vector3 ConstraintRows::velocity_over(std::size_t carrier, std::size_t place) {
  Vector3 velocity = ir::zero3(expressions_.graph());
  for (std::size_t at = place; at != carrier; at = model_.frames[at].parent) {
    const Vector3 local = expressions_.rate(expressions_(model_.frames[at].position));
    velocity = velocity + ir::multiply(expressions_.frames().axes(model_.frames[at].parent), local);
  }
  return velocity;
}

}  // namespace gaussgen::kinematics
