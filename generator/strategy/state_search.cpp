#include "strategy/state_search.hpp"

#include <algorithm>
#include <numeric>

#include "ir/rounded.hpp"
#include "strategy/bounds.hpp"
#include "strategy/position_projection.hpp"
#include "strategy/position_size.hpp"
#include "strategy/projection.hpp"
#include "strategy/quaternions.hpp"
#include "strategy/state_values.hpp"
#include "strategy/velocity_projection.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using Kind = SearchStage::Kind;

namespace {

/// Up to this number of speeds what numbers of a model make of the metric may vanish, and one step is short: it is taken over
/// the given values themselves.
constexpr std::size_t k_few_speeds = 6;

/// From what one step of an integrator leaves, the second arrives at rounding; six also do from what a hand leaves that sets a linkage, a
/// tenth of a radian off (tests/headers/test_project_reach.cpp).
constexpr int k_steps_of_projection = 6;

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

/// Expressions at a state that is put in.
VelocityProblem put_in(const Dynamics& dynamics, ir::Substitution& state, bool with_metric) {
  VelocityProblem problem;
  for (const auto& row : dynamics.kinematics->constraints) problem.phi.push_back(ir::without_rounding(state(row.phi)));
  const auto at_state = [&](const Matrix& rows) {
    Matrix values;
    for (const Vector& row : rows) {
      values.emplace_back();
      for (const Expr e : row) values.back().push_back(state(e));
    }
    return values;
  };
  problem.b = at_state(dynamics.b);
  if (with_metric) problem.g = at_state(dynamics.g);
  return problem;
}

Vector symbols_of_configuration(const kinematics::Symbols& symbols, ir::Graph& graph) {
  Vector result;
  for (const auto& q : symbols.configuration) result.emplace_back(graph, graph.use(q.symbol));
  return result;
}

Vector symbols_of_speeds(const kinematics::Symbols& symbols, ir::Graph& graph) {
  Vector result;
  for (const auto& u : symbols.speeds) result.emplace_back(graph, graph.use(u.symbol));
  return result;
}

/// Makes the stages for the speeds and positions that may move.
class Stages {
 public:
  Stages(const Dynamics& dynamics, const GivenState& given, bool opens, Expr epsilon)
      : dynamics_(dynamics),
        symbols_(dynamics.kinematics->symbols),
        graph_(epsilon.graph()),
        epsilon_(epsilon),
        given_(given),
        opens_(opens),
        is_lost_(normalise_quaternions(symbols_, given_.configuration, graph_, begin_)),
        positions_(dynamics, given.open_positions, settled(), epsilon) {}

  /// From values, which are over parameters or symbols: one stage where it is enough.
  StateSearch run(const Vector& start, const std::optional<Expr>& time, int most_steps) {
    Steps steps = begin_;
    ProjectedState begun{given_.configuration, given_.speeds, never(), never(), is_lost_};
    const bool is_here = given_.configuration == symbols_of_configuration(symbols_, graph_) &&
                         given_.speeds == symbols_of_speeds(symbols_, graph_);
    const bool is_short =
        dynamics_.n() <= k_few_speeds && !dynamics_.kinematics->has_positions() && all_linear(dynamics_);
    StateSearch search;
    if (dynamics_.l() == 0 || is_short) {
      std::optional<OpenStep> open;
      if (dynamics_.l() != 0) open = step_over_values(time, begun, steps);
      if (!opens_) open.reset();
      search.stages.push_back({Kind::begin, 1, begun, steps, open});
      return search;
    }
    if (!is_here) search.stages.push_back({Kind::begin, 1, begun, steps});
    find_movable(time);
    if (positions_.can_move()) search.stages.push_back(step_of_positions(most_steps));
    search.stages.push_back(step_of_speeds(all_linear(dynamics_) ? 1 : most_steps));
    check(start.empty() ? given_.configuration : start, search);
    if (positions_.has_rows()) search.start = start;
    return search;
  }

  /// For numbers beside `run`: the same steps.
  std::vector<ProjectedState> steps() {
    std::vector<ProjectedState> result;
    if (dynamics_.l() == 0) return result;
    find_movable(std::nullopt);
    if (positions_.can_move()) result.push_back(step_of_positions(1).state);
    result.push_back(step_of_speeds(1).state);
    return result;
  }

 private:
  Expr never() const { return {graph_, graph_.constant(0)}; }

  VelocityProblem here() const {
    VelocityProblem problem;
    for (const auto& row : dynamics_.kinematics->constraints) problem.phi.push_back(row.phi);
    problem.b = dynamics_.b;
    return problem;
  }

  /// The configuration as far as it is given and stays so, with symbols for the rest.
  Vector settled() const {
    Vector result = symbols_of_configuration(symbols_, graph_);
    std::vector<bool> stays(symbols_.speeds.size(), true);
    for (const std::size_t i : given_.open_positions) stays[i] = false;
    // A speed that takes the place of a rate moves any of the coordinates.
    const bool all_stay = given_.open_positions.empty();
    for (std::size_t i = 0; i < symbols_.plain_count(); ++i) {
      const bool has_rate = !symbols_.speeds[kinematics::FreeIndex{i}].replaces_rate;
      if (has_rate ? stays[i] : all_stay) result[i] = given_.configuration[i];
    }
    for (std::size_t k = 0; k < symbols_.first_angular_velocity.size(); ++k) {
      const std::size_t u = symbols_.first_angular_velocity[k].value;
      const std::size_t e = symbols_.first_quaternion_component[k].value;
      for (std::size_t i = 0; i < 4 && stays[u] && stays[u + 1] && stays[u + 2]; ++i)
        result[e + i] = given_.configuration[e + i];
    }
    return result;
  }

  /// What is zero by the given numbers says nothing, whatever rounding makes of it later: a wheel that stands across, at the height
  /// of its axle.
  void find_movable(const std::optional<Expr>& time) {
    ir::Substitution state =
        state_values(symbols_, time, positions_.can_move() ? settled() : given_.configuration, given_.speeds);
    movable_ = VelocityProjection(dynamics_, given_.open, epsilon_).movable(put_in(dynamics_, state, false));
  }

  OpenStep step_over_values(const std::optional<Expr>& time, ProjectedState& at, Steps& steps) {
    ir::Substitution state = state_values(symbols_, time, at.configuration, at.speeds);
    const VelocityProblem problem = put_in(dynamics_, state, true);
    VelocityProjection projection(dynamics_, given_.open, epsilon_);
    const std::vector<std::size_t> movable = projection.movable(problem);
    OpenStep open{{}, {}, {}, at};
    if (opens_) {
      open = open_step(*problem.g, problem.b, problem.phi, movable, given_.open);
      open.state = at;
      add_change(given_.open, open.state.speeds);
    }
    projection.step(problem, movable, "", at.speeds, steps);
    at.singular_mass_matrix = projection.singular();
    at.dependent_constraints = projection.dependent();
    for (ProjectedState* reached : {&at, &open.state}) {
      ir::Substitution after = state_values(symbols_, time, reached->configuration, reached->speeds);
      const bool is_general = reached != &at;
      const std::vector<std::size_t> rows = is_general ? first(dynamics_.l()) : projection.to_be_checked(movable);
      const Expr is_violated =
          violated_at(put_in(dynamics_, after, false), left_by_speeds(after, given_.speeds, reached->speeds),
                      reached->speeds, rows, is_general);
      reached->violated_constraints = any(graph_, {reached->violated_constraints, is_violated});
    }
    return open;
  }

  /// Of `rows`, along speeds that are `moving`.
  OpenStep open_step(const Matrix& g, const Matrix& b, const Vector& residuals, const std::vector<std::size_t>& rows,
                     const std::vector<std::size_t>& moving) const {
    const Vector zeros(dynamics_.n(), never());
    OpenStep open{Matrix(dynamics_.n(), zeros),
                  Matrix(dynamics_.l(), zeros),
                  Vector(dynamics_.l(), never()),
                  {given_.configuration, given_.speeds, never(), never(), never()}};
    for (std::size_t i = 0; i < dynamics_.n(); ++i) open.g[i][i] = g[i][i];
    for (const std::size_t i : moving) {
      for (const std::size_t j : moving) open.g[i][j] = g[i][j];
      for (const std::size_t mu : rows) open.b[mu][i] = b[mu][i];
    }
    for (const std::size_t mu : rows) open.residuals[mu] = residuals[mu];
    return open;
  }

  Expr change_of(std::size_t speed) const {
    return {graph_, graph_.use(symbols_.speeds[kinematics::FreeIndex{speed}].acceleration)};
  }

  void add_change(const std::vector<std::size_t>& moving, Vector& speeds) const {
    for (const std::size_t i : moving) speeds[i] = ir::rounded(speeds[i] + change_of(i));
  }

  SearchStage step_of_positions(int times) {
    Steps steps;
    const Vector configuration = positions_.step(steps);
    return {
        Kind::positions,
        times,
        {configuration, symbols_of_speeds(symbols_, graph_), positions_.singular(), positions_.dependent(), never()},
        steps,
        opens_ ? std::optional(open_step_of_positions()) : std::nullopt};
  }

  OpenStep open_step_of_positions() const {
    Vector residuals(dynamics_.l(), never());
    for (const std::size_t mu : positions_.movable()) residuals[mu] = positions_.residual(mu);
    const std::vector<std::size_t>& moving = given_.open_positions;
    OpenStep open = open_step(dynamics_.g, dynamics_.b, residuals, positions_.movable(), moving);
    Vector change;
    for (const std::size_t i : moving) change.push_back(change_of(i));
    open.state = {positions_.moved(change), symbols_of_speeds(symbols_, graph_), never(), never(), never()};
    return open;
  }

  SearchStage step_of_speeds(int times) const {
    Steps steps;
    Vector speeds = symbols_of_speeds(symbols_, graph_);
    VelocityProjection projection(dynamics_, given_.open, epsilon_);
    const VelocityProblem at = here();
    projection.step(at, movable_, "", speeds, steps);
    return {
        Kind::speeds,
        times,
        {symbols_of_configuration(symbols_, graph_), speeds, projection.singular(), projection.dependent(), never()},
        steps,
        opens_ ? std::optional(open_step_of_speeds(at)) : std::nullopt};
  }

  OpenStep open_step_of_speeds(const VelocityProblem& at) const {
    OpenStep open = open_step(dynamics_.g, at.b, at.phi, movable_, given_.open);
    open.state = {symbols_of_configuration(symbols_, graph_), symbols_of_speeds(symbols_, graph_), never(), never(),
                  never()};
    add_change(given_.open, open.state.speeds);
    return open;
  }

  /// In the last stage where it is taken once, else in one of its own.
  void check(const Vector& start, StateSearch& search) const {
    if (search.stages.back().times != 1)
      search.stages.push_back(
          {Kind::check,
           1,
           {symbols_of_configuration(symbols_, graph_), symbols_of_speeds(symbols_, graph_), never(), never(), never()},
           {}});
    SearchStage& last = search.stages.back();
    last.state.violated_constraints = is_violated(last.state, start, opens_ && !last.open);
    if (last.open) last.open->state.violated_constraints = is_violated(last.open->state, start, true);
  }

  /// Of each constraint, by rounding of all speeds as they were and are: what stands still has such a speed, and nothing else to be compared with.
  Vector left_by_speeds(ir::Substitution& at, const Vector& before, const Vector& after) const {
    Vector inertia;
    for (const Expr own : inertias(dynamics_)) inertia.push_back(at(own));
    std::vector<ir::NodeId> sizes;
    for (std::size_t i = 0; i < inertia.size(); ++i)
      sizes.push_back((inertia[i] * (pow(before[i], 2) + pow(after[i], 2))).id());
    const Expr size_of_all(graph_, graph_.sum(sizes));
    Vector left;
    for (const Vector& row : dynamics_.b) {
      Vector b;
      for (const Expr entry : row) b.push_back(at(entry));
      left.push_back(left_by_all(b, inertia, size_of_all, epsilon_));
    }
    return left;
  }

  /// The general way leaves out rows nearer to others than 4 sqrt(eps) (rank_of_steps), or than the model's tolerance, and such as nearly vanish
  /// beside what they may be; its status says so.
  Expr violated_at(const VelocityProblem& at, const Vector& left, const Vector& speeds,
                   const std::vector<std::size_t>& rows, bool is_general) const {
    if (!is_general) return violated(at, at.b, speeds, rows, epsilon_, left);
    const Expr tolerance(graph_, graph_.constant(4 * dynamics_.least_response));
    return violated(at, bounds_of(at.b), speeds, rows, ir::Rational(64) * epsilon_ + tolerance, left);
  }

  /// Rows that contradict each other are left open by the general way, also linear ones, and all are looked at then.
  Expr is_violated(const ProjectedState& reached, const Vector& start, bool is_general) const {
    ir::Substitution after = state_values(symbols_, std::nullopt, reached.configuration, reached.speeds);
    const std::vector<std::size_t> rows =
        is_general ? first(dynamics_.l())
                   : VelocityProjection(dynamics_, given_.open, epsilon_).to_be_checked(movable_);
    std::vector<Expr> conditions;
    if (!rows.empty())
      conditions.push_back(violated_at(put_in(dynamics_, after, false),
                                       left_by_speeds(after, symbols_of_speeds(symbols_, graph_), reached.speeds),
                                       reached.speeds, rows, is_general));
    if (positions_.has_rows()) conditions.push_back(positions_.violated(start));
    return any(graph_, conditions);
  }

  const Dynamics& dynamics_;
  const kinematics::Symbols& symbols_;
  ir::Graph& graph_;
  Expr epsilon_;
  GivenState given_;  ///< quaternions of unit length
  bool opens_;        ///< steps are wanted in both forms
  Steps begin_;
  Expr is_lost_;
  PositionProjection positions_;
  std::vector<std::size_t> movable_;  ///< constraints that open speeds change
};

}  // namespace

StateSearch projection(const Dynamics& dynamics, const Vector& start, bool opens, Expr epsilon) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  const std::vector<std::size_t> all = first(dynamics.n());
  const GivenState here{symbols_of_configuration(symbols, graph), symbols_of_speeds(symbols, graph), all, all};
  return Stages(dynamics, here, opens, epsilon).run(start, std::nullopt, k_steps_of_projection);
}

StateSearch initial_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                          Expr time, bool opens, Expr epsilon) {
  return Stages(dynamics, given_state(model, expressions), opens, epsilon).run({}, time, k_steps_to_start);
}

std::vector<ProjectedState> steps_to_initial_state(const model::Model& model, const Dynamics& dynamics,
                                                   kinematics::Expressions& expressions, Expr epsilon) {
  return Stages(dynamics, given_state(model, expressions), false, epsilon).steps();
}

}  // namespace gaussgen::strategy
