#pragma once
// Every expression of a model with the place at which it stands. Outside of the folder, checks of later stages use it.

#include <functional>

#include "model/model.hpp"

namespace gaussgen::model {

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
};

/// The value of a parameter.
const Place& parameter_place();

/// The inside of dot(...).
const Place& inside_dot();

/// In the order of the model's members.
void for_each_expression(const Model& model, const std::function<void(const Ast&, const Place&)>& visit);

}  // namespace gaussgen::model
