#include "model/model.hpp"

#include <algorithm>

#include "support/assert.hpp"

namespace gaussgen::model {

SymbolRef Model::resolve(const std::string& symbol) const {
  const auto found = symbols.find(symbol);
  GAUSS_ASSERT(found != symbols.end(), "symbol={}", symbol);
  return found->second;
}

std::size_t Model::coordinate_of_speed(std::size_t speed) const {
  const auto owner = std::find_if(coordinates.begin(), coordinates.end(),
                                  [&](const Coordinate& coordinate) { return coordinate.speed == speed; });
  GAUSS_ASSERT(owner != coordinates.end(), "speed {}", speed);
  return static_cast<std::size_t>(owner - coordinates.begin());
}

std::string name_in_file(const Constraint& row) {
  return row.may_vanish ? row.name.text.substr(0, row.name.text.size() - 2) : row.name.text;
}

std::size_t pushed_by_force_on(const Model& model, std::size_t frame) {
  const auto carries_body = [&](std::size_t at) {
    return std::any_of(model.bodies.begin(), model.bodies.end(), [&](const Body& body) { return body.frame == at; });
  };
  while (frame != k_space && model.frames[frame].is_point && !carries_body(frame)) frame = model.frames[frame].parent;
  return frame;
}

bool has_reactions_in_forces(const Model& model) {
  return std::any_of(model.reactions.begin(), model.reactions.end(),
                     [](const NamedReaction& one) { return one.is_in_force; });
}

bool has_units(const Model& model) {
  const auto states_unit = [](const auto& entry) { return !entry.unit.empty(); };
  const auto any = [&](const auto& list) { return std::any_of(list.begin(), list.end(), states_unit); };
  return any(model.parameters) || any(model.inputs) || any(model.tables) || any(model.quantities) ||
         std::any_of(model.tables.begin(), model.tables.end(),
                     [](const Table& table) { return !table.of_unit.empty(); }) ||
         std::any_of(model.coordinates.begin(), model.coordinates.end(),
                     [&](const Coordinate& coordinate) { return states_unit(coordinate) && !coordinate.is_of_joint; });
}

}  // namespace gaussgen::model
