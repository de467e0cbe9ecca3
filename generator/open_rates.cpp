#include "open_rates.hpp"

#include <algorithm>

#include "generic_point.hpp"

namespace gaussgen {

namespace {

/// Where the search for each speed starts; 0 for those that are stated.
strategy::Vector guesses(Mechanics& mechanics) {
  kinematics::Expressions& expressions = mechanics.expressions;
  strategy::Vector result;
  const auto add = [&](const std::optional<model::Ast>& guess) {
    result.push_back(guess ? expressions(*guess) : expressions.number(0));
  };
  for (const model::Coordinate& coordinate : mechanics.model.coordinates) {
    if (!coordinate.held_at) add(coordinate.rate_guess);
  }
  for (const model::Orientation& orientation : mechanics.model.orientations) {
    for (const auto& guess : orientation.angular_velocity_guess) add(guess);
  }
  return result;
}

evaluate::Matrix columns_of(const evaluate::Matrix& matrix, const std::vector<std::size_t>& columns) {
  evaluate::Matrix result(matrix.rows(), columns.size(), matrix(0, 0));
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) result(i, j) = matrix(i, columns[j]);
  }
  return result;
}

bool has_entry(const evaluate::Matrix& matrix, std::size_t column) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    if (!cln::zerop(matrix(i, column))) return true;
  }
  return false;
}

/// Open speeds in the order of the state, each with its value and the way from its guess.
struct Open {
  std::vector<std::size_t> speeds;
  evaluate::Vector values;
  evaluate::Vector changes;
};

/// Those that a constraint acts on at this state, or that moved with them since a mass couples them. Empty where something is undefined.
Open involved_speeds(Mechanics& mechanics, const std::vector<InitialValue>& state, const evaluate::Matrix& b,
                     ModelValues& values) {
  const std::vector<bool> is_stated = stated_speeds(mechanics.model);
  const strategy::Vector guess = guesses(mechanics);
  const std::size_t first_speed = mechanics.symbols.configuration.size();
  Open open;
  for (std::size_t i = 0; i < b.columns(); ++i) {
    if (is_stated[i]) continue;
    const ir::Expr rate(mechanics.graph, state[first_speed + i].node);
    const auto value = values(rate.id());
    // No residual: a solution of linear equations has divisions in it, and of light parts before heavy ones nothing would seem to be left.
    const auto change = values((rate - guess[i]).id());
    if (!value || !change) return {};
    if (!has_entry(b, i) && cln::zerop(*change)) continue;
    open.speeds.push_back(i);
    open.values.push_back(*value);
    open.changes.push_back(*change);
  }
  return open;
}

}  // namespace

std::vector<bool> stated_speeds(const model::Model& model) {
  std::vector<bool> result;
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (!coordinate.held_at) result.push_back(coordinate.initial_rate.has_value());
  }
  for (const model::Orientation& orientation : model.orientations) {
    for (const auto& component : orientation.initial_angular_velocity) result.push_back(component.has_value());
  }
  return result;
}

// The null space of b over the open speeds is what the constraints leave; a speed has a part in it if its column depends on others.
OpenRates chosen_rates(Mechanics& mechanics, const std::vector<InitialValue>& state, ModelValues& values) {
  if (mechanics.dynamics.l() == 0 || mechanics.dynamics.n() == 0) return {};
  const auto b = values(mechanics.dynamics.b);
  if (!b) return {};
  const Open open = involved_speeds(mechanics, state, *b, values);
  if (open.speeds.empty()) return {};
  const evaluate::Matrix rows = columns_of(*b, open.speeds);
  OpenRates found;
  bool has_moved = false;
  for (const std::size_t column : dependent_columns(rows)) {
    const auto& speed = mechanics.symbols.speeds[kinematics::FreeIndex{open.speeds[column]}];
    has_moved = has_moved || !cln::zerop(open.changes[column]);
    found.rates.push_back({speed.name, speed.label, open.values[column]});
  }
  if (!has_moved) return {};
  found.freedom = open.speeds.size() - values.rank(rows);
  return found;
}

}  // namespace gaussgen
