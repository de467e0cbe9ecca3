#include "artefacts.hpp"

#include <algorithm>
#include <cctype>

#include "strategy/compulsion.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::Group;
using emit::NodeId;
using ir::Expr;
using strategy::Steps;
using strategy::Vector;

namespace {

std::string pascal(const std::string& name) {
  std::string result;
  bool upper = true;
  for (const char c : name) {
    if (c == '_') {
      upper = true;
    } else {
      result += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = false;
    }
  }
  return result;
}

std::vector<NodeId> ids(const Vector& values) {
  std::vector<NodeId> result;
  for (const Expr value : values) result.push_back(value.id());
  return result;
}

std::vector<NodeId> ids(const ir::Vector3& v) { return {v[0].id(), v[1].id(), v[2].id()}; }

/// Fills the parts that every artefact has.
class ArtefactBuilder {
 public:
  ArtefactBuilder(std::string name, std::string about, Mechanics& mechanics) : mechanics_(mechanics) {
    artefact_.name = std::move(name);
    artefact_.about = std::move(about);
    const NodeId never = mechanics.graph.constant(0);
    artefact_.status = {never, never, never};
  }

  Artefact& artefact() { return artefact_; }

  void result_type(const std::string& type) {
    artefact_.target = emit::Target::result;
    artefact_.result_type = type;
  }

  void fields(const std::string& name, const std::string& type, const std::string& about, std::vector<Field> fields) {
    artefact_.groups.push_back(Group{name, type, about, std::move(fields)});
  }

  void with_solution_status() {
    artefact_.status.singular_mass_matrix = mechanics_.solution.singular_mass_matrix.id();
    artefact_.status.dependent_constraints = mechanics_.solution.dependent_constraints.id();
  }

  Artefact finish(const Steps& own) {
    add_sections(mechanics_.steps.all());
    add_sections(own.all());
    artefact_.status.not_finite = not_finite();
    return std::move(artefact_);
  }

 private:
  void add_sections(const std::vector<strategy::Step>& steps) {
    for (const strategy::Step& step : steps) artefact_.sections.push_back({step.comment, step.subject, step.values});
  }

  // An infinity or NaN anywhere in the inputs reaches an output, so outputs are enough to look at.
  NodeId not_finite() const {
    std::vector<NodeId> values = artefact_.derivative;
    values.insert(values.end(), artefact_.state.begin(), artefact_.state.end());
    for (const Group& group : artefact_.groups) {
      for (const Field& field : group.fields) values.insert(values.end(), field.values.begin(), field.values.end());
    }
    ir::Graph& graph = mechanics_.graph;
    values.erase(std::remove_if(values.begin(), values.end(),
                                [&](NodeId id) { return graph[id].kind == ir::Kind::constant; }),
                 values.end());
    return values.empty() ? graph.constant(0) : graph.call(ir::Function::not_finite, values);
  }

  Mechanics& mechanics_;
  Artefact artefact_;
};

std::vector<NodeId> derivative_of(const Mechanics& mechanics) {
  std::vector<NodeId> values = ids(mechanics.kinematics.configuration_rates.values());
  const std::vector<NodeId> accelerations = ids(mechanics.solution.accelerations);
  values.insert(values.end(), accelerations.begin(), accelerations.end());
  return values;
}

std::string quantity(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

std::string generalized_unit(const std::string& coordinate_unit) {
  if (coordinate_unit == "m") return "N";
  return coordinate_unit == "rad" || coordinate_unit == "1" ? "N*m" : "";
}

void add_reaction_fields(ArtefactBuilder& builder, Mechanics& mechanics, Steps& steps) {
  const auto generalized = strategy::generalized_reactions(mechanics.dynamics, mechanics.solution, steps);
  builder.result_type("Reactions");
  for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
    const std::string& name = mechanics.dynamics.constraints[mu];
    std::vector<Field> fields;
    fields.push_back({"multiplier", "lambda of (3.4): the constraint adds lambda * dphi/du to the equations of motion", {},
                      {mechanics.solution.multipliers[mu].id()}});
    fields.push_back({"generalized", "lambda * dphi/du for each speed, in the order of the state",
                      {static_cast<int>(mechanics.dynamics.n())}, ids(generalized[mu])});
    builder.fields(name, pascal(name) + "Reaction", "nonholonomic constraint " + name, std::move(fields));
  }
  for (const auto i : mechanics.symbols.held.indices()) {
    const auto& held = mechanics.symbols.held[i];
    const std::string unit = generalized_unit(mechanics.model.coordinates[held.model_index].unit);
    builder.fields(held.name, pascal(held.name) + "Reaction", "held coordinate " + held.name,
                   {{"generalized", "R of (3.8)" + quantity(unit) + ", positive along growing " + held.name, {},
                     {mechanics.held_reactions[i.value].id()}}});
  }
}

bool has_reactions(const Mechanics& mechanics) {
  return mechanics.dynamics.l() + mechanics.symbols.held.size() > 0;
}

Artefact rhs(Mechanics& mechanics) {
  ArtefactBuilder builder("rhs", "Time derivative of the state: rates of the configuration, then accelerations (3.7).", mechanics);
  builder.artefact().target = emit::Target::derivative;
  builder.artefact().derivative = derivative_of(mechanics);
  builder.with_solution_status();
  return builder.finish({});
}

std::vector<Artefact> reactions(Mechanics& mechanics, bool with_rhs) {
  if (!has_reactions(mechanics)) return {};
  ArtefactBuilder builder(with_rhs ? "rhs_and_reactions" : "reactions",
                          with_rhs ? "Both at once, over one set of shared values."
                                   : "Reaction of every constraint: multipliers (3.4) and generalized reactions (3.8).",
                          mechanics);
  Steps steps;
  add_reaction_fields(builder, mechanics, steps);
  if (with_rhs) builder.artefact().derivative = derivative_of(mechanics);
  builder.with_solution_status();
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

std::vector<Artefact> reaction_forces(Mechanics& mechanics) {
  if (!has_reactions(mechanics)) return {};
  ArtefactBuilder builder("reaction_forces",
                          "Reactions as Cartesian forces and moments that act ON the bodies, in space axes.\n"
                          "A force acts at the mass centre together with the moment stated beside it.",
                          mechanics);
  Steps steps;
  builder.result_type("ReactionForces");
  builder.with_solution_status();
  std::vector<Group>& groups = builder.artefact().groups;
  for (const strategy::ReactionWrench& wrench :
       strategy::reaction_wrenches(mechanics.dynamics, mechanics.solution, mechanics.held_reactions, steps)) {
    if (groups.empty() || groups.back().name != wrench.constraint) {
      builder.fields(wrench.constraint, pascal(wrench.constraint) + "Force", "reaction of " + wrench.constraint, {});
    }
    std::vector<Field>& fields = groups.back().fields;
    fields.push_back({"force_on_" + wrench.body, "[N], space axes, on " + wrench.body, {3}, ids(wrench.force)});
    if (!wrench.moment) continue;
    const std::string about = wrench.about_point ? "the stated point of " + wrench.constraint : "the mass centre";
    fields.push_back({"moment_on_" + wrench.body, "[N*m], space axes, on " + wrench.body + " about " + about, {3},
                      ids(*wrench.moment)});
  }
  std::vector<Artefact> result;
  if (!groups.empty()) result.push_back(builder.finish(steps));
  return result;
}

Artefact energy(Mechanics& mechanics) {
  ArtefactBuilder builder("energy", "Kinetic energy, potential energy of uniform fields and potentials, and their sum.", mechanics);
  Steps steps;
  steps.begin("energies");
  builder.result_type("Energy");
  builder.artefact().takes_inputs = false;
  const Expr kinetic = steps.name(mechanics.covariant.kinetic_energy, "kinetic_energy");
  const Expr potential = steps.name(mechanics.kinematics.potential, "potential_energy");
  builder.fields("", "", "", {{"kinetic", "[J]", {}, {kinetic.id()}},
                              {"potential", "[J]", {}, {potential.id()}},
                              {"total", "[J]", {}, {(kinetic + potential).id()}}});
  return builder.finish(steps);
}

Vector candidate_accelerations(const Mechanics& mechanics) {
  Vector candidate;
  for (const auto& speed : mechanics.symbols.speeds) candidate.push_back(mechanics.expressions.symbol(speed.acceleration));
  return candidate;
}

bool has_massless_body(const Mechanics& mechanics) {
  return std::any_of(mechanics.kinematics.bodies.begin(), mechanics.kinematics.bodies.end(), [](const auto& body) {
    return body.mass.is_zero() || (body.is_rigid && (body.inertia[0][0].is_zero() || body.inertia[1][1].is_zero() ||
                                                     body.inertia[2][2].is_zero()));
  });
}

std::vector<Artefact> compulsion(Mechanics& mechanics) {
  if (has_massless_body(mechanics)) return {};
  ArtefactBuilder builder("compulsion",
                          "Gauss's function Z_w (1.18) of candidate accelerations, as a complete square over the bodies:\n"
                          "least, among all accelerations that the constraints allow, at those of rhs.",
                          mechanics);
  Steps steps;
  builder.result_type("Compulsion");
  builder.artefact().takes_accelerations = true;
  const Expr Z = strategy::compulsion(mechanics.dynamics, candidate_accelerations(mechanics), steps);
  builder.fields("", "", "", {{"Z", "[N^2/kg]", {}, {Z.id()}}});
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

void add_norms(const Mechanics& mechanics, std::vector<Field>& fields) {
  Vector norms;
  for (const auto first : mechanics.symbols.first_quaternion_component) {
    Expr norm = mechanics.expressions.number(-1);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& q = mechanics.symbols.configuration[kinematics::ConfigurationIndex{first.value + i}];
      norm += ir::pow(mechanics.expressions.symbol(q.symbol), 2);
    }
    norms.push_back(norm);
  }
  if (norms.empty()) return;
  fields.push_back({"position", "squared norm of each quaternion, less 1", {static_cast<int>(norms.size())}, ids(norms)});
}

std::vector<Artefact> residuals(Mechanics& mechanics) {
  ArtefactBuilder builder("residuals",
                          "How far a state, and candidate accelerations, are from satisfying the constraints.\n"
                          "Held coordinates satisfy theirs by construction.",
                          mechanics);
  std::vector<Field> fields;
  add_norms(mechanics, fields);
  const Vector candidate = candidate_accelerations(mechanics);
  Vector velocity;
  Vector acceleration;
  for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
    velocity.push_back(mechanics.kinematics.constraints[kinematics::ConstraintIndex{mu}].phi);
    Expr sum = mechanics.dynamics.b_drift[mu];
    for (std::size_t a = 0; a < candidate.size(); ++a) sum += mechanics.dynamics.b[mu][a] * candidate[a];
    acceleration.push_back(sum);
  }
  if (!velocity.empty()) {
    const int l = static_cast<int>(velocity.size());
    fields.push_back({"velocity", "phi of each nonholonomic constraint (3.1)", {l}, ids(velocity)});
    fields.push_back({"acceleration", "dphi/dt of each nonholonomic constraint", {l}, ids(acceleration)});
  }
  if (fields.empty()) return {};
  builder.result_type("Residuals");
  builder.artefact().takes_accelerations = true;
  builder.fields("", "", "", std::move(fields));
  std::vector<Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

Artefact mass_matrix(Mechanics& mechanics) {
  ArtefactBuilder builder("mass_matrix", "The metric g of the free speeds (1.10).", mechanics);
  builder.result_type("MassMatrix");
  builder.artefact().takes_inputs = false;
  std::vector<NodeId> entries;
  for (const Vector& row : mechanics.dynamics.g) {
    for (const Expr entry : row) entries.push_back(entry.id());
  }
  const int n = static_cast<int>(mechanics.dynamics.n());
  builder.fields("", "", "", {{"g", "symmetric, in the order of the speeds", {n, n}, entries}});
  return builder.finish({});
}

Artefact state_artefact(ArtefactBuilder& builder, const strategy::ProjectedState& state, const Steps& steps) {
  Artefact& artefact = builder.artefact();
  artefact.target = emit::Target::state;
  artefact.takes_inputs = false;
  artefact.state = ids(state.configuration);
  const std::vector<NodeId> speeds = ids(state.speeds);
  artefact.state.insert(artefact.state.end(), speeds.begin(), speeds.end());
  artefact.status.singular_mass_matrix = state.singular_mass_matrix.id();
  artefact.status.dependent_constraints = state.dependent_constraints.id();
  return builder.finish(steps);
}

Artefact project(Mechanics& mechanics) {
  ArtefactBuilder builder("project",
                          "The nearest state that satisfies the constraints: unit quaternions, then the smallest change of\n"
                          "the speeds in the mass metric (one Newton step for constraints nonlinear in the velocities).",
                          mechanics);
  Steps steps;
  const auto state = strategy::project(mechanics.dynamics, mechanics.epsilon(), steps);
  return state_artefact(builder, state, steps);
}

Artefact initial_state(Mechanics& mechanics) {
  ArtefactBuilder builder("initial_state",
                          "The initial state of the model at t = 0. Rates that the model leaves open follow from the constraints.",
                          mechanics);
  Steps steps;
  const auto state = strategy::initial_state(mechanics.model, mechanics.dynamics, mechanics.expressions,
                                             mechanics.expressions.number(0), mechanics.epsilon(), steps);
  builder.artefact().takes_time = false;
  builder.artefact().takes_state = false;
  builder.artefact().extends_preparation = false;
  return state_artefact(builder, state, steps);
}

}  // namespace

const std::vector<OutputKind>& output_kinds() {
  static const std::vector<OutputKind> k_kinds{
      {"rhs", "time derivative of the state"},
      {"reactions", "multiplier and generalized reaction of every constraint, alone and together with rhs"},
      {"reaction_forces", "reactions as Cartesian forces and moments on the bodies"},
      {"energy", "kinetic, potential and total energy"},
      {"compulsion", "Gauss's function Z of candidate accelerations"},
      {"residuals", "constraint residuals of position, velocity and acceleration"},
      {"mass_matrix", "the metric of the free speeds"},
      {"project", "nearest state that satisfies the constraints"},
      {"initial_state", "the model's initial state"}};
  return k_kinds;
}

std::vector<Artefact> build_artefact(const std::string& name, Mechanics& mechanics) {
  const auto one = [](Artefact artefact) {
    std::vector<Artefact> list;
    list.push_back(std::move(artefact));
    return list;
  };
  if (name == "rhs") return one(rhs(mechanics));
  if (name == "reactions") {
    std::vector<Artefact> both = reactions(mechanics, false);
    for (Artefact& artefact : reactions(mechanics, true)) both.push_back(std::move(artefact));
    return both;
  }
  if (name == "reaction_forces") return reaction_forces(mechanics);
  if (name == "energy") return one(energy(mechanics));
  if (name == "compulsion") return compulsion(mechanics);
  if (name == "residuals") return residuals(mechanics);
  if (name == "mass_matrix") return one(mass_matrix(mechanics));
  if (name == "project") return one(project(mechanics));
  if (name == "initial_state") return one(initial_state(mechanics));
  return {};
}

}  // namespace gaussgen
