#pragma once
// The emitted route as one object: a model on the graph, its accelerations, multipliers and reactions.

#include <chrono>
#include <memory>
#include <optional>
#include <set>

#include "kinematics/linkage.hpp"
#include "strategy/held_reactions.hpp"
#include "strategy/reactions.hpp"

namespace gaussgen {

/// Up to this number of speeds so much vanishes in what follows from all of them at once, as the metric, that it may be as short as what follows
/// link by link: both are formed.
inline constexpr std::size_t k_few_speeds = 6;

class UsualStates;

/// How Z is minimised.
enum class Strategy {
  automatic,    ///< as takes the fewest operations and keeps its digits
  tree,         ///< body by body; nothing where a model has no such form
  metric,       ///< over all speeds at once: by elimination (3.6)-(3.7) where it is safe, else with multipliers
  multipliers,  ///< over all speeds at once, by (3.4) even where elimination is safe
};

struct MechanicsOptions {
  bool fold = false;  ///< parameters become numbers
  Strategy strategy = Strategy::automatic;
  std::size_t most_nodes = ir::k_most_nodes;
  bool limits = true;  ///< sin(q)/q has a value at 0
};

/// The expressions of a model on a graph, each made when it is asked for. Not copyable: the others refer to `graph`.
struct ModelGraph {
  ModelGraph(const model::Model& model, bool fold, std::size_t most_nodes = ir::k_most_nodes, bool limits = true);
  ModelGraph(const ModelGraph&) = delete;
  ModelGraph& operator=(const ModelGraph&) = delete;

  const model::Model& model;
  ir::Graph graph;
  kinematics::Symbols symbols;
  kinematics::Expressions expressions;

  ir::Expr epsilon() const { return expressions.symbol(symbols.epsilon); }

  /// What the model gives its parameters and its inputs, in its order: many evaluators bind them, and one forming is enough.
  const std::vector<ir::NodeId>& parameter_values();
  const std::vector<ir::NodeId>& input_values();

 private:
  std::vector<ir::NodeId> parameter_values_;
  std::vector<ir::NodeId> input_values_;
};

/// What `--timings` says of a part that was built together with others: when it was there, and of how many nodes.
struct Milestone {
  std::chrono::steady_clock::time_point time;
  std::size_t nodes = 0;
};

/// A model on the graph as far as geometry goes: velocities and constraint rows.
struct KinematicModel : ModelGraph {
  KinematicModel(const model::Model& model, bool fold, std::size_t most_nodes = ir::k_most_nodes, bool limits = true);

  kinematics::Kinematics kinematics;
  Milestone kinematics_built;
};

/// As `--strategy` takes it.
std::string name_of(Strategy strategy);

/// With what follows for forces and accelerations: `dynamics` refers to `kinematics` and `covariant`.
struct Mechanics : KinematicModel {
  Mechanics(const model::Model& model, const MechanicsOptions& options);

  support::Lazy<kinematics::Linkage> linkage;
  support::Lazy<kinematics::Covariant> covariant;
  strategy::Steps metric_steps;  ///< of g and f, where they are asked for: before all others
  strategy::Steps steps;         ///< of everything up to the held reactions
  strategy::Dynamics dynamics;
  std::string no_tree;  ///< why Z is not minimised body by body, where that was tried in vain
  strategy::Solution solution;
  strategy::Vector held_reactions;
  MechanicsOptions options;
  std::shared_ptr<const UsualStates> usual_states;  ///< once somebody asks for them
  std::optional<std::size_t> usual_rank;            ///< of all constraints, likewise
  std::set<std::size_t> vanishing;        ///< constraints whose gradient is known to vanish wherever they hold
  bool has_unsolved_reactions = false;    ///< forces depend on reactions of which the equations say nothing
  std::vector<ir::SymbolId> multipliers;  ///< of a solution that is given, where functions of one were made
  std::vector<ir::SymbolId> start;        ///< of the configuration before a projection, where one was made
  std::optional<std::vector<support::Rational>>
      known_start;  ///< numbers of the initial state, where general_start.hpp has found it

 private:
  /// With reactions as they were found instead of their symbols.
  void form_again();
};

/// Accelerations and multipliers of the same metric and constraints with other forces and drifts. Equal nodes are one: factors are not
/// computed again.
strategy::Solution solved_again(const Mechanics& mechanics, const strategy::Dynamics& other, strategy::Steps& steps);

}  // namespace gaussgen
