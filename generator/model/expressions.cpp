#include "model/expressions.hpp"

namespace gaussgen::model {

namespace {

using Visit = std::function<void(const Ast&, const Slot&)>;

constexpr Place in(Quantity quantity, Place place) {
  place.quantity = quantity;
  return place;
}

/// Names such as `tip.x` are allowed, too: not in placements themselves, which they follow from.
constexpr Place with_places(Place place) {
  place.places = true;
  return place;
}

constexpr Place with_reactions(Reactions how, Place place) {
  place.reactions = how;
  return place;
}

/// Derivatives by coordinates, speeds or time are taken of what stands there.
constexpr Place differentiated(int times, Place place) {
  place.derivatives = times;
  return place;
}

constexpr Place k_parameter{"the value of a parameter", "parameters stay constant during a motion",
                            "use numbers, pi and other parameters"};
constexpr Place k_points{"the points of a table", "they are numbers when the code is generated", "use numbers and pi",
                         false};
constexpr Place k_input{"the default of an input", "it is a plain number", "use numbers and pi", false};
constexpr Place k_held = differentiated(
    2, {"'held_at'", "a held coordinate follows a given law of time", "use parameters and t", true, true, false, false,
        false, "hold a gap instead: 'gap: {held_at: 0}', and write gap + this formula into the positions"});
constexpr Place k_speed = [] {
  Place place{"a speed",
              "it says how rates make it up",
              "use rates such as dot(x), angular velocities, coordinates, parameters and t",
              true,
              true,
              true,
              true};
  place.defines_speeds = true;
  place.derivatives = 1;
  return place;
}();
constexpr Place k_initial{"an initial value", "it is known before the motion starts", "use numbers and parameters"};
constexpr Place k_mass =
    in(Quantity::mass, {"the mass of a body", "masses stay constant", "use numbers and parameters"});
constexpr Place k_inertia =
    in(Quantity::inertia,
       {"the inertia of a body", "it is constant in axes that turn with the body", "use numbers and parameters"});
constexpr Place k_centre =
    in(Quantity::length, {"a mass centre", "it is fixed in the frame of its body", "use numbers and parameters"});
constexpr Place k_place_of_force =
    in(Quantity::length, {"the place of a force", "it is fixed in the axes of what 'on' names",
                          "use numbers and parameters; a place that moves there is declared under 'points'"});
constexpr Place k_axis{"an axis", "it is fixed in its frame", "use numbers and parameters"};
constexpr Place k_placement = differentiated(
    2, in(Quantity::length,
          {"a position", "it is a formula of coordinates and time",
           "use coordinates, parameters and t; what begins at another frame names it as 'parent'", true, true, true}));
constexpr Place k_point = with_places(differentiated(
    1, in(Quantity::length, {"the point of a constraint", "a place does not depend on speeds or on inputs",
                             "use coordinates, parameters and t", true, true, true})));
constexpr Place k_angle =
    differentiated(2, in(Quantity::angle, {"an angle", "an attitude does not depend on speeds or on inputs",
                                           "use coordinates, parameters and t", true, true, true}));
constexpr Place k_velocity =
    with_places(differentiated(1, {"a constraint", "a constraint holds whatever the inputs are",
                                   "use a parameter, or put the input into a force", true, true, true, true}));
constexpr Place k_equation =
    with_places(differentiated(2, {"an equation of positions", "it is about places and time alone",
                                   "write 'velocity:' for a constraint on velocities", true, true, true}));
constexpr Place k_direction =
    differentiated(1, {"a direction", "it is fixed in the axes that 'in' names",
                       "use numbers, parameters and t, and name a frame by 'in'", true, true});
constexpr Place k_field =
    in(Quantity::acceleration, {"a uniform field", "the field is the same everywhere",
                                "use parameters and t, or a potential or generalized force", true, true});
constexpr Place k_potential =
    with_places(differentiated(1, in(Quantity::energy, {"a potential", "a potential depends on places and time alone",
                                                        "write a 'generalized' force instead", true, true, true})));
constexpr Place k_generalized =
    with_reactions(Reactions::linear, with_places({"a generalized force", "", "", true, true, true, true, true}));
constexpr Place k_force = with_reactions(
    Reactions::linear, with_places(in(Quantity::force, {"a force", "", "", true, true, true, true, true})));
constexpr Place k_torque = with_reactions(
    Reactions::linear, with_places(in(Quantity::torque, {"a torque", "", "", true, true, true, true, true})));
constexpr Place k_quantity =
    with_reactions(Reactions::any, with_places({"a quantity", "", "", true, true, true, true, true}));
constexpr Place k_limit =
    with_reactions(Reactions::linear, with_places({"the limit of friction", "", "", true, true, true, true, true}));
constexpr Place k_gap = with_places(differentiated(
    2, {"a gap", "it is about places and time alone", "use coordinates, places, parameters and t", true, true, true}));
constexpr Place k_restitution =
    in(Quantity::number, {"a restitution", "it is the same at all impacts", "use numbers and parameters"});
constexpr Place k_strength{"the reaction at which a constraint breaks", "it stays constant during a motion",
                           "use numbers and parameters"};
constexpr Place k_guard =
    with_reactions(Reactions::guards, with_places({"a guard", "", "", true, true, true, true, true}));
constexpr Place k_slip =
    with_places(differentiated(1, {"a velocity of slip", "friction acts along it whatever the inputs are",
                                   "use rates such as dot(x), coordinates, parameters and t", true, true, true, true}));
constexpr Place k_smooth{"the slip below which friction fades", "it stays constant during a motion",
                         "use numbers and parameters"};
constexpr Place k_spring{"a property of a spring", "springs are linear",
                         "use parameters and t, or write a 'force' for another law", true, true};
constexpr Place k_dot =
    with_places({"dot(...)",
                 "it is the rate of something that depends on coordinates and time; accelerations and rates of "
                 "inputs are not available",
                 "use coordinates, parameters and t inside dot(...)", true, true, true});

template <class List>
void visit_all(const List& list, const Slot& slot, const Visit& visit) {
  for (const Ast& ast : list) visit(ast, slot);
}

void visit_optional(const std::optional<Ast>& ast, const Slot& slot, const Visit& visit) {
  if (ast) visit(*ast, slot);
}

void visit_motion(const Model& model, const Visit& visit) {
  for (const Speed& speed : model.speeds) visit(speed.is, {k_speed, Quantity::owner, speed.name});
  for (const Coordinate& coordinate : model.coordinates) {
    const Slot value{k_initial, Quantity::owner, coordinate.name};
    const Slot rate = coordinate.speed ? Slot{k_initial, Quantity::owner, model.speeds[*coordinate.speed].name}
                                       : Slot{k_initial, Quantity::rate_of_owner, coordinate.name};
    visit_optional(coordinate.held_at, {k_held, Quantity::owner, coordinate.name}, visit);
    visit_optional(coordinate.initial, value, visit);
    visit_optional(coordinate.guess, value, visit);
    visit_optional(coordinate.initial_rate, rate, visit);
    visit_optional(coordinate.rate_guess, rate, visit);
  }
  for (const Orientation& orientation : model.orientations) {
    for (std::size_t i = 0; i < orientation.initial.size(); ++i) {
      visit(orientation.initial[i], {k_initial, Quantity::owner, orientation.quaternion[i]});
    }
    for (std::size_t i = 0; i < orientation.initial_angular_velocity.size(); ++i) {
      visit_optional(orientation.initial_angular_velocity[i],
                     {k_initial, Quantity::owner, orientation.angular_velocity[i]}, visit);
    }
  }
}

void visit_frames(const Model& model, const Visit& visit) {
  for (const Frame& frame : model.frames) {
    visit_all(frame.position, k_placement, visit);
    const auto* turns = std::get_if<Turns>(&frame.attitude);
    if (turns == nullptr) continue;
    for (const Turn& turn : *turns) {
      visit(turn.angle, k_angle);
      if (const auto* axis = std::get_if<std::array<Ast, 3>>(&turn.axis)) visit_all(*axis, k_axis, visit);
    }
  }
}

void visit_bodies(const Model& model, const Visit& visit) {
  for (const Body& body : model.bodies) {
    visit(body.mass, k_mass);
    visit_all(body.centre, k_centre, visit);
    if (body.inertia) visit_all(body.inertia->entries, k_inertia, visit);
  }
}

/// Where a body touches another one, and along what it slips there.
void visit_slip(const SlipLaw& law, const Visit& visit) {
  visit_all(law.direction, k_direction, visit);
  if (const auto* place = std::get_if<std::array<Ast, 3>>(&law.at)) visit_all(*place, k_point, visit);
}

void visit_constraint(const Constraint& constraint, const Visit& visit) {
  if (const auto* law = std::get_if<VelocityLaw>(&constraint.law)) visit(law->phi, k_velocity);
  if (const auto* law = std::get_if<PositionLaw>(&constraint.law)) {
    // An equation of the user may be in any unit; those of shorthands, such as a distance, are about lengths.
    visit(law->f, {k_equation, law->f.is_derived ? Quantity::length : Quantity::any});
  }
  if (const auto* law = std::get_if<SlipLaw>(&constraint.law)) visit_slip(*law, visit);
  if (constraint.point) visit_all(*constraint.point, k_point, visit);
  if (constraint.breaks_at) visit(*constraint.breaks_at, {k_strength, constraint});
}

void visit_friction(const Friction& friction, const Visit& visit) {
  const Ast* along = nullptr;
  for (const auto& slip : friction.slips) {
    if (const auto* law = std::get_if<VelocityLaw>(&slip)) {
      visit(law->phi, {k_slip, Quantity::speed_along, along});
      along = &law->phi;
    }
    if (const auto* law = std::get_if<SlipLaw>(&slip)) visit_slip(*law, visit);
  }
  visit(friction.limit, {k_limit, Quantity::force_along, along});
  if (friction.smooth) visit(*friction.smooth, {k_smooth, Quantity::speed_along, along});
}

void visit_force(const Force& force, const Visit& visit) {
  if (const auto* uniform = std::get_if<UniformField>(&force.law)) visit_all(uniform->field, k_field, visit);
  if (const auto* potential = std::get_if<Potential>(&force.law)) visit(potential->energy, k_potential);
  if (const auto* generalized = std::get_if<GeneralizedForce>(&force.law)) {
    for (const auto& [name, value] : generalized->components) {
      visit(value, {k_generalized, Quantity::force_on_owner, name});
    }
  }
  if (const auto* push = std::get_if<PointForce>(&force.law)) {
    visit_all(push->at, k_place_of_force, visit);
    visit_all(push->components, k_force, visit);
  }
  if (const auto* torque = std::get_if<Torque>(&force.law)) visit_all(torque->components, k_torque, visit);
  if (const auto* friction = std::get_if<Friction>(&force.law)) visit_friction(*friction, visit);
  if (const auto* spring = std::get_if<Spring>(&force.law)) {
    visit(spring->stiffness, {k_spring, Quantity::stiffness});
    if (spring->length) visit(*spring->length, {k_spring, Quantity::length});
    if (spring->damping) visit(*spring->damping, {k_spring, Quantity::damping});
  }
  if (const auto* spring = std::get_if<CoordinateSpring>(&force.law)) {
    visit(spring->stiffness, {k_spring, Quantity::stiffness_on_owner, spring->coordinate});
    if (spring->rest) visit(*spring->rest, {k_spring, Quantity::owner, spring->coordinate});
    if (spring->damping) visit(*spring->damping, {k_spring, Quantity::damping_on_owner, spring->coordinate});
  }
}

void visit_switches(const Model& model, const Visit& visit) {
  for (const Contact& contact : model.contacts) {
    visit(contact.gap, k_gap);
    if (contact.restitution) visit(*contact.restitution, k_restitution);
  }
  for (const DryFriction& friction : model.frictions) {
    visit_friction(friction.law, visit);
    const auto* const along = std::get_if<VelocityLaw>(&friction.law.slips.front());
    if (friction.static_limit)
      visit(*friction.static_limit, {k_limit, Quantity::force_along, along == nullptr ? nullptr : &along->phi});
  }
  for (const Guard& guard : model.guards) visit(guard.value, k_guard);
}

constexpr Place k_exact{"a closed form", "it says what the motion is at a time", "use t, parameters, numbers and pi",
                        true, true};

}  // namespace

const Place& parameter_place() { return k_parameter; }

const Place& input_place() { return k_input; }

const Place& inside_dot() { return k_dot; }

void for_each_expression(const Model& model, const std::function<void(const Ast&, const Place&)>& visit) {
  for_each_slot(model, [&](const Ast& ast, const Slot& slot) { visit(ast, slot.place); });
}

void for_each_expression_of(const Force& force, const std::function<void(const Ast&)>& visit) {
  visit_force(force, [&](const Ast& ast, const Slot&) { visit(ast); });
}

void for_each_expression_of_broken(const Model& model, const std::function<void(const Ast&)>& visit) {
  for (const Constraint& row : model.broken) visit_constraint(row, [&](const Ast& ast, const Slot&) { visit(ast); });
}

void for_each_slot(const Model& model, const Visit& visit) {
  for (const Parameter& parameter : model.parameters) {
    visit(parameter.value, {k_parameter, Quantity::owner, parameter.name});
  }
  for (const Input& input : model.inputs) visit(input.value, {k_input, Quantity::owner, input.name});
  for (const Table& table : model.tables) {
    visit_all(table.of, k_points, visit);
    visit_all(table.values, k_points, visit);
  }
  visit_motion(model, visit);
  visit_frames(model, visit);
  visit_bodies(model, visit);
  for (const Constraint& constraint : model.constraints) visit_constraint(constraint, visit);
  visit_switches(model, visit);
  for (const Force& force : model.forces) visit_force(force, visit);
  for (const NamedQuantity& quantity : model.quantities) visit_all(quantity.values, {k_quantity, quantity}, visit);
  for (const ClosedForm& form : model.exact)
    visit(form.value, {k_exact, form.is_rate ? Quantity::rate_of_owner : Quantity::owner, form.of});
}

}  // namespace gaussgen::model
