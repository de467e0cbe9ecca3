// The values that are known before the motion starts: finite, and those of real bodies.

#include <fmt/format.h>

#include <cmath>

#include "model/attitude.hpp"
#include "model/checks.hpp"
#include "model/constant.hpp"
#include "model/constant_check.hpp"
#include "model/evaluate.hpp"
#include "model/expressions.hpp"
#include "model/impossible.hpp"
#include "model/quaternion_length.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

/// Nothing when it is unknown or not finite; the latter is reported.
std::optional<double> checked_value(const Ast& ast, const Values& values, Reading& reading) {
  const auto value = value_of(ast, values);
  if (!value || std::isfinite(*value)) return value;
  reading.diagnostics.error(
      code::k_not_finite, ast.span,
      fmt::format("with the given parameters this is {}", std::isnan(*value) ? "not a real number" : "infinite"),
      "change the values of the parameters in it");
  return std::nullopt;
}

/// Reports those that are not finite.
Values checked_parameters(Reading& reading) {
  Values values{{"pi", std::acos(-1.0)}};
  for (const Parameter& parameter : reading.model.parameters) {
    if (!check_constants(parameter.value, reading.diagnostics)) continue;
    if (const auto value = checked_value(parameter.value, values, reading)) values[parameter.name.text] = *value;
  }
  return values;
}

void check_expressions(const Values& values, Reading& reading) {
  for_each_expression(reading.model, [&](const Ast& ast, const Place& place) {
    if (&place == &parameter_place() || !check_constants(ast, reading.diagnostics)) return;
    const bool known_at_start = !place.time && !place.coordinates;
    if (known_at_start) checked_value(ast, values, reading);
  });
}

void check_bodies(const Values& values, Reading& reading) {
  for (const support::Diagnostic& found : impossible_bodies(reading.model, values)) {
    if (found.severity == support::Severity::error) {
      reading.diagnostics.error(found.code, found.span, found.message, found.hint);
    } else {
      reading.diagnostics.warning(found.code, found.span, found.message, found.hint);
    }
  }
}

void check_quaternion(const Orientation& orientation, const Values& values, Reading& reading) {
  const auto length = initial_length(orientation, values);
  if (!length) return;
  const support::Span span{orientation.initial[0].span.begin, orientation.initial[3].span.end};
  if (*length == 0) {
    reading.diagnostics.error(code::k_undefined_value, span,
                              fmt::format("the initial quaternion of '{}' has length zero", orientation.name.text),
                              "[1, 0, 0, 0] is no rotation");
  } else if (!is_length_of_rotation(*length)) {
    reading.diagnostics.warning(code::k_quaternion_length, span,
                                fmt::format("the initial quaternion of '{}' has length {:.4g} and is divided by it",
                                            orientation.name.text, *length),
                                "check its components: the squares of a rotation add up to 1");
  }
}

/// A vector of parameters that are zero; one of zeros is reported where it is read.
void check_direction(const std::array<Ast, 3>& direction, const Values& values, Reading& reading) {
  bool has_parameter = false;
  for (const Ast& component : direction) {
    const auto value = value_of(component, values);
    if (!value || *value != 0) return;
    has_parameter = has_parameter || component.kind != AstKind::number;
  }
  if (has_parameter) refuse_zero_axis({direction[0].span.begin, direction[2].span.end}, reading);
}

void check_directions(const Values& values, Reading& reading) {
  for (const Frame& frame : reading.model.frames) {
    const Turns* const turns = std::get_if<Turns>(&frame.attitude);
    for (std::size_t i = 0; turns != nullptr && i < turns->size(); ++i) {
      if (const auto* axis = std::get_if<std::array<Ast, 3>>(&(*turns)[i].axis))
        check_direction(*axis, values, reading);
    }
  }
  for (const Constraint& constraint : reading.model.constraints) {
    if (const auto* law = std::get_if<SlipLaw>(&constraint.law)) check_direction(law->direction, values, reading);
  }
}

/// The value of `is` in |P - Q| - is; nothing for other laws.
const Ast* length_in(const Constraint& constraint) {
  const auto* const law = std::get_if<PositionLaw>(&constraint.law);
  const bool is_distance = law != nullptr && law->f.is_derived && !law->is_coincidence;
  return is_distance ? &law->f.children[1].children[0] : nullptr;
}

void check_distance(const Ast& length, const Values& values, Reading& reading) {
  const auto exact = exact_value(length);
  const auto value = exact ? support::to_double(*exact) : value_of(length, values);
  if (!value || *value > 0 || !std::isfinite(*value)) return;
  const char* const at = exact ? "" : "with the given parameters, ";
  if (*value == 0) {
    reading.diagnostics.error(code::k_undefined_value, length.span,
                              fmt::format("{}places at distance 0 have no direction from one to the other", at),
                              "write coincide: [P, Q], which keeps them together");
  } else {
    reading.diagnostics.error(code::k_undefined_value, length.span,
                              fmt::format("{}this distance is {:.6g}, and none is negative", at, *value),
                              "a distance has no direction and so no sign: write its size");
  }
}

void check_distances(const Values& values, Reading& reading) {
  for (const Constraint& constraint : reading.model.constraints) {
    if (const Ast* const length = length_in(constraint)) check_distance(*length, values, reading);
  }
}

}  // namespace

void check_values(Reading& reading) {
  const Values values = checked_parameters(reading);
  check_expressions(values, reading);
  check_bodies(values, reading);
  check_directions(values, reading);
  check_distances(values, reading);
  for (const Orientation& orientation : reading.model.orientations) check_quaternion(orientation, values, reading);
}

}  // namespace gaussgen::model
