// Functions that turn to the general solution of the linear system where their own way is lost (emit/two_ways.hpp).

#include <algorithm>
#include <map>
#include <optional>

#include "artefact_builder.hpp"
#include "given_solution.hpp"
#include "ir/traverse.hpp"
#include "strategy/bounds.hpp"
#include "strategy/drift_error.hpp"
#include "strategy/position_size.hpp"
#include "strategy/row_groups.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::NodeId;
using ir::Expr;
using strategy::Vector;

namespace {

/// Of speeds times speeds and constraints: beyond, code and time of the general solution are out of proportion, and a status has to do.
constexpr std::size_t k_most_entries = 4000;
/// Where the cheap way is lost in every state, a status would have to do everywhere. Beyond, what is solved fills a stack.
constexpr std::size_t k_most_entries_of_redundant = 10'000;

const char* const k_regular = "_regular";
const char* const k_of_solution = "_of_solution";
const char* const k_system = "linear_system";

/// Where parameters alone decide, and no pivot is a difference of which rounding may be all that is left, rows depend on each other for parameters that
/// make no sense only, and a status has to do.
bool may_lose_rank(Expr dependent) {
  const ir::Graph& graph = dependent.graph();
  if (!ir::is_of_parameters(graph, dependent.id())) return true;
  const std::vector<NodeId> order = ir::post_order(graph, {dependent.id()});
  return std::any_of(order.begin(), order.end(), [&](NodeId id) {
    const ir::Node& node = graph[id];
    return node.kind == ir::Kind::symbol && graph.symbol(node.symbol).symbol_class == ir::SymbolClass::epsilon;
  });
}

/// What a caller sees, without values.
Artefact caller_of(const Artefact& regular) {
  Artefact caller;
  caller.name = regular.name;
  caller.about = regular.about;
  caller.target = regular.target;
  caller.takes_time = regular.takes_time;
  caller.takes_start = regular.takes_start;
  caller.takes_state = regular.takes_state;
  caller.takes_inputs = regular.takes_inputs;
  caller.state = regular.state;
  caller.derivative = regular.derivative;
  caller.result_type = regular.result_type;
  caller.groups = regular.groups;
  caller.status = regular.status;
  return caller;
}

}  // namespace

bool has_general_way(Mechanics& mechanics) {
  const std::size_t n = mechanics.dynamics.n(), l = mechanics.dynamics.l();
  const std::size_t entries = n * (n + l);
  if (n == 0 || l == 0 || entries > k_most_entries_of_redundant) return false;
  if (entries <= k_most_entries && may_lose_rank(mechanics.solution.dependent_constraints)) return true;
  return usual_rank(mechanics) < l;
}

namespace {

/// Square of the part by which positions are off an equation, of what it is made of; 1 where that is nothing.
Expr part_off(Expr f, Expr size) {
  const Expr zero(f.graph(), f.graph().constant(0)), one(f.graph(), f.graph().constant(1));
  const Expr all = size + pow(f, 2);
  const Expr is_something = less(zero, all);
  return select(is_something, pow(f, 2) / select(is_something, all, one), zero);
}

/// For each constraint, of all equations that it may follow from.
Vector parts_off(Mechanics& mechanics) {
  Vector start;
  for (const auto& q : mechanics.symbols.configuration) start.push_back(mechanics.expressions.symbol(q.symbol));
  const strategy::PositionSize size(mechanics.dynamics, start);
  const std::vector<std::optional<std::size_t>> groups = strategy::row_groups(mechanics.dynamics);
  std::map<std::size_t, Expr> off;
  for (const kinematics::ConstraintIndex mu : mechanics.kinematics.constraints.indices()) {
    const std::optional<Expr>& f = mechanics.kinematics.constraints[mu].f;
    if (!f || !groups[mu.value]) continue;
    off.try_emplace(*groups[mu.value], mechanics.expressions.number(0)).first->second +=
        part_off(*f, size.of_row(mu.value));
  }
  Vector result(groups.size(), mechanics.expressions.number(0));
  for (std::size_t mu = 0; mu < groups.size(); ++mu) {
    if (groups[mu] && off.count(*groups[mu]) > 0) result[mu] = off.at(*groups[mu]);
  }
  return result;
}

}  // namespace

Artefact linear_system(const std::string& name, const LinearProblem& problem, Mechanics& mechanics) {
  ArtefactBuilder builder(name, "What Gauss's principle leaves to be solved: g a = f + b^T lambda, b a + drift = 0.",
                          mechanics);
  builder.with_any_quaternion();
  builder.result_type("LinearSystem");
  const int n = static_cast<int>(problem.f.size()), l = static_cast<int>(problem.drift.size());
  std::vector<NodeId> of_positions;
  for (const kinematics::ConstraintRow& row : mechanics.kinematics.constraints)
    of_positions.push_back(mechanics.graph.constant(row.f ? 1 : 0));
  builder.fields(
      "", "", "",
      {{"g", "the metric of the free speeds (1.10)", {n, n}, ids(problem.metric)},
       {"f", "forces, less what inertia takes at constant speeds", {n}, ids(problem.f)},
       {"b", "dphi/du of each constraint", {l, n}, ids(problem.b)},
       {"reach", "not less than dphi/du in any configuration", {l, n}, ids(strategy::bounds_of(problem.b))},
       {"of_positions", "1: the derivative of an equation of positions; else 0", {l}, of_positions},
       {"off",
        "square of the part by which positions are off the equations that a row may follow from",
        {l},
        ids(problem.off)},
       {"drift", "dphi/dt of each at constant speeds; of a step, what is left of it", {l}, ids(problem.drift)},
       {"drift_error",
        "how far it may be off in this state, where it is asked whether constraints agree",
        {l},
        ids(problem.drift_error)}});
  Artefact system = builder.finish({});
  system.is_part = true;
  return system;
}

Artefact linear_system_artefact(Mechanics& mechanics) {
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  const Vector off = parts_off(mechanics);
  return linear_system(k_system,
                       {dynamics.g, dynamics.f, dynamics.b, dynamics.b_drift, off,
                        strategy::drift_errors(dynamics, off, mechanics.epsilon())},
                       mechanics);
}

std::vector<Artefact> two_ways(Artefact regular, Artefact of_solution, emit::TwoWays ways) {
  Artefact caller = caller_of(regular);
  const bool has_regular = ways.usual_rank == ways.rows;
  if (has_regular) ways.regular = caller.name + k_regular;
  ways.of_solution = caller.name + k_of_solution;
  regular.name = ways.regular;
  regular.about = "Of " + caller.name + ": as it is done where constraints are independent.";
  of_solution.name = ways.of_solution;
  of_solution.about = "Of " + caller.name + ": from a solution of the linear system.";
  of_solution.takes_solution = true;
  regular.is_part = of_solution.is_part = true;
  caller.ways = std::move(ways);
  std::vector<Artefact> result;
  if (has_regular) result.push_back(std::move(regular));
  result.push_back(std::move(of_solution));
  result.push_back(std::move(caller));
  return result;
}

namespace {

/// Of functions of the accelerations.
emit::TwoWays ways_of(Mechanics& mechanics, emit::Shown shown) {
  return {{},
          k_system,
          {},
          static_cast<int>(usual_rank(mechanics)),
          static_cast<int>(mechanics.dynamics.l()),
          shown,
          mechanics.kinematics.has_positions(),
          mechanics.model.rank_tolerance};
}

}  // namespace

std::vector<Artefact> of_general_solution(Artefact of_solution, emit::Rates rates, Mechanics& mechanics) {
  emit::TwoWays ways = ways_of(mechanics, emit::Shown::motion);
  ways.rates = std::move(rates);
  Artefact as_caller = caller_of(of_solution);
  return two_ways(std::move(as_caller), std::move(of_solution), std::move(ways));
}

std::vector<Artefact> in_two_ways(const ArtefactsOf& build, bool shows_multipliers, Mechanics& mechanics) {
  std::vector<Artefact> regular = build(mechanics);
  if (!has_general_way(mechanics)) return regular;
  std::vector<Artefact> of_solution;
  {
    const GivenSolution given(mechanics);
    of_solution = build(mechanics);
  }
  std::vector<Artefact> result;
  for (std::size_t i = 0; i < regular.size(); ++i) {
    const bool shows = shows_multipliers && !regular[i].result_type.empty();
    const emit::Shown shown = shows ? emit::Shown::reactions : emit::Shown::motion;
    for (Artefact& one : two_ways(std::move(regular[i]), std::move(of_solution[i]), ways_of(mechanics, shown)))
      result.push_back(std::move(one));
  }
  return result;
}

std::vector<Artefact> mobility_artefact(Mechanics& mechanics) {
  if (!has_general_way(mechanics)) return {};
  ArtefactBuilder builder(
      "mobility",
      "What the constraints leave to the mechanism in this state. The status is not ok where the state is none;\n"
      "a rank that is lower here than usual is no mistake of this function.",
      mechanics);
  builder.with_any_quaternion();
  builder.result_type("Mobility");
  const int l = static_cast<int>(mechanics.dynamics.l());
  const NodeId none = mechanics.graph.constant(0);
  builder.fields("", "", "",
                 {{"rank", "number of constraints that say something of their own", {}, {none}},
                  {"mobility", "number of independent motions: speeds less the rank", {}, {none}},
                  {"is_shared",
                   "1: others can do what this constraint does, its multiplier is not unique; else 0",
                   {l},
                   std::vector<NodeId>(mechanics.dynamics.l(), none)}});
  Artefact result = caller_of(builder.finish({}));
  result.ways = ways_of(mechanics, emit::Shown::rank);
  std::vector<Artefact> list;
  list.push_back(std::move(result));
  return list;
}

}  // namespace gaussgen
