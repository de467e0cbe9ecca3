#include "structure_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "generic_point.hpp"
#include "model/expressions.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"
#include "value_check.hpp"

namespace gaussgen {

namespace {

bool is_chosen(const Mechanics& mechanics, std::size_t speed) {
  const std::vector<model::Name>& chosen = mechanics.model.dependent;
  return std::any_of(chosen.begin(), chosen.end(),
                     [&](const model::Name& name) { return name.text == mechanics.dynamics.labels[speed]; });
}

support::Span span_of_choice(const model::Model& model) {
  return {model.dependent.front().span.begin, model.dependent.back().span.end};
}

class StructureCheck {
 public:
  StructureCheck(Mechanics& mechanics, support::Diagnostics& diagnostics)
      : mechanics_(mechanics), model_(mechanics.model), diagnostics_(diagnostics), at_generic_point_(mechanics) {}

  void run() {
    for (std::size_t mu = 0; mu < model_.constraints.size(); ++mu) check_gradient(mu);
    if (!diagnostics_.has_errors()) check_equations(mechanics_, diagnostics_);
    if (diagnostics_.has_errors()) return;
    if (!mechanics_.solution.undetermined.empty()) {
      report_undetermined();
    } else {
      check_accelerations();
    }
    if (!model_.dependent.empty()) check_choice();
    if (mechanics_.has_unsolved_reactions) report_reactions();
    for (const std::size_t force : mechanics_.kinematics.idle_forces) {
      if (!depends_on_absent_reaction(model_.forces[force])) report_idle(model_.forces[force]);
    }
    for (const std::size_t force : mechanics_.kinematics.inner_forces) report_inner(model_.forces[force]);
    for (const model::Constraint& constraint : model_.constraints) check_contact(constraint);
    check_gaps();
  }

 private:
  void check_gaps() {
    const auto& rows = mechanics_.kinematics.switches.contacts;
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const auto& beta = rows[c].beta;
      if (std::any_of(beta.begin(), beta.end(), [](const ir::Expr& entry) { return !entry.is_zero(); })) continue;
      const model::Contact& contact = model_.contacts[c];
      diagnostics_.error(support::code::k_no_velocity, contact.gap.span,
                         fmt::format("the gap of the contact '{}' does not depend on any free coordinate: what it "
                                     "says of them cancels",
                                     contact.name.text),
                         "a gap changes as the model moves: write it with coordinates, or places such as tip.z");
    }
  }

  void report_reactions() {
    const std::string& first = model_.reactions.front().of;
    diagnostics_.error(
        support::code::k_coupled_reactions, model_.name.span,
        fmt::format("forces depend on reactions ('{}.reaction' among them) that do not follow from their equations",
                    first),
        "let fewer forces depend on reactions; what has a value without them is given by a formula");
  }

  /// Of `rolls`, once for its rows. Where a `no_slip` in one direction is meant, as of a blade, a body takes its place along.
  void check_contact(const model::Constraint& constraint) {
    const auto* law = std::get_if<model::SlipLaw>(&constraint.law);
    const auto* place = law != nullptr ? std::get_if<std::size_t>(&law->at) : nullptr;
    const bool is_rolling = place != nullptr && constraint.may_vanish && *place != model::k_space;
    if (!is_rolling || !is_part_of(*place, law->frame) || !contacts_.insert(constraint.name.span.begin).second) return;
    const std::string point = model_.frames[*place].name.text;
    diagnostics_.warning(support::code::k_carried_contact, constraint.span,
                         fmt::format("'{}' rolls at '{}', a place of its own: that is a pin, and nothing rolls",
                                     model_.frames[law->frame].name.text, point),
                         "a contact moves over the body: put it on a frame that does not take part in the turn, or "
                         "write where it is in space; "
                         "for a pin, write 'coincide'");
  }

  /// On the same link: what a fixed joint holds is part of it, too, other than for inner forces, which the joint transmits.
  bool is_part_of(std::size_t place, std::size_t frame) {
    const auto& places = mechanics_.linkage->places;
    return places[place] && places[frame] && places[place]->is_fixed && places[frame]->is_fixed &&
           places[place]->link == places[frame]->link && places[frame]->link != kinematics::k_ground;
  }

  void check_gradient(std::size_t mu) {
    if (generic_rank(at_generic_point_({mechanics_.dynamics.b[mu]})) > 0) return;
    report_no_gradient(model_.constraints[mu], diagnostics_);
  }

  bool has_absent_reaction(const model::Ast& ast) const {
    if (ast.kind == model::AstKind::symbol) {
      const model::SymbolRef symbol = model_.resolve(ast.name);
      return symbol.kind == model::SymbolKind::reaction && model_.reactions[symbol.index].is_absent;
    }
    return std::any_of(ast.children.begin(), ast.children.end(),
                       [&](const model::Ast& child) { return has_absent_reaction(child); });
  }

  /// It is felt in another regime: that of smooth friction, where what presses is open in this one.
  bool depends_on_absent_reaction(const model::Force& force) const {
    bool is_found = false;
    model::for_each_expression_of(force,
                                  [&](const model::Ast& ast) { is_found = is_found || has_absent_reaction(ast); });
    return is_found;
  }

  bool is_on_space(const model::PointForce& law) const {
    return law.frame != model::k_space && model::pushed_by_force_on(model_, law.frame) == model::k_space;
  }

  void report_idle(const model::Force& force) {
    const bool is_torque = std::holds_alternative<model::Torque>(force.law);
    if (const auto* law = std::get_if<model::PointForce>(&force.law); law != nullptr && is_on_space(*law)) {
      diagnostics_.warning(support::code::k_idle_force, force.name.span,
                           fmt::format("nothing feels the force '{}': '{}' is a point of space", force.name.text,
                                       model_.frames[law->frame].name.text),
                           "let it act on a body; something without mass that moves along is one of the 'frames'");
      return;
    }
    diagnostics_.warning(
        support::code::k_idle_force, force.name.span, fmt::format("nothing feels the force '{}'", force.name.text),
        is_torque ? "a particle and what does not turn take no torque; let it act on a body or a frame that turns"
                  : "let it act on something that moves, or remove it; between a place and itself it vanishes");
  }

  void report_inner(const model::Force& force) {
    diagnostics_.warning(
        support::code::k_idle_force, force.name.span,
        fmt::format("the force '{}' moves nothing: it and its opposite act on one rigid part", force.name.text),
        "let it act between parts that move against each other, or remove it");
  }

  // Constraints alone determine what no mass resists, as long as they are enough; then the model is sound.
  bool is_determined() {
    return generic_rank(at_generic_point_(strategy::g_above_b(mechanics_.dynamics))) == mechanics_.dynamics.n();
  }

  void report_undetermined() {
    if (is_determined()) return;
    for (const std::string& label : mechanics_.solution.undetermined) {
      diagnostics_.error(
          support::code::k_no_inertia, span_of_speed(model_, label),
          fmt::format("nothing determines the acceleration of '{}': the mass matrix is singular in every configuration",
                      label),
          "give what it moves a mass, or remove a coordinate that others already describe");
    }
  }

  /// A pivot may vanish in every configuration without vanishing as an expression. At run time its rounding would be all that is left of it.
  void check_accelerations() {
    if (VanishesEverywhere(mechanics_)(mechanics_.solution.singular_mass_matrix)) return;
    const strategy::Dynamics& dynamics = mechanics_.dynamics;
    std::vector<std::string> labels;
    for (const std::size_t j : dependent_columns(at_generic_point_(strategy::g_above_b(dynamics))))
      labels.push_back(dynamics.labels[j]);
    if (labels.empty()) return;
    const std::string what = labels.size() == 1
                                 ? fmt::format("determines the acceleration of '{}'", labels[0])
                                 : fmt::format("tells the accelerations of {} apart", support::joined(labels));
    diagnostics_.error(support::code::k_no_inertia, span_of_speed(model_, labels[0]),
                       fmt::format("nothing {}: the mass matrix is singular in every configuration", what),
                       "give what it moves a mass, or remove a coordinate that others already describe");
  }

  /// b_μρ over the speeds that the model calls dependent.
  strategy::Matrix chosen_block() const {
    strategy::Matrix block;
    for (const strategy::Vector& row : mechanics_.dynamics.b) {
      block.emplace_back();
      for (std::size_t j = 0; j < row.size(); ++j) {
        if (is_chosen(mechanics_, j)) block.back().push_back(row[j]);
      }
    }
    return block;
  }

  void check_choice() {
    if (generic_rank(at_generic_point_(chosen_block())) == mechanics_.dynamics.l()) return;
    diagnostics_.error(support::code::k_dependent_speeds, span_of_choice(model_),
                       "the constraints do not determine these speeds by the others: det b over them vanishes in every "
                       "configuration",
                       "choose others, or leave the choice out");
  }

  Mechanics& mechanics_;
  const model::Model& model_;
  support::Diagnostics& diagnostics_;
  GenericPoint at_generic_point_;
  std::set<std::uint32_t> contacts_;  ///< reported, by where they begin in the text
};

}  // namespace

void check_structure(Mechanics& mechanics, support::Diagnostics& diagnostics) {
  check_values(mechanics, diagnostics);
  if (!diagnostics.has_errors()) StructureCheck(mechanics, diagnostics).run();
}

namespace {

void report_apart(const model::Constraint& row, support::Diagnostics& diagnostics) {
  diagnostics.error(support::code::k_no_velocity, row.span,
                    fmt::format("these places never coincide: they are apart along the direction of '{}', in which "
                                "no free coordinate moves them",
                                row.name.text),
                    "place them such that they can meet, as in one plane across the axes of a planar loop");
}

}  // namespace

void report_no_gradient(const model::Constraint& row, support::Diagnostics& diagnostics) {
  const auto* position = std::get_if<model::PositionLaw>(&row.law);
  if (position != nullptr && position->is_coincidence) return report_apart(row, diagnostics);
  diagnostics.error(
      support::code::k_no_velocity, row.span,
      fmt::format("the constraint '{}' does not depend on any free speed: what it says of them cancels", row.name.text),
      "remove it; a coordinate with a given value is declared with 'held_at'");
}

void report_redundant(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const auto& redundant = mechanics.solution.redundant;
  for (const model::Constraint& constraint : mechanics.model.constraints) {
    const std::string& name = constraint.name.text;
    if (std::find(redundant.begin(), redundant.end(), name) == redundant.end()) continue;
    diagnostics.warning(support::code::k_redundant_constraint, constraint.name.span,
                        fmt::format("constraint '{}' follows from the others: its multiplier is returned as 0", name),
                        "accelerations are right if the constraints agree; status says dependent_constraints");
  }
}

void check_choice(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  if (mechanics.model.dependent.empty()) return;
  std::vector<std::string> used;
  bool is_obeyed = true;
  for (const std::size_t j : mechanics.solution.dependent) {
    used.push_back(mechanics.dynamics.labels[j]);
    is_obeyed = is_obeyed && is_chosen(mechanics, j);
  }
  if (is_obeyed && !used.empty()) return;
  const std::string instead = used.empty() ? "the multiplier form" : "dependent speeds " + support::joined(used);
  diagnostics.warning(
      support::code::k_unsafe_choice, span_of_choice(mechanics.model),
      "emitted code does not eliminate these speeds: det b over them depends on the configuration, so it "
      "may vanish somewhere",
      "it takes " + instead + "; derivation and --route=paper take the choice as it is");
}

support::Span span_of_speed(const model::Model& model, const std::string& label) {
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.name.text == label) return coordinate.name.span;
  }
  for (const model::Speed& speed : model.speeds) {
    if (speed.name.text == label) return speed.name.span;
  }
  for (const model::Orientation& orientation : model.orientations) {
    for (const model::Name& name : orientation.angular_velocity) {
      if (name.text == label) return name.span;
    }
  }
  return model.name.span;
}

}  // namespace gaussgen
