#include "read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generic_point.hpp"
#include "model/build.hpp"
#include "model/unused.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

using model::Constraint;
using model::name_in_file;

bool may_vanish(const Constraint& constraint) { return constraint.may_vanish; }

/// Names of rows with φ = 0 at every state. What has no value is reported later.
std::set<std::string> vanishing_rows(const model::Model& model) {
  std::set<std::string> names;
  KinematicModel motion(model, false);
  GenericPoint at_generic_point(motion);
  const auto vanishes = [&](ir::Expr expression) {
    return !motion.graph.is_undefined(expression.id()) && cln::zerop(at_generic_point({{expression}})(0, 0));
  };
  for (const kinematics::ConstraintRow& row : motion.kinematics.constraints) {
    if (vanishes(row.phi) && (!row.f || vanishes(*row.f))) names.insert(row.name);
  }
  return names;
}

/// A constraint of which no direction is left says nothing at all.
void report_idle(const model::Model& model, const std::set<std::string>& vanishing, support::Diagnostics& diagnostics) {
  std::set<std::string> reported;
  for (const Constraint& constraint : model.constraints) {
    const auto same = [&](const Constraint& other) { return name_in_file(other) == name_in_file(constraint); };
    const bool is_idle = std::all_of(model.constraints.begin(), model.constraints.end(), [&](const Constraint& other) {
      return !same(other) || (other.may_vanish && vanishing.count(other.name.text) > 0);
    });
    if (!is_idle || !reported.insert(name_in_file(constraint)).second) continue;
    diagnostics.error(support::code::k_no_velocity, constraint.name.span,
                      "this constraint holds in every motion that the coordinates allow: it says nothing",
                      "remove it, or give the bodies coordinates for the motion that it is to prevent");
  }
}

/// Formulas may mention what is about to be dropped.
void report_reactions_of(const std::set<std::string>& vanishing, const model::Model& model,
                         support::Diagnostics& diagnostics) {
  for (const Constraint& row : model.constraints) {
    const auto is_its = [&](const model::NamedReaction& one) {
      return !one.is_held && one.is_of_user && one.of == row.name.text;
    };
    const bool is_mentioned = std::any_of(model.reactions.begin(), model.reactions.end(), is_its);
    if (!is_mentioned || !row.may_vanish || vanishing.count(row.name.text) == 0) continue;
    diagnostics.error(
        support::code::k_wrong_reference, row.name.span,
        fmt::format("a formula mentions '{}.reaction', and coordinates hold that motion anyway", row.name.text),
        "mention the reaction of what holds it, as that of a held coordinate");
  }
}

void drop_vanishing_rows(model::Model& model, support::Diagnostics& diagnostics) {
  if (std::none_of(model.constraints.begin(), model.constraints.end(), may_vanish)) return;
  const std::set<std::string> vanishing = vanishing_rows(model);
  report_idle(model, vanishing, diagnostics);
  report_reactions_of(vanishing, model, diagnostics);
  for (model::NamedReaction& one : model.reactions) {
    if (!one.is_held && vanishing.count(one.of) > 0) one.is_absent = true;
  }
  const auto drops = [&](const Constraint& row) { return row.may_vanish && vanishing.count(row.name.text) > 0; };
  for (const Constraint& row : model.constraints) {
    if (!drops(row)) continue;
    if (std::holds_alternative<model::PositionLaw>(row.law)) model.idle_closures.push_back(row.name.text);
    if (std::holds_alternative<model::SlipLaw>(row.law)) model.idle_slips.push_back(row);
  }
  model.constraints.erase(std::remove_if(model.constraints.begin(), model.constraints.end(), drops),
                          model.constraints.end());
}

}  // namespace

std::optional<model::Model> read_model(support::Source& source, support::Diagnostics& diagnostics,
                                       const model::Choices& choices) {
  std::optional<model::Model> model = model::build_model(source, diagnostics, choices);
  if (!model) return std::nullopt;
  if (!model->leaves_out) model::check_uses(*model, source, diagnostics);
  drop_vanishing_rows(*model, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return model;
}

}  // namespace gaussgen
