#include "strategy/projection.hpp"

#include <algorithm>
#include <numeric>

#include "ir/rounded.hpp"
#include "strategy/accelerations.hpp"
#include "strategy/inner.hpp"
#include "strategy/position_projection.hpp"
#include "strategy/quaternions.hpp"
#include "strategy/state_values.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

namespace {

/// φ, b and g at one state; or b a + its drift, for accelerations.
struct VelocityProblem {
  Vector phi;
  Matrix b;
  Matrix g;
};

Vector restricted(const Vector& row, const std::vector<std::size_t>& to) {
  Vector result;
  for (const std::size_t i : to) result.push_back(row[i]);
  return result;
}

/// Newton steps on φ(u) = 0 over some of the speeds: each is the least δu in the metric g with b δu + φ = 0, which is the
/// problem that Gauss's principle poses for accelerations, without forces.
class VelocityProjection {
 public:
  VelocityProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, Expr epsilon)
      : dynamics_(dynamics),
        moving_(std::move(moving)),
        dependent_rows_(dependent_rows_over(dynamics, moving_)),
        epsilon_(epsilon),
        singular_(never()),
        dependent_(never()) {}

  /// Changes `speeds` by one step at `at`.
  void step(const VelocityProblem& at, const std::string& prefix, Vector& speeds, Steps& steps) {
    const Dynamics problem = problem_of_change(at, prefix);
    if (problem.l() == 0) return;
    Steps inner_steps;
    const Solution change = solve_with_multipliers(problem, epsilon_, inner_steps);
    steps.begin("smallest change of the speeds in the mass metric that satisfies the constraints");
    for (const Step& inner_step : inner_steps.all()) steps.append(inner_step.values);
    for (std::size_t j = 0; j < moving_.size(); ++j) {
      Expr& speed = speeds[moving_[j]];
      speed = steps.name(rounded(speed + change.accelerations[j]), prefix + dynamics_.labels[moving_[j]] + "_rate");
    }
    singular_ = any(graph(), {singular_, change.singular_mass_matrix});
    dependent_ = any(graph(), {dependent_, change.dependent_constraints, lost(at)});
  }

  // One step satisfies a linear constraint exactly, unless none of its speeds is free to move.
  std::vector<std::size_t> to_be_checked(const VelocityProblem& at) const {
    std::vector<std::size_t> rows;
    for (const ConstraintIndex mu : dynamics_.kinematics->constraints.indices()) {
      if (!dynamics_.kinematics->constraints[mu].is_linear || !can_move(at, mu.value)) rows.push_back(mu.value);
    }
    return rows;
  }

  Expr singular() const { return singular_; }
  Expr dependent() const { return dependent_; }

 private:
  // Whether a constraint says something of given speeds alone here, and of those that may move only what rounding has left. The 1000
  // covers what sums of products lose; squares, since a row has no sign.
  Expr lost(const VelocityProblem& at) const {
    std::vector<Expr> conditions;
    for (std::size_t mu = 0; mu < at.b.size(); ++mu) {
      if (!can_move(at, mu)) continue;
      const Expr all = inner(graph(), at.b[mu], at.b[mu]);
      const Vector moving = restricted(at.b[mu], moving_);
      const Expr of_moving = inner(graph(), moving, moving);
      if (!(of_moving == all))
        conditions.push_back(less(of_moving, support::Rational(1'000'000) * pow(epsilon_, 2) * all));
    }
    return any(graph(), conditions);
  }

  bool can_move(const VelocityProblem& at, std::size_t mu) const {
    return std::any_of(moving_.begin(), moving_.end(), [&](std::size_t i) { return !at.b[mu][i].is_zero(); });
  }

  ir::Graph& graph() const { return epsilon_.graph(); }
  Expr never() const { return {graph(), graph().constant(0)}; }

  Dynamics problem_of_change(const VelocityProblem& at, const std::string& prefix) const {
    Dynamics problem;
    problem.names = {prefix, "change", "impulse"};
    problem.dependent_rows = dependent_rows_;
    for (const std::size_t i : moving_) {
      problem.labels.push_back(dynamics_.labels[i]);
      problem.f.push_back(never());
      problem.g.push_back(restricted(at.g[i], moving_));
    }
    for (std::size_t mu = 0; mu < at.b.size(); ++mu) {
      if (!can_move(at, mu)) continue;
      problem.constraints.push_back(dynamics_.constraints[mu]);
      problem.b.push_back(restricted(at.b[mu], moving_));
      problem.b_drift.push_back(at.phi[mu]);
    }
    return problem;
  }

  const Dynamics& dynamics_;
  std::vector<std::size_t> moving_;
  DependentRows dependent_rows_;
  Expr epsilon_;
  Expr singular_;
  Expr dependent_;
};

// φ against the terms of its linear part, with half of the digits: where Newton's method has converged nothing is left but
// rounding, and where it has not, φ is large. Squares, since a condition has no sign.
Expr violated(const VelocityProblem& at, const Vector& speeds, const std::vector<std::size_t>& rows, Expr epsilon) {
  std::vector<Expr> conditions;
  for (const std::size_t mu : rows) {
    Expr scale(epsilon.graph(), epsilon.graph().constant(0));
    for (std::size_t j = 0; j < speeds.size(); ++j) scale += pow(at.b[mu][j] * speeds[j], 2);
    conditions.push_back(less(epsilon * scale, pow(at.phi[mu], 2)));
  }
  return any(epsilon.graph(), conditions);
}

VelocityProblem at(const Dynamics& dynamics, ir::Substitution& put_in) {
  VelocityProblem problem;
  for (const auto& row : dynamics.kinematics->constraints) problem.phi.push_back(without_rounding(put_in(row.phi)));
  for (const Vector& row : dynamics.b) {
    problem.b.emplace_back();
    for (const Expr e : row) problem.b.back().push_back(put_in(e));
  }
  for (const Vector& row : dynamics.g) {
    problem.g.emplace_back();
    for (const Expr e : row) problem.g.back().push_back(put_in(e));
  }
  return problem;
}

// Each quaternion (four components in a row) divided by its norm. Boolean: some norm has no digits to divide by.
Expr normalise_quaternions(const kinematics::Symbols& symbols, Vector& configuration, ir::Graph& graph, Steps& steps) {
  if (!symbols.first_quaternion_component.empty()) steps.begin("quaternions to unit length");
  const Vector norms = squared_norms(symbols, configuration);
  for (std::size_t k = 0; k < norms.size(); ++k) {
    const std::size_t first = symbols.first_quaternion_component[k].value;
    const Expr scale = steps.name(pow(norms[k], support::Rational(-1) / 2), "unit");
    for (std::size_t i = 0; i < 4; ++i) configuration[first + i] = configuration[first + i] * scale;
  }
  return is_beyond_scaling(graph, norms);
}

bool all_linear(const Dynamics& dynamics) {
  const auto& rows = dynamics.kinematics->constraints;
  return std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.is_linear; });
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// The problem at the state reached so far.
VelocityProblem at_state(const Dynamics& dynamics, const std::optional<Expr>& time, const Vector& configuration,
                         const Vector& speeds) {
  ir::Substitution put_in = state_values(dynamics.kinematics->symbols, time, configuration, speeds);
  return at(dynamics, put_in);
}

/// Newton's method on the velocity constraints: one step where all are linear, `most_steps` otherwise.
class Newton {
 public:
  Newton(const Dynamics& dynamics, const std::optional<Expr>& time, Expr epsilon)
      : dynamics_(dynamics), time_(time), epsilon_(epsilon) {}

  /// Changes the speeds in `moving`. The state says itself whether the constraints hold then.
  ProjectedState run(const Vector& configuration, Vector speeds, const std::vector<std::size_t>& moving, int most_steps,
                     Steps& steps) const {
    VelocityProjection projection(dynamics_, moving, epsilon_);
    Expr is_violated(epsilon_.graph(), epsilon_.graph().constant(0));
    if (dynamics_.l() != 0) {
      const int count = all_linear(dynamics_) ? 1 : most_steps;
      for (int step = 0; step < count; ++step) {
        const std::string prefix = count == 1 ? "" : "step" + std::to_string(step + 1) + "_";
        projection.step(at_state(dynamics_, time_, configuration, speeds), prefix, speeds, steps);
      }
      const VelocityProblem reached = at_state(dynamics_, time_, configuration, speeds);
      is_violated = violated(reached, speeds, projection.to_be_checked(reached), epsilon_);
    }
    return {configuration, speeds, projection.singular(), projection.dependent(), is_violated};
  }

 private:
  const Dynamics& dynamics_;
  std::optional<Expr> time_;
  Expr epsilon_;
};

}  // namespace

namespace {

/// Positions first: the velocity constraints are taken where the configuration has arrived.
ProjectedState projected(PositionProjection& positions, const Newton& velocities, Vector configuration,
                         const Vector& speeds, const std::vector<std::size_t>& moving, int most_steps, Steps& steps) {
  const Vector start = configuration;
  if (positions.has_rows()) positions.run(most_steps, configuration, steps);
  ProjectedState state = velocities.run(configuration, speeds, moving, most_steps, steps);
  if (!positions.has_rows()) return state;
  ir::Graph& graph = speeds[0].graph();
  state.singular_mass_matrix = any(graph, {positions.singular(), state.singular_mass_matrix});
  state.dependent_constraints = any(graph, {positions.dependent(), state.dependent_constraints});
  state.violated_constraints = any(graph, {positions.violated(start, configuration), state.violated_constraints});
  return state;
}

Vector configuration_symbols(const kinematics::Symbols& symbols, ir::Graph& graph) {
  Vector result;
  for (const auto& q : symbols.configuration) result.emplace_back(graph, graph.use(q.symbol));
  return result;
}

Vector speed_symbols(const kinematics::Symbols& symbols, ir::Graph& graph) {
  Vector result;
  for (const auto& u : symbols.speeds) result.emplace_back(graph, graph.use(u.symbol));
  return result;
}

}  // namespace

ProjectedState project(const Dynamics& dynamics, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  Vector configuration = configuration_symbols(symbols, graph);
  const Vector speeds = speed_symbols(symbols, graph);
  const Expr is_lost = normalise_quaternions(symbols, configuration, graph, steps);
  const std::vector<std::size_t> all = first(dynamics.n());
  PositionProjection positions(dynamics, all, std::nullopt, epsilon);
  // From what one step of an integrator leaves, a second step arrives at rounding.
  ProjectedState state =
      projected(positions, Newton(dynamics, std::nullopt, epsilon), configuration, speeds, all, 2, steps);
  state.violated_constraints = any(graph, {is_lost, state.violated_constraints});
  return state;
}

Vector completed_accelerations(const Dynamics& dynamics, Vector accelerations, const std::vector<std::size_t>& open,
                               Expr epsilon, Steps& steps) {
  VelocityProblem at{dynamics.b_drift, dynamics.b, dynamics.g};
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    for (std::size_t i = 0; i < dynamics.n(); ++i) at.phi[mu] += dynamics.b[mu][i] * accelerations[i];
  }
  VelocityProjection(dynamics, open, epsilon).step(at, "", accelerations, steps);
  return accelerations;
}

namespace {

/// Values that the model gives, and which speeds it leaves to the constraints.
struct Given {
  Vector configuration;
  Vector speeds;
  std::vector<std::size_t> open;
  std::vector<std::size_t> open_positions;  ///< speeds along which the configuration may still change
};

void add_speed(const std::optional<model::Ast>& value, const std::optional<model::Ast>& guess,
               kinematics::Expressions& expressions, Given& given) {
  if (!value) given.open.push_back(given.speeds.size());
  given.speeds.push_back(value ? expressions(*value) : (guess ? expressions(*guess) : expressions.number(0)));
}

Given given_state(const model::Model& model, kinematics::Expressions& expressions) {
  Given given;
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

}  // namespace

Vector guessed_state(const model::Model& model, kinematics::Expressions& expressions) {
  Given given = given_state(model, expressions);
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
  const Given given = given_state(model, expressions);
  return marked(given.open_positions, given.speeds.size());
}

std::vector<bool> open_speeds(const model::Model& model, kinematics::Expressions& expressions) {
  const Given given = given_state(model, expressions);
  return marked(given.open, given.speeds.size());
}

ProjectedState initial_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                             Expr time, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  Given given = given_state(model, expressions);
  const Expr is_lost = normalise_quaternions(symbols, given.configuration, graph, steps);
  PositionProjection positions(dynamics, given.open_positions, time, epsilon);
  ProjectedState state = projected(positions, Newton(dynamics, time, epsilon), given.configuration, given.speeds,
                                   given.open, k_steps_to_start, steps);
  state.violated_constraints = any(graph, {is_lost, state.violated_constraints});
  return state;
}

ProjectedState refined_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                             Expr time, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  const Given given = given_state(model, expressions);
  PositionProjection positions(dynamics, given.open_positions, time, epsilon);
  return projected(positions, Newton(dynamics, time, epsilon), configuration_symbols(symbols, graph),
                   speed_symbols(symbols, graph), given.open, 1, steps);
}

}  // namespace gaussgen::strategy
