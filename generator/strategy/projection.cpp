#include "strategy/projection.hpp"

#include <algorithm>

#include "ir/substitute.hpp"
#include "strategy/inner.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

namespace {

/// φ, b and g at one state.
struct VelocityProblem {
  Vector phi;
  Matrix b;
  Matrix g;
};

/// Newton steps on φ(u) = 0 over some of the speeds, in the metric g.
class VelocityProjection {
 public:
  VelocityProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, Expr epsilon)
      : dynamics_(dynamics), moving_(std::move(moving)), epsilon_(epsilon), singular_(never()), dependent_(never()) {}

  /// Changes `speeds` by one step at `problem`.
  void step(const VelocityProblem& problem, const std::string& prefix, Vector& speeds, Steps& steps) {
    const std::vector<std::size_t> rows = rows_that_move(problem);
    if (rows.empty() || moving_.empty()) return;
    steps.begin("smallest change of the speeds in the mass metric that satisfies the constraints");
    const Ldl metric(restricted(problem.g), labels(), prefix + "g", epsilon_, steps);
    Matrix response;
    Matrix b;
    Vector defect;
    std::vector<std::string> names;
    for (const std::size_t mu : rows) {
      names.push_back(dynamics_.constraints[mu]);
      b.push_back(restricted(problem.b[mu]));
      response.push_back(metric.solve(b.back(), prefix + "response_" + names.back(), steps));
      defect.push_back(-problem.phi[mu]);
    }
    const Ldl schur(products(b, response), names, prefix + "S", epsilon_, steps, Dependent::drop);
    const Vector size = schur.solve(defect, prefix + "impulse", steps);
    for (std::size_t j = 0; j < moving_.size(); ++j) {
      Vector column;
      for (const Vector& row : response) column.push_back(row[j]);
      Expr& speed = speeds[moving_[j]];
      speed = steps.name(speed + inner(graph(), column, size), prefix + dynamics_.labels[moving_[j]] + "_rate");
    }
    singular_ = either(singular_, metric.breakdown());
    dependent_ = either(dependent_, schur.breakdown());
  }

  Expr singular() const { return singular_; }
  Expr dependent() const { return dependent_; }

 private:
  ir::Graph& graph() const { return epsilon_.graph(); }
  Expr never() const { return {graph(), graph().constant(0)}; }

  Expr either(Expr a, Expr b) const {
    if (a.is_zero()) return b;
    return b.is_zero() ? a : Expr(graph(), graph().call(ir::Function::any, {a.id(), b.id()}));
  }

  // A constraint over speeds that are all given can only be checked, not satisfied.
  std::vector<std::size_t> rows_that_move(const VelocityProblem& problem) const {
    std::vector<std::size_t> rows;
    for (std::size_t mu = 0; mu < problem.b.size(); ++mu) {
      const Vector row = restricted(problem.b[mu]);
      if (std::any_of(row.begin(), row.end(), [](Expr e) { return !e.is_zero(); })) rows.push_back(mu);
    }
    return rows;
  }

  std::vector<std::string> labels() const {
    std::vector<std::string> result;
    for (const std::size_t i : moving_) result.push_back(dynamics_.labels[i]);
    return result;
  }

  Vector restricted(const Vector& row) const {
    Vector result;
    for (const std::size_t i : moving_) result.push_back(row[i]);
    return result;
  }

  Matrix restricted(const Matrix& matrix) const {
    Matrix result;
    for (const std::size_t i : moving_) result.push_back(restricted(matrix[i]));
    return result;
  }

  Matrix products(const Matrix& b, const Matrix& response) const {
    Matrix S(b.size(), Vector(b.size(), never()));
    for (std::size_t i = 0; i < b.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) S[i][j] = inner(graph(), b[std::max(i, j)], response[std::min(i, j)]);
    }
    return S;
  }

  const Dynamics& dynamics_;
  std::vector<std::size_t> moving_;
  Expr epsilon_;
  Expr singular_;
  Expr dependent_;
};

VelocityProblem at(const Dynamics& dynamics, ir::Substitution& put_in) {
  VelocityProblem problem;
  for (const auto& row : dynamics.kinematics->constraints) problem.phi.push_back(put_in(row.phi));
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

// Each quaternion (four components in a row) divided by its norm.
void normalise_quaternions(const kinematics::Symbols& symbols, Vector& configuration, Steps& steps) {
  if (!symbols.first_quaternion_component.empty()) steps.begin("quaternions to unit length");
  for (const ConfigurationIndex first : symbols.first_quaternion_component) {
    Vector e(configuration.begin() + static_cast<std::ptrdiff_t>(first.value),
             configuration.begin() + static_cast<std::ptrdiff_t>(first.value + 4));
    const Expr norm_squared = inner(e[0].graph(), e, e);
    const Expr scale = steps.name(pow(norm_squared, support::Rational(-1) / 2), "unit");
    for (std::size_t i = 0; i < 4; ++i) configuration[first.value + i] = e[i] * scale;
  }
}

bool all_linear(const Dynamics& dynamics) {
  const auto& rows = dynamics.kinematics->constraints;
  return std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.is_linear; });
}

}  // namespace

ProjectedState project(const Dynamics& dynamics, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  ProjectedState state{{}, {}, epsilon, epsilon};
  for (const auto& q : symbols.configuration) state.configuration.emplace_back(graph, graph.use(q.symbol));
  for (const auto& u : symbols.speeds) state.speeds.emplace_back(graph, graph.use(u.symbol));
  normalise_quaternions(symbols, state.configuration, steps);
  ir::Substitution put_in(graph);
  for (const ConfigurationIndex i : symbols.configuration.indices()) {
    put_in.replace(symbols.configuration[i].symbol, state.configuration[i.value]);
  }
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < dynamics.n(); ++i) all.push_back(i);
  VelocityProjection projection(dynamics, all, epsilon);
  projection.step(at(dynamics, put_in), "", state.speeds, steps);
  state.singular_mass_matrix = projection.singular();
  state.dependent_constraints = projection.dependent();
  return state;
}

namespace {

/// Values that the model gives, and which speeds it leaves to the constraints.
struct Given {
  Vector configuration;
  Vector speeds;
  std::vector<std::size_t> open;
};

void add_speed(const std::optional<model::Ast>& value, const std::optional<model::Ast>& guess,
               kinematics::Expressions& expressions, Given& given) {
  if (!value) given.open.push_back(given.speeds.size());
  given.speeds.push_back(value ? expressions(*value) : (guess ? expressions(*guess) : expressions.number(0)));
}

Given given_state(const model::Model& model, kinematics::Expressions& expressions) {
  Given given;
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    given.configuration.push_back(expressions(coordinate.initial));
    add_speed(coordinate.initial_rate, coordinate.rate_guess, expressions, given);
  }
  for (const model::Orientation& orientation : model.orientations) {
    for (const model::Ast& component : orientation.initial) given.configuration.push_back(expressions(component));
    for (const auto& component : orientation.initial_angular_velocity) {
      add_speed(component, std::nullopt, expressions, given);
    }
  }
  return given;
}

}  // namespace

ProjectedState initial_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                             Expr time, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  Given given = given_state(model, expressions);
  normalise_quaternions(symbols, given.configuration, steps);
  VelocityProjection projection(dynamics, given.open, epsilon);
  // A linear problem needs one step; a second one then only refines the rounding. Newton converges quadratically.
  const int count = dynamics.l() == 0 ? 0 : (all_linear(dynamics) ? 1 : 8);
  for (int step = 0; step < count; ++step) {
    ir::Substitution put_in(graph);
    put_in.replace(symbols.time, time);
    for (const ConfigurationIndex i : symbols.configuration.indices()) {
      put_in.replace(symbols.configuration[i].symbol, given.configuration[i.value]);
    }
    for (const FreeIndex i : symbols.speeds.indices()) put_in.replace(symbols.speeds[i].symbol, given.speeds[i.value]);
    projection.step(at(dynamics, put_in), count == 1 ? "" : "step" + std::to_string(step + 1) + "_", given.speeds, steps);
  }
  return {given.configuration, given.speeds, projection.singular(), projection.dependent()};
}

}  // namespace gaussgen::strategy
