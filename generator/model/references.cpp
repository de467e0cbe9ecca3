// Names that stand for a speed outside expressions.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/checks.hpp"
#include "model/fields.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

bool is_speed(SymbolKind kind) {
  return kind == SymbolKind::coordinate || kind == SymbolKind::angular_velocity || kind == SymbolKind::speed;
}

std::vector<std::string> speeds_of(const Model& model) {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : model.symbols) {
    if (is_speed(symbol.kind)) names.push_back(name);
  }
  return names;
}

std::vector<std::string> coordinates_of(const Model& model) {
  std::vector<std::string> names;
  for (const Coordinate& coordinate : model.coordinates) names.push_back(coordinate.name.text);
  return names;
}

/// Of what is reported already.
bool may_be_any(const Name& name, const Reading& reading) {
  const bool is_known = reading.model.symbols.count(name.text) > 0;
  return !is_known && (reading.unread.may_declare(name.text) || reading.refused.count(name.text) > 0);
}

bool check_speed(const Name& name, const std::string& what, Reading& reading) {
  const auto symbol = reading.model.symbols.find(name.text);
  if (symbol != reading.model.symbols.end() && is_speed(symbol->second.kind)) return true;
  if (may_be_any(name, reading)) return false;
  const std::string near = did_you_mean_one_of(
      name, [&] { return speeds_of(reading.model); }, reading);
  reading.diagnostics.error(
      code::k_wrong_reference, name.span,
      fmt::format("'{}' is not a coordinate or an angular velocity component, which {} needs", name.text, what),
      near.empty() ? "use a name from 'coordinates', or an angular velocity from 'orientations'" : near);
  return false;
}

void check_coordinate(const Name& name, Reading& reading) {
  const auto symbol = reading.model.symbols.find(name.text);
  if (symbol != reading.model.symbols.end() && symbol->second.kind == SymbolKind::coordinate) return;
  if (may_be_any(name, reading)) return;
  const std::string near = did_you_mean_one_of(
      name, [&] { return coordinates_of(reading.model); }, reading);
  reading.diagnostics.error(code::k_wrong_reference, name.span, fmt::format("there is no coordinate '{}'", name.text),
                            near.empty() ? "a spring acts along a coordinate, or between two places: [P, Q]" : near);
}

bool is_held(const std::string& name, const Model& model) {
  const SymbolRef symbol = model.resolve(name);
  return symbol.kind == SymbolKind::coordinate && model.coordinates[symbol.index].held_at.has_value();
}

void check_dependent(Reading& reading) {
  std::set<std::string> seen;
  for (const Name& name : reading.model.dependent) {
    if (!check_speed(name, "'dependent'", reading)) continue;
    if (is_held(name.text, reading.model)) {
      reading.diagnostics.error(code::k_dependent_speeds, name.span,
                                fmt::format("'{}' is held: its speed is given, no constraint determines it", name.text),
                                "name a free coordinate");
    } else if (!seen.insert(name.text).second) {
      reading.diagnostics.error(code::k_dependent_speeds, name.span, fmt::format("'{}' is named twice", name.text),
                                "remove one");
    }
  }
}

void check_dependent_count(Reading& reading) {
  const auto& dependent = reading.model.dependent;
  const std::size_t constraints = reading.model.constraints.size();
  // How many of the directions of a contact say something is known later.
  const auto& rows = reading.model.constraints;
  if (std::any_of(rows.begin(), rows.end(), [](const Constraint& row) { return row.may_vanish; })) return;
  if (dependent.empty() || dependent.size() == constraints || reading.unread.any()) return;
  reading.diagnostics.error(
      code::k_dependent_speeds, {dependent.front().span.begin, dependent.back().span.end},
      fmt::format("the number of dependent speeds is {}, that of constraints {}", dependent.size(), constraints),
      "each constraint determines one speed; without 'elimination' the choice is made for you");
}

std::vector<std::string> parameters_of(const Model& model) {
  std::vector<std::string> names;
  for (const Parameter& parameter : model.parameters) names.push_back(parameter.name.text);
  return names;
}

void check_sensitivity(const Name& name, Reading& reading) {
  const auto symbol = reading.model.symbols.find(name.text);
  if (symbol != reading.model.symbols.end() && symbol->second.kind == SymbolKind::parameter) {
    if (!reading.model.parameters[symbol->second.index].is_formula) return;
    reading.diagnostics.error(code::k_wrong_reference, name.span,
                              fmt::format("'{}' follows from other parameters by its formula", name.text),
                              "name those: what follows from them counts");
    return;
  }
  if (may_be_any(name, reading)) return;
  const std::string near = did_you_mean_one_of(
      name, [&] { return parameters_of(reading.model); }, reading);
  reading.diagnostics.error(code::k_wrong_reference, name.span, fmt::format("there is no parameter '{}'", name.text),
                            near.empty() ? "'sensitivities' are derivatives by parameters" : near);
}

}  // namespace

void check_references(Reading& reading) {
  for (const Force& force : reading.model.forces) {
    if (const auto* spring = std::get_if<CoordinateSpring>(&force.law)) check_coordinate(spring->coordinate, reading);
    const auto* generalized = std::get_if<GeneralizedForce>(&force.law);
    if (generalized == nullptr) continue;
    for (const auto& component : generalized->components) check_speed(component.first, "'generalized'", reading);
  }
  check_dependent(reading);
  check_dependent_count(reading);
}

void check_sensitivities(Reading& reading) {
  std::set<std::string> seen;
  for (const Name& name : reading.model.sensitivities) {
    if (seen.insert(name.text).second) {
      check_sensitivity(name, reading);
    } else {
      reading.diagnostics.error(code::k_wrong_reference, name.span, fmt::format("'{}' is named twice", name.text),
                                "remove one");
    }
  }
}

}  // namespace gaussgen::model
