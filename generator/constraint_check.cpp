#include "constraint_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "agreement.hpp"
#include "artefact_builder.hpp"
#include "general_solution.hpp"
#include "nearest_position.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

namespace code = support::code;

ConstraintCheck::ConstraintCheck(Mechanics& mechanics, ModelValues& values, bool is_emitted,
                                 support::Diagnostics& diagnostics)
    : mechanics_(mechanics),
      values_(values),
      is_emitted_(is_emitted),
      diagnostics_(diagnostics),
      dependences_(dependences(mechanics, values)) {}

bool ConstraintCheck::has_general_solution() const {
  return mechanics_.dynamics.l() > 0 && contradictory_.empty() &&
         general_solution(mechanics_, values_, dependences_).has_value();
}

bool ConstraintCheck::leave_undetermined() const {
  if (!has_dependent() || !contradictory_.empty() || !has_general_way(mechanics_)) return false;
  if (!is_undetermined_) is_undetermined_ = is_undetermined(mechanics_, values_, dependences_);
  return *is_undetermined_;
}

void ConstraintCheck::report(const std::vector<std::size_t>& constraints, const std::string& message,
                             const std::string& hint) {
  contradictory_.insert(constraints.begin(), constraints.end());
  const support::Span span = mechanics_.model.constraints[constraints.back()].name.span;
  if (is_emitted_) {
    diagnostics_.error(code::k_contradiction, span, message, hint);
  } else {
    diagnostics_.warning(code::k_contradictory_start, span, message, hint);
  }
}

void ConstraintCheck::report_positions(const std::vector<Violation>& violated) {
  for (const Violation& violation : violated) violated_.insert(violation.index);
  const auto is_of_positions = [](const Violation& violation) { return violation.is_of_positions; };
  if (std::none_of(violated.begin(), violated.end(), is_of_positions)) return;
  const auto found = contradictory_positions(mechanics_);
  if (!found) return;
  for (const Violation& violation : violated) {
    if (violation.is_of_positions) contradictory_.insert(violation.index);  // by where the first search gave up
  }
  std::vector<std::string> residuals;
  for (const double residual : found->residuals) residuals.push_back(fmt::format("{:.3g}", residual));
  const bool is_one = found->constraints.size() == 1;
  report(found->constraints,
         fmt::format("no position near the initial one satisfies {}{}: the nearest violates {} by {}",
                     names_of(mechanics_, found->constraints), is_one ? "" : " together", is_one ? "it" : "them",
                     support::joined(residuals)),
         "check lengths and places in what they relate, or begin near another position");
}

void ConstraintCheck::report_contradictions() {
  for (const Dependence& found : dependences_) {
    if (found.agreement == Agreement::agree || is_contradictory(found.index) || passed_over_.count(found.index) > 0)
      continue;
    std::vector<std::size_t> all = found.others;
    all.push_back(found.index);
    report(all, contradiction_in(mechanics_, found) + " at the initial state",
           found.everywhere
               ? "they limit the same motion and ask different things of it: correct one of them, or remove it"
               : "start from another state, or remove a constraint");
  }
}

std::vector<std::size_t> ConstraintCheck::independent() const {
  std::vector<std::size_t> rows;
  for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
    const bool follows =
        std::any_of(dependences_.begin(), dependences_.end(), [&](const Dependence& one) { return one.index == mu; });
    if (!follows) rows.push_back(mu);
  }
  return rows;
}

// One message for the rows of one entry of the model.
void ConstraintCheck::report_redundant() {
  std::vector<Redundancy> all;
  for (const Dependence& found : dependences_) {
    if (is_contradictory(found.index) || passed_over_.count(found.index) > 0) continue;
    const auto begin = mechanics_.model.constraints[found.index].name.span.begin;
    const double part = found.is_exact ? 0 : rank_tolerance(mechanics_.model);
    const auto elsewhere =
        found.everywhere ? agree_elsewhere(mechanics_, found.others, independent(), found.index, part) : std::nullopt;
    const bool is_same = !all.empty() && all.back().everywhere == found.everywhere &&
                         all.back().by_another == found.by_another && all.back().agrees_elsewhere == elsewhere &&
                         all.back().others.empty() == found.others.empty() && all.back().is_exact == found.is_exact &&
                         mechanics_.model.constraints[all.back().rows.back()].name.span.begin == begin;
    if (!is_same) all.push_back({{}, {}, found.everywhere, found.by_another, found.is_exact, elsewhere});
    all.back().rows.push_back(found.index);
    all.back().others.insert(found.others.begin(), found.others.end());
  }
  for (const Redundancy& one : all) report_redundant(one);
}

namespace {

/// A row of `rolls` or `coincide` has no entry of its own.
std::string remedy_for_redundant(const model::Constraint& row, Mechanics& mechanics, bool is_determined) {
  if (!is_determined) return "the others leave some acceleration undetermined: let it say something, or remove it";
  if (!has_general_way(mechanics)) return "remove it; accelerations are right, and status says dependent_constraints";
  const std::string kept = "accelerations are right, and of multipliers that do the same the least are returned";
  if (!row.may_vanish) return "remove it, or leave it: " + kept;
  return std::holds_alternative<model::SlipLaw>(row.law)
             ? kept + "; for unique ones, write 'no_slip' in the directions that are needed instead of 'rolls'"
             : kept +
                   "; for unique ones, 'in: frame' with an axis across the plane of a loop leaves a row out, and "
                   "'equation' states those that are needed";
}

/// As far as it was looked at.
std::string agreement_in_words(bool is_one, const std::optional<bool>& elsewhere) {
  const std::string agrees = is_one ? ", and agrees" : ", and agree";
  if (elsewhere == true) return agrees + ": ";
  return agrees +
         (elsewhere ? " at the initial state, but not in other states or at other times: " : " at the initial state: ");
}

const char* remedy_at_start(const model::Constraint& row) {
  if (!row.may_vanish) return "multipliers are not unique there: start from another state, or remove a constraint";
  const auto* position = std::get_if<model::PositionLaw>(&row.law);
  return position != nullptr && position->is_coincidence
             ? "multipliers are not unique there: start from another state; in a loop whose plane turns, 'in: frame' "
               "with an axis across that plane leaves this row out"
             : "multipliers are not unique there: start from another state";
}

}  // namespace

bool ConstraintCheck::is_agreement_unknown(const Redundancy& found) const {
  const auto is_violated = [&](std::size_t row) { return violated_.count(row) > 0; };
  return !found.agrees_elsewhere && (std::any_of(found.rows.begin(), found.rows.end(), is_violated) ||
                                     std::any_of(found.others.begin(), found.others.end(), is_violated));
}

void ConstraintCheck::report_redundant(const Redundancy& found) {
  const std::size_t first = found.rows.front();
  const model::Name& name = mechanics_.model.constraints[first].name;
  std::string what = dependence_in(mechanics_, found.rows, {found.others.begin(), found.others.end()});
  if (!found.is_exact) what += fmt::format(" up to an angle below {:.1g}", rank_tolerance(mechanics_.model));
  if (found.by_another) what += " at the initial state (elsewhere, another constraint follows)";
  if (!found.everywhere) {
    diagnostics_.warning(code::k_dependent_start, name.span, what + " at the initial state",
                         remedy_at_start(mechanics_.model.constraints[first]));
    return;
  }
  if (!found.is_exact && !mechanics_.model.rank_tolerance) {
    if (!has_general_way(mechanics_)) return;  // nothing is divided by what is small: the rows are told apart
    diagnostics_.warning(code::k_redundant_constraint, name.span,
                         what +
                             ": emitted code in double takes them as one, with status dependent_constraints unless "
                             "rounding covers the difference altogether",
                         "if it ought to follow, give numbers more digits, or say 'rank_tolerance: 1e-8'; if not, "
                         "state the difference itself, since the motion depends on it");
    return;
  }
  const auto& redundant = mechanics_.solution.redundant;
  const bool is_zero =
      !has_general_way(mechanics_) && std::find(redundant.begin(), redundant.end(), name.text) != redundant.end();
  diagnostics_.warning(
      code::k_redundant_constraint, name.span,
      what + (is_agreement_unknown(found) ? ": " : agreement_in_words(found.rows.size() == 1, found.agrees_elsewhere)) +
          (is_zero ? "its multiplier is returned as 0" : "multipliers are not unique") +
          fmt::format(" (mobility {})", mobility(mechanics_)),
      found.agrees_elsewhere == false
          ? "where they do not agree no motion satisfies both, and 'project' says violated_constraints: correct one of "
            "them, or remove it"
      : is_agreement_unknown(found)
          ? "where no state satisfies both, correct one of them, or remove it"
          : remedy_for_redundant(mechanics_.model.constraints[first], mechanics_, !leave_undetermined()));
}

}  // namespace gaussgen
