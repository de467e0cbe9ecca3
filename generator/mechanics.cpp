#include "mechanics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluate/arithmetic_double.hpp"
#include "evaluate/decimal.hpp"
#include "evaluation.hpp"
#include "generic_point.hpp"
#include "kinematics/hold.hpp"
#include "reactions_in_forces.hpp"
#include "rounding.hpp"
#include "strategy/composite_metric.hpp"
#include "strategy/inner.hpp"
#include "strategy/least_change.hpp"
#include "strategy/margins.hpp"
#include "strategy/tree_choice.hpp"

namespace gaussgen {

namespace {

constexpr std::size_t k_most_speeds_compared = 30;
constexpr double k_rounding_of_few = 1e-12;   ///< of accelerations: more of it is worth a look at the other solution,
constexpr double k_rounding_of_many = 1e-10;  ///< which has to be derived for it where speeds are many
constexpr double k_rounding_of_constrained = 1e-8;  ///< likewise: loops that are nearly folded are nearly singular
constexpr double k_many_times = 100;

const char* const k_about_tree = "Z minimised body by body along the tree";

std::vector<std::size_t> allowed_dependent(const Mechanics& mechanics) {
  std::vector<std::size_t> allowed;
  for (const model::Name& name : mechanics.model.dependent) {
    for (const auto i : mechanics.symbols.speeds.indices()) {
      if (mechanics.symbols.speeds[i].label == name.text) allowed.push_back(i.value);
    }
  }
  return allowed;
}

strategy::DependentRows rows_found_at_generic_point(ModelGraph& motion) {
  return [at_generic_point = std::make_shared<GenericPoint>(motion)](const strategy::Matrix& metric) {
    return dependent_rows((*at_generic_point)(metric));
  };
}

/// Whoever names the dependent speeds wants them expressed by the others.
bool wants_tree(const Mechanics& mechanics, Strategy strategy) {
  if (mechanics.symbols.speeds.size() == 0) return false;
  return strategy == Strategy::tree || (strategy == Strategy::automatic && mechanics.model.dependent.empty());
}

ir::Rational least_response(const model::Model& model) {
  return model.rank_tolerance ? ir::Rational(*model.rank_tolerance * *model.rank_tolerance) : ir::Rational(0);
}

strategy::TreeProblem tree_problem(Mechanics& mechanics, std::function<bool(ir::Expr)> vanishes, GenericPoint& point,
                                   bool folds) {
  const kinematics::Kinematics& kinematics = mechanics.kinematics;
  strategy::TreeProblem problem{*mechanics.linkage,
                                mechanics.symbols,
                                kinematics.field,
                                {},
                                {kinematics,
                                 mechanics.dynamics.b,
                                 mechanics.dynamics.b_drift,
                                 [&](ir::Expr e) { return mechanics.expressions.rate(e); },
                                 std::move(vanishes),
                                 {},
                                 {},
                                 {},
                                 {}},
                                ""};
  problem.constraints.estimate = [&](ir::Expr e) {
    if (ir::is_of_parameters(mechanics.graph, e.id())) return mechanics.dynamics.at_parameters(e);
    return evaluate::to_double(point({{e}})(0, 0));
  };
  if (folds) {
    problem.constraints.value_of = [&](ir::Expr e) { return evaluate::to_double(point({{e}})(0, 0)); };
  }
  problem.least_response = least_response(mechanics.model);
  return problem;
}

std::function<bool(ir::Expr)> vanishing(const std::shared_ptr<VanishesEverywhere>& vanishes_everywhere) {
  return [vanishes_everywhere](ir::Expr e) { return e.is_zero() || (*vanishes_everywhere)(e); };
}

/// What is asked for of changes of a state, link by link.
void add_forms_of_links(Mechanics& mechanics, const MechanicsOptions& options, strategy::Dynamics& dynamics) {
  if (!wants_tree(mechanics, options.strategy)) return;
  const auto vanishes = vanishing(std::make_shared<VanishesEverywhere>(mechanics));
  dynamics.change_of_links = [&mechanics, vanishes, folds = options.fold](const strategy::Change& change,
                                                                          strategy::Steps& steps) {
    GenericPoint point(mechanics);
    const strategy::TreeProblem problem = tree_problem(mechanics, vanishes, point, folds);
    return strategy::least_change_of_links(problem, change, mechanics.epsilon(), steps);
  };
}

/// Of many coordinates, with composite bodies where the model has links: each entry takes a few operations then.
strategy::Dynamics dynamics_of(Mechanics& mechanics, const MechanicsOptions& options,
                               strategy::DependentRows dependent_rows) {
  strategy::Dynamics result = strategy::build_dynamics(
      mechanics.kinematics, mechanics.covariant, std::move(dependent_rows), mechanics.steps, mechanics.metric_steps);
  const auto values = std::make_shared<evaluate::Evaluator<double>>(mechanics.graph, evaluate::Arithmetic<double>());
  bind_parameters(mechanics, *values);
  result.at_parameters = [values](ir::Expr e) {
    return (*values)(e.id()).value_or(std::numeric_limits<double>::infinity());
  };
  result.least_response = least_response(mechanics.model);
  add_forms_of_links(mechanics, options, result);
  if (result.n() <= k_few_speeds) return result;
  result.inertias_of_links = [&mechanics, labels = result.labels] {
    return strategy::composite_inertias(*mechanics.linkage, labels, mechanics.graph, mechanics.metric_steps);
  };
  result.g = support::LazyList<strategy::Matrix>([&mechanics, labels = result.labels] {
    return strategy::composite_metric(*mechanics.linkage, labels, mechanics.graph, mechanics.metric_steps);
  });
  return result;
}

/// None where none of them is anything, or one is on no link. Particles feel no moment: what acts beside them is in other_force.
std::vector<kinematics::BodyLoad> loads_on_links(Mechanics& mechanics) {
  std::vector<kinematics::BodyLoad> loads = mechanics.kinematics.loads;
  std::vector<char> is_on_link(loads.size(), 0);
  for (const kinematics::Part& part : mechanics.linkage->parts)
    is_on_link[part.body] = part.link != kinematics::k_ground ? 1 : 0;
  bool any = false;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (!mechanics.model.bodies[i].inertia) loads[i].moment = ir::zero3(mechanics.graph);
    const bool acts = !is_zero(loads[i].force) || !is_zero(loads[i].moment);
    if (acts && is_on_link[i] == 0) return {};
    any = any || acts;
  }
  return any ? loads : std::vector<kinematics::BodyLoad>();
}

std::optional<strategy::Candidate> solved_as_tree(Mechanics& mechanics, const MechanicsOptions& options) {
  const kinematics::Kinematics& kinematics = mechanics.kinematics;
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  GenericPoint point(mechanics);
  strategy::TreeProblem problem =
      tree_problem(mechanics, vanishing(std::make_shared<VanishesEverywhere>(mechanics)), point, options.fold);
  if (dynamics.n() <= k_few_speeds) {
    problem.constraints.excess = [&](std::size_t u, const strategy::Vector& a) {
      return strategy::inner(mechanics.graph, dynamics.g[u], a) - dynamics.f[u];
    };
  }
  for (const auto i : mechanics.symbols.speeds.indices()) {
    const auto a = mechanics.symbols.full(i);
    problem.forces.push_back(kinematics.body_force[a] + kinematics.other_force[a]);
    problem.forces_beside.push_back(kinematics.other_force[a]);
  }
  problem.loads = loads_on_links(mechanics);
  return strategy::cheapest_tree(problem, mechanics.epsilon());
}

strategy::Solution taken(strategy::Candidate candidate, const std::string& instead, strategy::Steps& steps) {
  steps.append(candidate.steps);
  candidate.solution.description +=
      fmt::format(": {} operations before they are optimised{}", candidate.operations, instead);
  return std::move(candidate.solution);
}

strategy::Solution solved_constrained(const Mechanics& mechanics, const strategy::Dynamics& dynamics,
                                      const MechanicsOptions& options, strategy::Steps& steps) {
  // Elimination asks whether pivots vanish, and not how near rows are to each other.
  const bool asks_for_angles = mechanics.model.rank_tolerance && dynamics.l() > 1;
  if (options.strategy != Strategy::multipliers && !asks_for_angles) {
    // The model's choice first, where it has one; structure_check says so if it is not safe.
    auto elimination = strategy::eliminate(dynamics, allowed_dependent(mechanics), steps);
    if (!elimination) elimination = strategy::eliminate(dynamics, {}, steps);
    if (elimination) return strategy::solve_by_elimination(dynamics, *elimination, mechanics.epsilon(), steps);
  }
  return strategy::solve_with_multipliers(dynamics, mechanics.epsilon(), steps);
}

strategy::Candidate solved_over_metric(const Mechanics& mechanics, const MechanicsOptions& options) {
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  strategy::Steps steps;
  strategy::Solution solution = dynamics.l() == 0 ? strategy::solve_unconstrained(dynamics, mechanics.epsilon(), steps)
                                                  : solved_constrained(mechanics, dynamics, options, steps);
  return strategy::counted(std::move(solution), std::move(steps));
}

/// How many more digits rounding takes on the tree than over the metric, if they are many: a heavy part at the end of light ones comes
/// through each of them as a difference of large numbers.
std::optional<int> lost_on_tree(Mechanics& mechanics, const MechanicsOptions& options, const strategy::Candidate& tree,
                                std::optional<strategy::Candidate>& metric) {
  if (mechanics.dynamics.n() > k_most_speeds_compared) return std::nullopt;
  Rounding rounding(mechanics);
  const double on_tree = rounding(tree.solution);
  const bool has_constraints = mechanics.dynamics.l() > 0;
  const double much = has_constraints ? k_rounding_of_constrained : metric ? k_rounding_of_few : k_rounding_of_many;
  if (!(on_tree > much)) return std::nullopt;
  if (!metric) metric = solved_over_metric(mechanics, options);
  const double over_metric = std::max(rounding(metric->solution), std::numeric_limits<double>::epsilon());
  if (!(on_tree > k_many_times * over_metric)) return std::nullopt;
  return static_cast<int>(std::lround(std::log10(on_tree / over_metric)));
}

strategy::Solution solved(Mechanics& mechanics, const MechanicsOptions& options, strategy::Steps& steps) {
  const bool tries_tree = wants_tree(mechanics, options.strategy);
  const std::size_t n = mechanics.dynamics.n();
  const bool is_small = n <= k_few_speeds;
  // First, so that its entries have the names by which people know them.
  std::optional<strategy::Candidate> metric, tree;
  if (!tries_tree || (is_small && options.strategy == Strategy::automatic))
    metric = solved_over_metric(mechanics, options);
  if (tries_tree) tree = solved_as_tree(mechanics, options);
  if (!tree && mechanics.no_tree.empty()) {
    mechanics.no_tree = n == 0 ? "nothing in it moves freely"
                               : "an acceleration has no inertia of its own, or constraints follow from each other";
  }
  if (tree) tree->solution.description = k_about_tree + tree->about;
  if (!tree && !metric) metric = solved_over_metric(mechanics, options);
  if (!tree) {
    steps.append(metric->steps);
    return metric->solution;
  }
  if (options.strategy == Strategy::automatic) {
    if (const auto lost = lost_on_tree(mechanics, options, *tree, metric)) {
      return taken(std::move(*metric),
                   fmt::format(", and {} body by body along the tree, where rounding takes up to {} digits more",
                               tree->operations, *lost),
                   steps);
    }
  }
  if (!metric) return taken(std::move(*tree), "", steps);
  if (tree->operations < metric->operations) {
    const char* const about = mechanics.dynamics.l() == 0 ? "by L D L^T of the metric" : "over all speeds at once";
    return taken(std::move(*tree), fmt::format(", and {} {}", metric->operations, about), steps);
  }
  return taken(std::move(*metric), fmt::format(", and {} body by body along the tree", tree->operations), steps);
}

/// A pivot that is infinite is no matter of mass or constraints: a state may be infinite, too.
strategy::Solution with_questions_apart(strategy::Solution solution) {
  for (ir::Expr* condition : {&solution.singular_mass_matrix, &solution.dependent_constraints})
    *condition = strategy::without_questions(*condition, solution.looked_at);
  return solution;
}

// Rates of coordinates are speeds and need no name; those of quaternions are expressions.
void name_rates(Mechanics& mechanics) {
  const bool has_quaternions = !mechanics.symbols.first_quaternion_component.empty();
  if (!has_quaternions && mechanics.model.speeds.empty()) return;
  mechanics.steps.begin(mechanics.model.speeds.empty()
                            ? "rates of the quaternions: half the product with (0, omega) (theory.md, section 5)"
                            : "rates of the configuration from the speeds (theory.md, section 5)");
  for (const auto i : mechanics.symbols.configuration.indices()) {
    ir::Expr& rate = mechanics.kinematics.configuration_rates[i];
    rate = mechanics.steps.name(rate, mechanics.symbols.configuration[i].name + "_dot");
  }
}

}  // namespace

std::string name_of(Strategy strategy) {
  switch (strategy) {
    case Strategy::tree: return "tree";
    case Strategy::metric: return "metric";
    case Strategy::multipliers: return "multipliers";
    default: return "auto";
  }
}

ModelGraph::ModelGraph(const model::Model& checked_model, bool fold, std::size_t most_nodes, bool limits)
    : model(checked_model),
      graph(most_nodes),
      symbols(kinematics::declare_symbols(model, graph)),
      expressions(model, symbols, graph, fold, limits) {}

namespace {

/// Forms those of `declared` that `formed` has not yet.
template <class Declared>
const std::vector<ir::NodeId>& form_values(const std::vector<Declared>& declared, kinematics::Expressions& expressions,
                                           std::vector<ir::NodeId>& formed) {
  formed.reserve(declared.size());
  for (std::size_t i = formed.size(); i < declared.size(); ++i) formed.push_back(expressions(declared[i].value).id());
  return formed;
}

}  // namespace

const std::vector<ir::NodeId>& ModelGraph::parameter_values() {
  return form_values(model.parameters, expressions, parameter_values_);
}

const std::vector<ir::NodeId>& ModelGraph::input_values() {
  return form_values(model.inputs, expressions, input_values_);
}

KinematicModel::KinematicModel(const model::Model& checked_model, bool fold, std::size_t most_nodes, bool limits)
    : ModelGraph(checked_model, fold, most_nodes, limits),
      kinematics(kinematics::build_kinematics(model, graph, expressions, symbols)),
      kinematics_built{std::chrono::steady_clock::now(), graph.size()} {}

Mechanics::Mechanics(const model::Model& checked_model, const MechanicsOptions& chosen)
    : KinematicModel(checked_model, chosen.fold, chosen.most_nodes, chosen.limits),
      linkage([this] {
        ir::Substitution hold = kinematics::held_laws(model, expressions, symbols);
        return kinematics::build_linkage(model, symbols, expressions, hold);
      }),
      covariant([this] { return kinematics::build_covariant(kinematics, graph); }),
      dynamics(dynamics_of(*this, chosen, rows_found_at_generic_point(*this))),
      solution(with_questions_apart(solved(*this, chosen, steps))),
      held_reactions(strategy::held_reactions(model, dynamics, solution, steps)),
      options(chosen) {
  if (!model.reactions.empty()) form_again();
  name_rates(*this);
}

void Mechanics::form_again() {
  std::optional<std::vector<ir::Expr>> found = found_reactions(*this);
  has_unsolved_reactions = !found;
  if (!found) return;
  strategy::Steps of_reactions;
  for (std::size_t i = 0; i < found->size(); ++i) {
    if (i == 0) of_reactions.begin("reactions that forces depend on (theory.md, section 10)", model.reactions[i].of);
    (*found)[i] = of_reactions.name((*found)[i], "reaction_" + model.reactions[i].of);
  }
  expressions.set_reactions(*std::move(found));
  // What only quantities mention changes no force.
  kinematics = kinematics::build_kinematics(model, graph, expressions, symbols);
  if (!model::has_reactions_in_forces(model)) return;
  covariant = support::Lazy<kinematics::Covariant>([this] { return kinematics::build_covariant(kinematics, graph); });
  metric_steps = {};
  steps = of_reactions;
  dynamics = dynamics_of(*this, options, rows_found_at_generic_point(*this));
  solution = with_questions_apart(solved(*this, options, steps));
  held_reactions = strategy::held_reactions(model, dynamics, solution, steps);
}

strategy::Solution solved_again(const Mechanics& mechanics, const strategy::Dynamics& other, strategy::Steps& steps) {
  if (other.l() == 0) return strategy::solve_unconstrained(other, mechanics.epsilon(), steps);
  return solved_constrained(mechanics, other, mechanics.options, steps);
}

}  // namespace gaussgen
