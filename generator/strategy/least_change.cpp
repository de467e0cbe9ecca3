#include "strategy/least_change.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/cost.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;
using kinematics::Freedom;
using kinematics::FreeIndex;
using kinematics::Link;

namespace {

/// Up to this number of speeds the metric may be shorter than the links: both are formed.
constexpr std::size_t k_few_speeds = 6;

constexpr std::size_t k_given = static_cast<std::size_t>(-1);

/// By speed: its place among those that move.
std::vector<std::size_t> places_of(const std::vector<std::size_t>& moving, std::size_t count) {
  std::vector<std::size_t> places(count, k_given);
  for (std::size_t j = 0; j < moving.size(); ++j) places[moving[j]] = j;
  return places;
}

/// Where nothing moves but by what is looked for.
Link at_rest(Link link, const std::vector<std::size_t>& places, Expr zero) {
  const ir::Vector3 none{zero, zero, zero};
  link.velocity = none;
  link.drift = none;
  if (link.velocity_before) link.velocity_before = none;
  if (link.rate) link.rate = zero;
  const auto is_given = [&](const Freedom& freedom) { return places[freedom.speed.value] == k_given; };
  // A turn of which some speeds are given is free by the columns of the others, and no ball that leaves its axes behind.
  if (std::any_of(link.freedoms.begin(), link.freedoms.end(), is_given)) {
    kinematics::mix_speeds(link);
    link.velocity_before.reset();
  }
  link.freedoms.erase(std::remove_if(link.freedoms.begin(), link.freedoms.end(), is_given), link.freedoms.end());
  for (Freedom& freedom : link.freedoms) freedom.speed = FreeIndex{places[freedom.speed.value]};
  return link;
}

kinematics::Linkage at_rest(kinematics::Linkage linkage, const std::vector<std::size_t>& places, Expr zero) {
  for (Link& link : linkage.links) link = at_rest(link, places, zero);
  return linkage;
}

template <class Values>
std::vector<typename Values::value_type> chosen(const Values& values, const std::vector<std::size_t>& indices) {
  std::vector<typename Values::value_type> result;
  for (const std::size_t i : indices) result.push_back(values[i]);
  return result;
}

kinematics::Symbols symbols_of(const kinematics::Symbols& all, const Change& change) {
  kinematics::Symbols symbols = all;
  symbols.speeds = {};
  for (const std::size_t i : change.moving) symbols.speeds.push_back(all.speeds[FreeIndex{i}]);
  return symbols;
}

kinematics::Kinematics with_rows_of(const Change& change, const kinematics::Kinematics& all) {
  kinematics::Kinematics kinematics = all;
  kinematics.constraints = {};
  for (const std::size_t mu : change.rows) kinematics.constraints.push_back(all.constraints[ConstraintIndex{mu}]);
  return kinematics;
}

int operations_of(const Solution& solution) {
  std::vector<ir::NodeId> ids{solution.singular_mass_matrix.id(), solution.dependent_constraints.id()};
  for (const Expr a : solution.accelerations) ids.push_back(a.id());
  return ir::operations(solution.singular_mass_matrix.graph(), ids);
}

}  // namespace

std::optional<Solution> least_change_of_links(const TreeProblem& problem, const Change& change, Expr epsilon,
                                              Steps& steps) {
  const Expr zero(epsilon.graph(), epsilon.graph().constant(0));
  const kinematics::Linkage linkage =
      at_rest(problem.linkage, places_of(change.moving, problem.symbols.speeds.size()), zero);
  const kinematics::Symbols symbols = symbols_of(problem.symbols, change);
  const kinematics::Kinematics kinematics = with_rows_of(change, problem.constraints.kinematics);
  Matrix b;
  for (const std::size_t mu : change.rows) b.push_back(chosen(problem.constraints.b[mu], change.moving));
  const TreeProblem at_rest{linkage,
                            symbols,
                            ir::zero3(epsilon.graph()),
                            Vector(change.moving.size(), zero),
                            {kinematics,
                             b,
                             change.residuals,
                             [zero](Expr) { return zero; },
                             problem.constraints.vanishes,
                             {},
                             problem.constraints.value_of,
                             problem.constraints.estimate,
                             change.residuals},
                            change.prefix};
  return solve_tree(at_rest, TreeForm{}, epsilon, steps);
}

Dynamics over_metric(const Dynamics& dynamics, const Change& change, const DependentRows& dependent_rows, Expr zero) {
  Dynamics problem;
  problem.names = {change.prefix, "change", "impulse"};
  problem.dependent_rows = dependent_rows;
  problem.labels = chosen(dynamics.labels, change.moving);
  problem.f = Vector(change.moving.size(), zero);
  for (const std::size_t i : change.moving) problem.g.push_back(chosen(dynamics.g[i], change.moving));
  for (const std::size_t mu : change.rows) {
    problem.constraints.push_back(dynamics.constraints[mu]);
    problem.b.push_back(chosen(dynamics.b[mu], change.moving));
  }
  problem.b_drift = change.residuals;
  return problem;
}

Solution least_change(const Dynamics& dynamics, const Change& change, const DependentRows& dependent_rows, Expr epsilon,
                      Steps& steps) {
  Steps of_links, of_metric;
  std::optional<Solution> links;
  if (dynamics.change_of_links) links = dynamics.change_of_links(change, of_links);
  const auto take = [&](Solution solution, const Steps& own) {
    for (const Step& step : own.all()) steps.append(step.values);
    return solution;
  };
  if (links && dynamics.n() > k_few_speeds) return take(std::move(*links), of_links);
  const Expr zero(epsilon.graph(), epsilon.graph().constant(0));
  Solution metric = solve_with_multipliers(over_metric(dynamics, change, dependent_rows, zero), epsilon, of_metric);
  if (links && operations_of(*links) < operations_of(metric)) return take(std::move(*links), of_links);
  return take(std::move(metric), of_metric);
}

}  // namespace gaussgen::strategy
