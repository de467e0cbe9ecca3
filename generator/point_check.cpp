#include "point_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

constexpr const char* k_output = "reaction_forces";

template <class List, class Key>
bool contains(const List& list, const Key& key) {
  return std::find(list.begin(), list.end(), key) != list.end();
}

bool is_wanted(const model::Model& model) {
  return model.outputs.empty() || std::any_of(model.outputs.begin(), model.outputs.end(),
                                              [](const model::Name& output) { return output.text == k_output; });
}

}  // namespace

std::vector<std::string> constraints_without_force(const Mechanics& mechanics) {
  return strategy::undetermined_wrenches(mechanics.dynamics, mechanics.solution, mechanics.held_reactions);
}

void check_points(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const model::Model& model = mechanics.model;
  const bool has_points = std::any_of(model.constraints.begin(), model.constraints.end(),
                                      [](const model::Constraint& constraint) { return constraint.point.has_value(); });
  if (!has_points || !is_wanted(model)) return;
  const std::vector<std::string> names = constraints_without_force(mechanics);
  for (const model::Constraint& constraint : model.constraints) {
    if (!constraint.point || !contains(names, constraint.name.text)) continue;
    const support::Span span{(*constraint.point)[0].span.begin, (*constraint.point)[2].span.end};
    diagnostics.warning(
        support::code::k_idle_point, span,
        fmt::format("the point of constraint '{}' is not used: the coordinates do not determine its force alone",
                    constraint.name.text),
        "describe every motion of the bodies that it acts on by coordinates, those that do not move by held ones");
  }
}

}  // namespace gaussgen
