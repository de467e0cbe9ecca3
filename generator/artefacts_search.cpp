// States that satisfy the constraints: project, initial_state.

#include <algorithm>

#include "artefact_builder.hpp"
#include "strategy/state_search.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using emit::Artefact;
using strategy::SearchStage;
using strategy::StateSearch;
using strategy::Vector;
using Kind = SearchStage::Kind;

namespace {

const char* const k_system_of_step = "_system";

const char* const k_about_project =
    "The nearest state that satisfies the constraints: unit quaternions, then the smallest change of\n"
    "the speeds in the mass metric (up to six Newton steps for constraints nonlinear in the velocities).";

const char* const k_about_initial_state =
    "The initial state of the model at t = 0. Rates that the model leaves open follow from the constraints;\n"
    "what these leave open, too, is the least motion, weighed by mass.";

std::string suffix(Kind kind) {
  switch (kind) {
    case Kind::begin: return "_begin";
    case Kind::positions: return "_positions";
    case Kind::speeds: return "_speeds";
    default: return "_check";
  }
}

std::string about(Kind kind, const std::string& whole) {
  switch (kind) {
    case Kind::begin: return "Of " + whole + ": the values that are given, quaternions to unit length.";
    case Kind::positions: return "Of " + whole + ": a step of Newton's method on the equations of positions.";
    case Kind::speeds: return "Of " + whole + ": a step of Newton's method on the constraints of velocities.";
    default: return "Of " + whole + ": whether the constraints hold.";
  }
}

/// Those that are not zero.
int rows_of(const strategy::Matrix& b) {
  return static_cast<int>(std::count_if(b.begin(), b.end(), [](const Vector& row) {
    return std::any_of(row.begin(), row.end(), [](ir::Expr entry) { return !entry.is_zero(); });
  }));
}

/// What all functions of a search have.
void fill(const SearchStage& stage, Artefact& artefact) {
  artefact.target = emit::Target::state;
  artefact.takes_inputs = false;
  artefact.state = ids(stage.state.configuration);
  const std::vector<emit::NodeId> speeds = ids(stage.state.speeds);
  artefact.state.insert(artefact.state.end(), speeds.begin(), speeds.end());
  artefact.status.singular_mass_matrix = stage.state.singular_mass_matrix.id();
  artefact.status.dependent_constraints = stage.state.dependent_constraints.id();
  artefact.status.violated_constraints = stage.state.violated_constraints.id();
}

class SearchArtefacts {
 public:
  SearchArtefacts(std::string name, std::string about, bool is_from_state, Mechanics& mechanics)
      : name_(std::move(name)), about_(std::move(about)), is_from_state_(is_from_state), mechanics_(mechanics) {}

  /// The functions of its stages, then the one that calls them; where there is one stage, that alone.
  std::vector<Artefact> run(const StateSearch& search) {
    std::vector<Artefact> result;
    if (search.stages.size() == 1 && search.start.empty()) {
      add_stage(search.stages[0], function(search.stages[0], name_, about_), result);
      return result;
    }
    Artefact all = caller();
    for (const SearchStage& stage : search.stages) {
      const bool is_last = &stage == &search.stages.back();
      Artefact made = function(stage, name_ + suffix(stage.kind), about(stage.kind, name_));
      made.takes_start = is_last && !search.start.empty();
      // What is not finite on the way is so at the end.
      if (!is_last) made.status.not_finite = mechanics_.graph.constant(0);
      all.calls.push_back({made.name, stage.times, made.takes_state, made.takes_start});
      add_stage(stage, std::move(made), result);
    }
    result.push_back(std::move(all));
    return result;
  }

 private:
  /// In two ways where its step is open.
  void add_stage(const SearchStage& stage, Artefact regular, std::vector<Artefact>& result) {
    const std::size_t rank = stage.open ? usual_rank(stage.open->b, mechanics_) : 0;
    if (rank == 0) {
      result.push_back(std::move(regular));
      return;
    }
    const strategy::OpenStep& open = *stage.open;
    const Vector no_forces(mechanics_.dynamics.n(), mechanics_.expressions.number(0));
    const Vector no_rows(mechanics_.dynamics.l(), mechanics_.expressions.number(0));
    Artefact system = linear_system(regular.name + k_system_of_step,
                                    {open.g, no_forces, open.b, open.residuals, no_rows, no_rows}, mechanics_);
    SearchStage given{stage.kind, stage.times, open.state, {}};
    Artefact of_solution = function(given, regular.name, "");
    of_solution.takes_start = regular.takes_start;
    for (Artefact* one : {&system, &of_solution}) {
      one->takes_time = regular.takes_time;
      one->takes_state = regular.takes_state;
      one->takes_inputs = false;
      one->extends_preparation = regular.extends_preparation;
    }
    result.push_back(std::move(system));
    const std::string system_name = result.back().name;
    for (Artefact& one : two_ways(std::move(regular), std::move(of_solution),
                                  {{},
                                   system_name,
                                   {},
                                   static_cast<int>(rank),
                                   rows_of(open.b),
                                   emit::Shown::step,
                                   true,
                                   mechanics_.model.rank_tolerance}))
      result.push_back(std::move(one));
  }

  Artefact function(const SearchStage& stage, const std::string& name, const std::string& about) {
    ArtefactBuilder builder(name, about, mechanics_);
    Artefact& artefact = builder.artefact();
    fill(stage, artefact);
    if (stage.kind == Kind::begin && !is_from_state_) {
      artefact.takes_time = false;
      artefact.takes_state = false;
      artefact.extends_preparation = false;
    }
    return builder.finish(stage.steps);
  }

  /// Angles and components of quaternions; lengths and speeds have no size that is usual.
  std::vector<int> measured_by_one() const {
    std::vector<int> result;
    for (const auto& q : mechanics_.symbols.configuration) result.push_back(q.unit == "m" ? 0 : 1);
    result.resize(result.size() + mechanics_.dynamics.n(), 0);
    return result;
  }

  Artefact caller() {
    const emit::NodeId never = mechanics_.graph.constant(0);
    Artefact artefact;
    artefact.name = name_;
    artefact.about = about_;
    artefact.target = emit::Target::state;
    artefact.takes_time = artefact.takes_state = is_from_state_;
    artefact.takes_inputs = false;
    artefact.status = {never, never, never, never};
    artefact.measured_by_one = measured_by_one();
    return artefact;
  }

  std::string name_, about_;
  bool is_from_state_;
  Mechanics& mechanics_;
};

/// Symbols for the configuration before a projection.
strategy::Vector start_of(Mechanics& mechanics) {
  if (mechanics.start.empty()) {
    for (const auto& q : mechanics.symbols.configuration)
      mechanics.start.push_back(mechanics.graph.declare(ir::SymbolClass::configuration, q.name + "_at_start"));
  }
  strategy::Vector start;
  for (const ir::SymbolId symbol : mechanics.start) start.push_back(mechanics.expressions.symbol(symbol));
  return start;
}

}  // namespace

std::vector<Artefact> project_artefacts(Mechanics& mechanics) {
  const StateSearch search =
      strategy::projection(mechanics.dynamics, start_of(mechanics), has_general_way(mechanics), mechanics.epsilon());
  return SearchArtefacts("project", k_about_project, true, mechanics).run(search);
}

std::vector<Artefact> initial_state_artefacts(Mechanics& mechanics) {
  const StateSearch search =
      strategy::initial_state(mechanics.model, mechanics.dynamics, mechanics.expressions,
                              mechanics.expressions.number(0), has_general_way(mechanics), mechanics.epsilon());
  return SearchArtefacts("initial_state", k_about_initial_state, false, mechanics).run(search);
}

}  // namespace gaussgen
