#include "strategy/projection.hpp"

#include <algorithm>

#include "strategy/velocity_projection.hpp"

namespace gaussgen::strategy {

using ir::Expr;

Vector completed_accelerations(const Dynamics& dynamics, Vector accelerations, const std::vector<std::size_t>& open,
                               Expr epsilon, Steps& steps) {
  VelocityProblem at{dynamics.b_drift, dynamics.b, {}};
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    for (std::size_t i = 0; i < dynamics.n(); ++i) at.phi[mu] += dynamics.b[mu][i] * accelerations[i];
  }
  VelocityProjection projection(dynamics, open, epsilon);
  projection.step(at, projection.movable(at), "", accelerations, steps);
  return accelerations;
}

namespace {

void add_speed(const std::optional<model::Ast>& value, const std::optional<model::Ast>& guess,
               kinematics::Expressions& expressions, GivenState& given) {
  if (!value) given.open.push_back(given.speeds.size());
  given.speeds.push_back(value ? expressions(*value) : (guess ? expressions(*guess) : expressions.number(0)));
}

}  // namespace

GivenState given_state(const model::Model& model, kinematics::Expressions& expressions) {
  GivenState given;
  // A speed moves all of them.
  const bool are_open = std::none_of(model.coordinates.begin(), model.coordinates.end(),
                                     [](const auto& coordinate) { return coordinate.speed && coordinate.initial; });
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    given.configuration.push_back(expressions(coordinate.start()));
    const bool is_open = coordinate.speed ? are_open : !coordinate.initial;
    if (is_open) given.open_positions.push_back(given.speeds.size());
    add_speed(coordinate.initial_rate, coordinate.rate_guess, expressions, given);
  }
  for (const model::Orientation& orientation : model.orientations) {
    for (const model::Ast& component : orientation.initial) given.configuration.push_back(expressions(component));
    for (std::size_t i = 0; i < 3; ++i) {
      if (orientation.is_open) given.open_positions.push_back(given.speeds.size());
      add_speed(orientation.initial_angular_velocity[i], orientation.angular_velocity_guess[i], expressions, given);
    }
  }
  return given;
}

Vector guessed_state(const model::Model& model, kinematics::Expressions& expressions) {
  GivenState given = given_state(model, expressions);
  given.configuration.insert(given.configuration.end(), given.speeds.begin(), given.speeds.end());
  return given.configuration;
}

namespace {

std::vector<bool> marked(const std::vector<std::size_t>& indices, std::size_t count) {
  std::vector<bool> result(count, false);
  for (const std::size_t i : indices) result[i] = true;
  return result;
}

}  // namespace

std::vector<bool> open_positions(const model::Model& model, kinematics::Expressions& expressions) {
  const GivenState given = given_state(model, expressions);
  return marked(given.open_positions, given.speeds.size());
}

std::vector<bool> open_speeds(const model::Model& model, kinematics::Expressions& expressions) {
  const GivenState given = given_state(model, expressions);
  return marked(given.open, given.speeds.size());
}

}  // namespace gaussgen::strategy
