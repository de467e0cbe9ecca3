#include "artefact_builder.hpp"

#include <algorithm>

#include "conserved_energy.hpp"
#include "ir/contract.hpp"
#include "ir/cost.hpp"
#include "kinematics/body_motions.hpp"
#include "strategy/composite_metric.hpp"
#include "strategy/compulsion.hpp"
#include "strategy/link_compulsion.hpp"
#include "strategy/link_energy.hpp"
#include "strategy/quaternions.hpp"
#include "strategy/state_search.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::NodeId;
using ir::Expr;
using strategy::Steps;
using strategy::Vector;

namespace {

bool has_massless_body(Mechanics& mechanics) {
  return std::any_of(mechanics.model.bodies.begin(), mechanics.model.bodies.end(), [&](const model::Body& body) {
    if (mechanics.expressions(body.mass).is_zero()) return true;
    if (!body.inertia) return false;
    const ir::Matrix3 inertia = kinematics::inertia_matrix(*body.inertia, mechanics.expressions);
    return inertia[0][0].is_zero() || inertia[1][1].is_zero() || inertia[2][2].is_zero();
  });
}

/// A result with the steps to it.
template <class Result>
struct Form {
  Result result;
  Steps steps;
};

/// Link by link, or by what all coordinates do to each body where that takes fewer operations.
template <class Result, class ByLinks, class ByBodies, class Values>
Form<Result> shorter(const Mechanics& mechanics, ByLinks by_links, ByBodies by_bodies, Values values) {
  Form<std::optional<Result>> links{std::nullopt, {}};
  links.result = by_links(*mechanics.linkage, links.steps);
  if (links.result && mechanics.dynamics.n() > k_few_speeds) return {std::move(*links.result), std::move(links.steps)};
  Steps of_bodies;
  Form<Result> bodies{by_bodies(of_bodies), std::move(of_bodies)};
  const auto operations = [&](const Result& result) { return ir::operations(mechanics.graph, values(result)); };
  if (!links.result || operations(bodies.result) <= operations(*links.result)) return bodies;
  return {std::move(*links.result), std::move(links.steps)};
}

void add_norms(const Mechanics& mechanics, std::vector<Field>& fields) {
  Vector norms = strategy::squared_norms(mechanics.symbols, configuration_of(mechanics));
  for (Expr& norm : norms) norm = norm - mechanics.expressions.number(1);
  if (norms.empty()) return;
  fields.push_back(
      {"quaternion", "squared norm of each quaternion, less 1", {static_cast<int>(norms.size())}, ids(norms)});
}

void add_positions(const Mechanics& mechanics, std::vector<Field>& fields) {
  Vector values;
  for (const auto& row : mechanics.kinematics.constraints) {
    if (row.f) values.push_back(*row.f);
  }
  if (values.empty()) return;
  fields.push_back({"position", "f of each equation of positions", {static_cast<int>(values.size())}, ids(values)});
}

struct Energy {
  Expr kinetic, potential;
};

std::optional<Energy> energy_by_links(Mechanics& mechanics, const kinematics::Linkage& linkage, Steps& steps) {
  const ir::Vector3& field = mechanics.kinematics.field;
  const strategy::LinkEnergy found = strategy::energy_of_links(linkage, field, steps);
  Energy energy{found.kinetic, found.of_field + *mechanics.kinematics.other_potential};
  for (const model::Body& body : mechanics.model.bodies) {
    if (body.frame != model::k_space && linkage.ends[body.frame] != kinematics::k_ground) continue;
    energy.potential -= mechanics.expressions(body.mass) * dot(field, mechanics.expressions(body.centre));
  }
  return energy;
}

}  // namespace

Artefact energy_artefact(Mechanics& mechanics) {
  ArtefactBuilder builder("energy",
                          "Kinetic energy, potential energy of uniform fields, potentials and springs, and their sum.",
                          mechanics);
  auto [energy, steps] = shorter<Energy>(
      mechanics,
      [&](const kinematics::Linkage& linkage, Steps& own) { return energy_by_links(mechanics, linkage, own); },
      [&](Steps&) {
        return Energy{mechanics.covariant->kinetic_energy, *mechanics.kinematics.potential};
      },
      [](const Energy& found) {
        return std::vector<NodeId>{found.kinetic.id(), found.potential.id()};
      });
  steps.begin("energies");
  builder.result_type("Energy");
  builder.artefact().takes_inputs = false;
  builder.artefact().constants.push_back({"is_conserved", conserves_energy(mechanics, energy.kinetic, energy.potential),
                                          "whether it is the same in every motion, by the form of the model"});
  const Expr kinetic = steps.name(energy.kinetic, "kinetic_energy");
  const Expr potential = steps.name(energy.potential, "potential_energy");
  builder.fields("", "", "",
                 {{"kinetic", "[J]", {}, {kinetic.id()}},
                  {"potential", "[J]", {}, {potential.id()}},
                  {"total", "[J]", {}, {(kinetic + potential).id()}}});
  return builder.finish(steps);
}

namespace {

/// Nothing where no motion of the bodies takes up forces that are known by generalized components.
std::optional<strategy::Compulsion> compulsion(Mechanics& mechanics, Steps& steps) {
  const Vector candidate = candidate_accelerations(mechanics);
  auto [found, own] = shorter<std::optional<strategy::Compulsion>>(
      mechanics,
      [&](const kinematics::Linkage& linkage, Steps& of_links) -> std::optional<std::optional<strategy::Compulsion>> {
        auto by_links =
            strategy::compulsion_of_links(mechanics.dynamics, linkage, candidate, mechanics.epsilon(), of_links);
        if (!by_links) return std::nullopt;
        return by_links;
      },
      [&](Steps& of_bodies) {
        return strategy::compulsion(mechanics.dynamics, candidate, mechanics.epsilon(), of_bodies);
      },
      [](const std::optional<strategy::Compulsion>& result) {
        return result ? std::vector<NodeId>{result->Z.id()} : std::vector<NodeId>();
      });
  steps.append(own);
  return found;
}

}  // namespace

bool has_compulsion(Mechanics& mechanics) {
  return !has_massless_body(mechanics) && strategy::has_compulsion(mechanics.dynamics);
}

std::vector<Artefact> compulsion_artefact(Mechanics& mechanics) {
  if (has_massless_body(mechanics)) return {};
  ArtefactBuilder builder(
      "compulsion",
      "Gauss's function Z_w (1.18) of candidate accelerations, as a complete square over the bodies:\n"
      "least, among all accelerations that the constraints allow, at those of rhs.",
      mechanics);
  Steps steps;
  builder.result_type("Compulsion");
  builder.artefact().takes_accelerations = true;
  const auto found = compulsion(mechanics, steps);
  if (!found) return {};
  builder.with_singular_metric(found->singular_metric);
  builder.fields("", "", "", {{"Z", "[N^2/kg]", {}, {found->Z.id()}}});
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

bool has_quaternions(const Mechanics& mechanics) {
  return !strategy::squared_norms(mechanics.symbols, configuration_of(mechanics)).empty();
}

std::vector<Artefact> residuals_artefact(Mechanics& mechanics) {
  ArtefactBuilder builder("residuals",
                          "How far a state, and candidate accelerations, are from satisfying the constraints.\n"
                          "Held coordinates satisfy theirs by construction.",
                          mechanics);
  builder.with_any_quaternion();
  std::vector<Field> fields;
  add_norms(mechanics, fields);
  const Vector candidate = candidate_accelerations(mechanics);
  add_positions(mechanics, fields);
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
    fields.push_back({"velocity", "phi of each constraint (3.1); df/dt of an equation f", {l}, ids(velocity)});
    fields.push_back({"acceleration", "dphi/dt of each constraint", {l}, ids(acceleration)});
  }
  if (fields.empty()) return {};
  builder.result_type("Residuals");
  builder.artefact().takes_accelerations = true;
  builder.fields("", "", "", std::move(fields));
  std::vector<Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

std::vector<Artefact> quantities_artefact(Mechanics& mechanics) {
  const std::vector<model::NamedQuantity>& quantities = mechanics.model.quantities;
  if (quantities.empty()) return {};
  ArtefactBuilder builder("quantities", "What the model names under 'quantities', at a state.", mechanics);
  builder.result_type("Quantities");
  std::vector<Field> fields;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const model::NamedQuantity& quantity = quantities[i];
    const std::vector<Expr>& values = mechanics.kinematics.quantities[i];
    std::vector<int> shape;
    if (values.size() > 1) shape.push_back(static_cast<int>(values.size()));
    const std::string unit = quantity.unit.empty() ? "" : "[" + quantity.unit + "]";
    const std::string about = unit + (unit.empty() || quantity.about.empty() ? "" : " ") + quantity.about;
    fields.push_back({quantity.name.text, about, shape, ids(values)});
  }
  builder.fields("", "", "", std::move(fields));
  std::vector<Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

std::vector<Artefact> guards_artefact(Mechanics& mechanics) {
  const std::vector<model::Guard>& guards = mechanics.model.guards;
  if (guards.empty()) return {};
  ArtefactBuilder builder(
      "guards", "What ends this regime where it falls through 0, with what goes along (regimes.md).", mechanics);
  builder.result_type("Guards");
  std::vector<Field> fields;
  for (std::size_t i = 0; i < guards.size(); ++i) {
    const char* const about = guards[i].kind == model::Guard::Kind::falls ? "ends the regime where it falls below 0"
                              : guards[i].kind == model::Guard::Kind::rate_of_gap ? "rate of the gap before it"
                                                                                  : "slip of friction that slides";
    fields.push_back({guards[i].name, about, {}, {mechanics.kinematics.guards[i].id()}});
  }
  builder.fields("", "", "", std::move(fields));
  std::vector<Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

std::vector<Artefact> impact_system_artefact(Mechanics& mechanics) {
  const kinematics::SwitchRows& switches = mechanics.kinematics.switches;
  strategy::Matrix rows;
  const strategy::Matrix& limits = switches.limits;
  Vector rates, gaps;
  const auto add = [&](const kinematics::ConstraintRow& row) {
    rows.push_back(gradient_of(mechanics, row));
    rates.push_back(row.phi);
  };
  for (const kinematics::ConstraintRow& row : mechanics.kinematics.constraints) add(row);
  for (const kinematics::ConstraintRow& row : switches.contacts) {
    add(row);
    gaps.push_back(*row.f);
  }
  for (const auto& slips : switches.frictions) {
    for (const kinematics::ConstraintRow& row : slips) add(row);
  }
  ArtefactBuilder builder("impact_system",
                          "What impulses act on: inertia, and rows along which they do (theory.md, section 11).",
                          mechanics);
  builder.result_type("ImpactSystem");
  const int n = static_cast<int>(mechanics.dynamics.n()), l = static_cast<int>(rows.size());
  const int c = static_cast<int>(gaps.size()), f = static_cast<int>(limits.size());
  const strategy::Matrix& g = mechanics.dynamics.g;
  std::vector<Field> fields{
      {"g", "the metric of the free speeds (1.10)", {n, n}, ids(g)},
      {"rows", "dphi/du of constraints, then of gaps of contacts, then of slips of friction", {l, n}, ids(rows)},
      {"rates", "phi of each of them", {l}, ids(rates)}};
  if (c > 0) fields.push_back({"gaps", "of each contact", {c}, ids(gaps)});
  if (c > 0 && f > 0)
    fields.push_back({"limits", "of each friction per reaction of each contact", {f, c}, ids(limits)});
  builder.fields("", "", "", std::move(fields));
  std::vector<Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

Artefact mass_matrix_artefact(Mechanics& mechanics) {
  ArtefactBuilder builder("mass_matrix", "The metric g of the free speeds (1.10).", mechanics);
  builder.result_type("MassMatrix");
  builder.artefact().takes_inputs = false;
  Form<strategy::Matrix> form{{}, {}};
  if (mechanics.dynamics.n() > k_few_speeds) {
    form.result = mechanics.dynamics.g;
  } else {
    form = shorter<strategy::Matrix>(
        mechanics,
        [&](const kinematics::Linkage& linkage, Steps& own) -> std::optional<strategy::Matrix> {
          return strategy::composite_metric(linkage, mechanics.dynamics.labels, mechanics.graph, own);
        },
        [&](Steps&) -> strategy::Matrix { return mechanics.dynamics.g; },
        [](const strategy::Matrix& g) { return ids(g); });
  }
  const int n = static_cast<int>(mechanics.dynamics.n());
  builder.fields("", "", "", {{"g", "symmetric, in the order of the speeds", {n, n}, ids(form.result)}});
  return builder.finish(form.steps);
}

}  // namespace gaussgen
