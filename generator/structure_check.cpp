#include "structure_check.hpp"

#include <fmt/format.h>

#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

/// Where the model declares what the speed is called after.
support::Span span_of_speed(const model::Model& model, const std::string& label) {
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.name.text == label) return coordinate.name.span;
  }
  for (const model::Orientation& orientation : model.orientations) {
    for (const model::Name& name : orientation.angular_velocity) {
      if (name.text == label) return name.span;
    }
  }
  return model.name.span;
}

}  // namespace

void check_structure(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const model::Model& model = mechanics.model;
  for (const std::string& label : mechanics.solution.undetermined) {
    diagnostics.error(support::code::k_no_inertia, span_of_speed(model, label),
                      fmt::format("nothing determines the acceleration of '{}': the mass matrix is singular in every configuration", label),
                      "give what it moves a mass, or remove a coordinate that others already describe");
  }
  for (const std::string& name : mechanics.solution.redundant) {
    for (const model::VelocityConstraint& constraint : model.constraints) {
      if (constraint.name.text != name) continue;
      diagnostics.warning(support::code::k_redundant_constraint, constraint.name.span,
                          fmt::format("constraint '{}' follows from the others: its multiplier is returned as 0", name),
                          "accelerations are right if the constraints agree; status says dependent_constraints");
    }
  }
}

}  // namespace gaussgen
