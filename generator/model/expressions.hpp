#pragma once
// Every expression of a model with the place at which it stands. Outside of the folder, checks of later stages use it.

#include <functional>

#include "model/model.hpp"

namespace gaussgen::model {

/// What an expression has to be measured in.
enum class Quantity {
  any,
  number,
  stated,  ///< the unit that stands beside the value
  angle,
  length,
  mass,
  inertia,
  acceleration,
  energy,
  force,
  torque,
  stiffness,
  damping,
  owner,           ///< the unit of the symbol that the value belongs to
  rate_of_owner,   ///< per second
  force_on_owner,  ///< what times a change of the symbol makes work
  stiffness_on_owner,
  damping_on_owner,
  force_along,  ///< power over that of the velocity beside it
  speed_along,  ///< as the velocity beside it
  multiplier,   ///< of the constraint beside it
};

/// Whether reactions may stand at a place.
enum class Reactions {
  none,
  linear,  ///< in forces, from which they follow
  any,
  guards,  ///< likewise, by the program itself
};

/// What a place allows besides numbers and `pi`, and what to tell a user who wants more.
struct Place {
  const char* name;  ///< "the mass of a body"
  const char* why;   ///< the reason for the limits
  const char* hint;
  bool parameters = true;
  bool time = false;
  bool coordinates = false;  ///< quaternion components too
  bool speeds = false;       ///< dot(...) and angular velocities
  bool inputs = false;
  const char* hint_for_coordinate = nullptr;  ///< instead of `hint`
  bool places = false;                        ///< `tip.x`
  bool defines_speeds = false;                ///< rates are allowed, speeds are not yet
  int derivatives = 0;                        ///< by coordinates, speeds or time, that are taken of what stands here
  Quantity quantity = Quantity::any;
  Reactions reactions = Reactions::none;
};

/// A place with what differs between the expressions that stand at places of its kind.
struct Slot {
  // Implicit: most places say it all.
  Slot(const Place& of) : place(of), quantity(of.quantity) {}
  Slot(const Place& of, Quantity wanted) : place(of), quantity(wanted) {}
  Slot(const Place& of, Quantity wanted, const Name& symbol) : place(of), quantity(wanted), owner(&symbol) {}
  Slot(const Place& of, const NamedQuantity& beside)
      : place(of), quantity(Quantity::stated), owner(&beside.name), stated(&beside) {}
  Slot(const Place& of, Quantity wanted, const Ast* velocity) : place(of), quantity(wanted), along(velocity) {}

  Slot(const Place& of, const Constraint& beside) : place(of), quantity(Quantity::multiplier), row(&beside) {}

  const Place& place;
  Quantity quantity;
  const Name* owner = nullptr;            ///< the declared name that the value belongs to
  const NamedQuantity* stated = nullptr;  ///< of Quantity::stated
  const Ast* along = nullptr;             ///< of Quantity::force_along, speed_along; null: m/s
  const Constraint* row = nullptr;        ///< of Quantity::multiplier
};

/// The value of a parameter.
const Place& parameter_place();

/// The default of an input.
const Place& input_place();

/// The inside of dot(...).
const Place& inside_dot();

/// In the order of the model's members.
void for_each_slot(const Model& model, const std::function<void(const Ast&, const Slot&)>& visit);

/// The same for who asks nothing about units.
void for_each_expression(const Model& model, const std::function<void(const Ast&, const Place&)>& visit);

/// Of one force.
void for_each_expression_of(const Force& force, const std::function<void(const Ast&)>& visit);

/// Of rows that are broken in the regime that was read, and no part of the model.
void for_each_expression_of_broken(const Model& model, const std::function<void(const Ast&)>& visit);

}  // namespace gaussgen::model
