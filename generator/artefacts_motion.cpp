#include "artefact_builder.hpp"

#include "description.hpp"
#include "emit/identifiers.hpp"
#include "strategy/body_reactions.hpp"
#include "strategy/joint_reactions.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::Group;
using emit::NodeId;
using ir::Expr;
using strategy::Steps;
using strategy::Vector;

namespace {

std::vector<NodeId> derivative_of(const Mechanics& mechanics) {
  std::vector<NodeId> values = ids(mechanics.kinematics.configuration_rates.values());
  const std::vector<NodeId> accelerations = ids(mechanics.solution.accelerations);
  values.insert(values.end(), accelerations.begin(), accelerations.end());
  return values;
}

std::string quantity(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

void add_reaction_fields(ArtefactBuilder& builder, Mechanics& mechanics, Steps& steps) {
  const auto generalized = strategy::generalized_reactions(mechanics.dynamics, mechanics.solution, steps);
  builder.result_type("Reactions");
  for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
    const std::string& name = mechanics.dynamics.constraints[mu];
    const kinematics::ConstraintRow& row = mechanics.kinematics.constraints[kinematics::ConstraintIndex{mu}];
    std::vector<Field> fields;
    fields.push_back(
        {"multiplier",
         "lambda of (3.4)" + quantity(row.unit) + ": the constraint adds lambda * dphi/du to the equations of motion",
         {},
         {mechanics.solution.multipliers[mu].id()}});
    fields.push_back({"generalized",
                      "lambda * dphi/du for each speed, in the order of the state",
                      {static_cast<int>(mechanics.dynamics.n())},
                      ids(generalized[mu])});
    const std::string kind = row.f ? "holonomic constraint " : "nonholonomic constraint ";
    builder.fields(name, emit::pascal_case(name) + "Reaction", kind + name, std::move(fields));
  }
  for (const auto i : mechanics.symbols.held.indices()) {
    const auto& held = mechanics.symbols.held[i];
    const std::string unit = generalized_unit(mechanics.model.coordinates[held.model_index].unit);
    builder.fields(held.name, emit::pascal_case(held.name) + "Reaction", "held coordinate " + held.name,
                   {{"generalized",
                     "R of (3.8)" + quantity(unit) + ", positive along growing " + held.name,
                     {},
                     {mechanics.held_reactions[i.value].id()}}});
  }
}

bool has_reactions(const Mechanics& mechanics) { return mechanics.dynamics.l() + mechanics.symbols.held.size() > 0; }

Artefact reactions(Mechanics& mechanics, bool with_rhs) {
  ArtefactBuilder builder(with_rhs ? "rhs_and_reactions" : "reactions",
                          with_rhs ? "Both at once, over one set of shared values."
                                   : "Reaction of every constraint: multipliers (3.4) and generalized reactions (3.8).",
                          mechanics);
  Steps steps;
  add_reaction_fields(builder, mechanics, steps);
  if (with_rhs) builder.artefact().derivative = derivative_of(mechanics);
  builder.with_solution_status();
  return builder.finish(steps);
}

}  // namespace

Artefact rhs_artefact(Mechanics& mechanics) {
  ArtefactBuilder builder("rhs", "Time derivative of the state: rates of the configuration, then accelerations (3.7).",
                          mechanics);
  builder.artefact().target = emit::Target::derivative;
  builder.artefact().derivative = derivative_of(mechanics);
  builder.with_solution_status();
  return builder.finish({});
}

std::vector<Artefact> reactions_artefacts(Mechanics& mechanics) {
  std::vector<Artefact> result;
  if (!has_reactions(mechanics)) return result;
  result.push_back(reactions(mechanics, false));
  if (mechanics.dynamics.n() > 0) result.push_back(reactions(mechanics, true));
  return result;
}

namespace {

const char* const k_forces_about =
    "Forces and moments that constraints exert ON the bodies, in space axes. A force acts at the point\n"
    "that the moment beside it names, or on the particle. on_<body> is the sum over all constraints, by Newton and "
    "Euler.";

/// Potentials and generalized forces: they act on coordinates, so Newton and Euler cannot tell them from constraints.
std::string forces_without_body(const model::Model& model) {
  std::vector<std::string> names;
  for (const model::Force& force : model.forces) {
    const bool names_none = std::holds_alternative<model::Potential>(force.law) ||
                            std::holds_alternative<model::GeneralizedForce>(force.law) ||
                            std::holds_alternative<model::CoordinateSpring>(force.law);
    if (names_none) names.push_back(force.name.text);
  }
  return support::joined(names);
}

std::string about_sum(const model::Model& model, const std::string& body) {
  const std::string names = forces_without_body(model);
  return "all constraints on " + body + (names.empty() ? "" : ", and the forces that name no body: " + names);
}

std::string undetermined_note(const Mechanics& mechanics) {
  const std::vector<std::string> names =
      strategy::undetermined_wrenches(mechanics.dynamics, mechanics.solution, mechanics.held_reactions);
  if (names.empty()) return "";
  return "\nNot stated one by one, as the coordinates do not describe every motion of the bodies: " +
         support::joined(names) + ".";
}

void add_sums(ArtefactBuilder& builder, Mechanics& mechanics, Steps& steps) {
  for (const strategy::BodyReaction& reaction :
       strategy::body_reactions(mechanics.model, mechanics.dynamics, mechanics.solution, steps)) {
    std::vector<Field> fields{{"force", "[N], space axes", {3}, ids(reaction.force)}};
    if (reaction.moment) {
      fields.push_back({"moment", "[N*m], space axes, about the mass centre", {3}, ids(*reaction.moment)});
    }
    builder.fields("on_" + reaction.body, "On" + emit::pascal_case(reaction.body),
                   about_sum(mechanics.model, reaction.body), std::move(fields));
  }
}

void add_single_forces(ArtefactBuilder& builder, Mechanics& mechanics, Steps& steps) {
  std::vector<Group>& groups = builder.artefact().groups;
  const strategy::ReactionWrenches wrenches = strategy::reaction_wrenches(
      mechanics.dynamics, mechanics.solution, mechanics.held_reactions, mechanics.epsilon(), steps);
  builder.with_singular_metric(wrenches.singular_metric);
  for (const strategy::ReactionWrench& wrench : wrenches.each) {
    if (groups.empty() || groups.back().name != wrench.constraint) {
      builder.fields(wrench.constraint, emit::pascal_case(wrench.constraint) + "Force",
                     "reaction of " + wrench.constraint, {});
    }
    std::vector<Field>& fields = groups.back().fields;
    fields.push_back({"force_on_" + wrench.body, "[N], space axes, on " + wrench.body, {3}, ids(wrench.force)});
    if (!wrench.moment) continue;
    const std::string about = wrench.about_point ? "the stated point of " + wrench.constraint : "the mass centre";
    fields.push_back({"moment_on_" + wrench.body,
                      "[N*m], space axes, on " + wrench.body + " about " + about,
                      {3},
                      ids(*wrench.moment)});
  }
}

}  // namespace

std::vector<Artefact> reaction_forces_artefact(Mechanics& mechanics) {
  if (!has_reactions(mechanics)) return {};
  ArtefactBuilder builder("reaction_forces", k_forces_about + undetermined_note(mechanics), mechanics);
  Steps steps;
  builder.result_type("ReactionForces");
  builder.with_solution_status();
  add_single_forces(builder, mechanics, steps);
  add_sums(builder, mechanics, steps);
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

namespace {

/// What acts along coordinates acts in their joints.
std::string drives(const model::Model& model) {
  const std::string names = forces_without_body(model);
  return names.empty() ? "" : "\nWhat acts along coordinates is part of what their joints transmit: " + names + ".";
}

/// Rigid bodies do not say what a loop carries in directions in which it is closed anyway, such as across its plane.
std::string indeterminate(const model::Model& model) {
  const auto& rows = model.idle_closures;
  if (rows.empty()) return "";
  return "\nNot unique: the loop is closed in the directions " + support::joined(rows) +
         " anyway and carries nothing there,\nso what joints carry in these directions depends on where the loop is "
         "cut.";
}

}  // namespace

std::vector<Artefact> joint_reactions_artefact(Mechanics& mechanics) {
  if (mechanics.model.joints.empty()) return {};
  ArtefactBuilder builder(
      "joint_reactions",
      "Force and moment that the child of each joint feels from its parent, in space axes, the moment\n"
      "about the origin of the child." +
          drives(mechanics.model) + indeterminate(mechanics.model),
      mechanics);
  Steps steps;
  builder.result_type("JointReactions");
  builder.with_solution_status();
  for (const strategy::JointReaction& reaction :
       strategy::joint_reactions(mechanics.model, mechanics.dynamics, mechanics.solution, steps)) {
    builder.fields(reaction.joint, emit::pascal_case(reaction.joint) + "Wrench",
                   "on " + reaction.child + " from " + reaction.parent + " in joint " + reaction.joint,
                   {{"force", "[N], space axes", {3}, ids(reaction.force)},
                    {"moment", "[N*m], space axes, about the origin of " + reaction.child, {3}, ids(reaction.moment)}});
  }
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

}  // namespace gaussgen
