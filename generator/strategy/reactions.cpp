#include "strategy/reactions.hpp"

#include <algorithm>

#include "strategy/inner.hpp"
#include "strategy/metric.hpp"
#include "strategy/release.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::BodyMotion;
using kinematics::ConstraintIndex;
using kinematics::FullIndex;
using kinematics::HeldIndex;

Matrix generalized_reactions(const Dynamics& dynamics, const Solution& solution, Steps&) {
  Matrix result;
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    Vector row;
    for (const Expr b : dynamics.b[mu]) row.push_back(solution.multipliers[mu] * b);
    result.push_back(row);
  }
  return result;
}

namespace {

/// Everything about one constraint that its wrenches need.
struct Source {
  std::string name;
  Expr size;  ///< λ_μ or R_j
  Vector components;
  const std::optional<Vector3>* point = nullptr;

  /// A constraint between places and nothing else says itself where its forces act: forces_at_places has them all.
  bool is_at_places() const {
    return std::all_of(components.begin(), components.end(), [](Expr component) { return component.is_zero(); });
  }
};

std::vector<Source> sources(const Dynamics& dynamics, const Solution& solution, const Vector& held) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  const kinematics::Symbols& symbols = kinematics.symbols;
  std::vector<Source> all;
  for (const ConstraintIndex mu : kinematics.constraints.indices()) {
    const kinematics::ConstraintRow& row = kinematics.constraints[mu];
    all.push_back({row.name, solution.multipliers[mu.value], row.beside.values(), &row.point});
  }
  ir::Graph& graph = kinematics.field[0].graph();
  for (const HeldIndex j : symbols.held.indices()) {
    // What acts on parts without mass, which this coordinate moves, it takes itself: the bodies feel the rest.
    const FullIndex row = symbols.full(j);
    Expr passed_on = held[j.value] + kinematics.carried_force[row];
    for (const ConstraintIndex mu : kinematics.constraints.indices()) {
      passed_on += solution.multipliers[mu.value] * kinematics.constraints[mu].carried[row];
    }
    Vector unit(symbols.full_count(), Expr(graph, graph.constant(0)));
    unit[row.value] = Expr(graph, graph.constant(1));
    all.push_back({symbols.held[j].name, passed_on, unit, nullptr});
  }
  return all;
}

Vector3 combination(const support::Indexed<FullIndex, Vector3>& columns, const Vector& z) {
  ir::Graph& graph = z[0].graph();
  Vector3 sum = ir::zero3(graph);
  for (std::size_t i = 0; i < 3; ++i) {
    Vector row;
    for (const Vector3& column : columns) row.push_back(column[i]);
    sum[i] = inner(graph, row, z);
  }
  return sum;
}

/// Nothing where the constraint cannot reach the body, whatever its size. (A reaction that happens to be zero is reported.)
std::optional<ReactionWrench> wrench_on(const BodyMotion& body, const Source& source, const Vector& z, Steps& steps) {
  const std::string suffix = source.name + "_" + body.name;
  const Vector3 linear = combination(body.J, z);
  const Vector3 angular = body.is_rigid ? combination(body.W, z) : ir::zero3(source.size.graph());
  if (is_zero(linear) && is_zero(angular)) return std::nullopt;
  ReactionWrench wrench{
      source.name, body.name, steps.name((body.mass * source.size) * linear, "force_" + suffix), {}, false};
  if (!body.is_rigid) return wrench;
  Vector3 moment = source.size * in_space(body, body.inertia_times(angular));
  if (source.point != nullptr && source.point->has_value()) {
    // M_P = M_G + (r_G - r_P) × F
    moment = moment + cross(body.position - **source.point, wrench.force);
    wrench.about_point = true;
  }
  wrench.moment = steps.name(moment, "moment_" + suffix);
  return wrench;
}

/// A body that feels a constraint at a place of its own, too, feels both: the force at the place with its moment.
void add_at_place(ReactionWrench& wrench, const ReactionWrench& at_place, const Source& source, const BodyMotion& body,
                  Steps& steps) {
  const std::string suffix = "all_" + source.name + "_" + body.name;
  wrench.force = steps.name(wrench.force + at_place.force, "force_" + suffix);
  if (!wrench.moment) return;
  const Vector3& about = wrench.about_point ? **source.point : body.position;
  wrench.moment = steps.name(*wrench.moment + cross(*at_place.at - about, at_place.force), "moment_" + suffix);
}

/// With what acts on the body at a place, or beside the others of its constraint.
void add(ReactionWrench wrench, const Source& source, const BodyMotion& body, std::vector<ReactionWrench>& wrenches,
         Steps& steps) {
  auto behind = wrenches.end();
  for (auto other = wrenches.begin(); other != wrenches.end(); ++other) {
    if (other->constraint != wrench.constraint) continue;
    behind = other + 1;
    if (!other->at || other->body != wrench.body) continue;
    add_at_place(wrench, *other, source, body, steps);
    *other = std::move(wrench);
    return;
  }
  wrenches.insert(behind, std::move(wrench));
}

}  // namespace

namespace {

bool is_determined(const Source& source, const Release& release) {
  for (std::size_t i = 0; i < source.components.size(); ++i) {
    if (!source.components[i].is_zero() && !release.is_released(FullIndex{i})) return false;
  }
  return true;
}

}  // namespace

namespace {

std::vector<ReactionWrench> forces_at_places(const Dynamics& dynamics, const Solution& solution, Steps& steps) {
  std::vector<ReactionWrench> wrenches;
  for (const ConstraintIndex mu : dynamics.kinematics->constraints.indices()) {
    const kinematics::ConstraintRow& row = dynamics.kinematics->constraints[mu];
    if (row.actions.empty()) continue;
    steps.begin("force of " + row.name + " where it acts: lambda dphi/dv", row.name);
    for (const kinematics::ConstraintAction& action : row.actions) {
      if (action.frame == model::k_space || is_zero(action.direction)) continue;
      const std::string& owner = dynamics.kinematics->frame_names[action.frame];
      wrenches.push_back(
          {row.name,
           owner,
           steps.name(solution.multipliers[mu.value] * action.direction, "force_" + row.name + "_" + owner),
           {},
           false,
           action.point});
    }
  }
  return wrenches;
}

}  // namespace

ReactionWrenches reaction_wrenches(const Dynamics& dynamics, const Solution& solution, const Vector& held, Expr epsilon,
                                   Steps& steps) {
  const Release release(dynamics);
  ir::Graph& graph = epsilon.graph();
  ReactionWrenches wrenches{forces_at_places(dynamics, solution, steps), Expr(graph, graph.constant(0))};
  if (release.released().empty()) return wrenches;
  const Metric metric(dynamics, release.released(), epsilon, steps);
  for (const Source& source : sources(dynamics, solution, held)) {
    if (source.is_at_places() || !is_determined(source, release)) continue;
    steps.begin("direction z of " + source.name + " in the metric: G z = its covariant components");
    const Vector z = metric.solve(source.components, "z_" + source.name, steps);
    steps.begin("force and moment of " + source.name + ": m J z and I W z, times its reaction", source.name);
    for (const BodyMotion& body : *dynamics.kinematics->bodies) {
      if (auto wrench = wrench_on(body, source, z, steps)) add(std::move(*wrench), source, body, wrenches.each, steps);
    }
    wrenches.singular_metric = metric.is_singular();
  }
  return wrenches;
}

std::vector<std::string> undetermined_wrenches(const Dynamics& dynamics, const Solution& solution, const Vector& held) {
  const Release release(dynamics);
  std::vector<std::string> names;
  for (const Source& source : sources(dynamics, solution, held)) {
    if (!source.is_at_places() && !is_determined(source, release)) names.push_back(source.name);
  }
  return names;
}

Vector3 in_space(const BodyMotion& body, const Vector3& v) {
  return body.rotation.axes == model::Axes::space ? v : ir::multiply(body.rotation.matrix, v);
}

BodyAcceleration acceleration_of(const BodyMotion& body, const Dynamics& dynamics, const Vector& free) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  Vector all = free;
  all.insert(all.end(), kinematics.held_acceleration.begin(), kinematics.held_acceleration.end());
  BodyAcceleration result{combination(body.J, all) + body.h, body.eta};
  if (body.is_rigid) result.angular = combination(body.W, all) + body.eta;
  return result;
}

}  // namespace gaussgen::strategy
