#include "initial_check.hpp"

#include <fmt/format.h>

#include "evaluate/decimal.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

constexpr int k_digits = 17;
constexpr int k_residual_digits = 13;

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  }
  return text;
}

class InitialCheck {
 public:
  InitialCheck(Mechanics& mechanics, support::Diagnostics& diagnostics)
      : mechanics_(mechanics),
        model_(mechanics.model),
        diagnostics_(diagnostics),
        values_(mechanics, support::Rational(0), k_digits) {}

  void run() {
    const std::vector<InitialValue> state = initial_values(mechanics_);
    if (!bind_initial_values(state, values_)) return report_undefined_state(state);
    bool has_equations = true;
    for (std::size_t mu = 0; mu < model_.constraints.size(); ++mu) {
      has_equations = !report_undefined_constraint(mu) && has_equations;
    }
    for (const Violation& violation : violations(mechanics_, values_)) report_violation(violation);
    if (has_equations) report_singular();
  }

 private:
  void report_undefined_state(const std::vector<InitialValue>& state) {
    for (const InitialValue& value : state) {
      const auto trouble = values_.trouble(value.node);
      if (!trouble) continue;
      diagnostics_.warning(support::code::k_undefined_start, model_.name.span,
                           fmt::format("the initial value of {} is undefined: {}", value.name, trouble->reason),
                           "check the initial values and the rates that the constraints determine");
      return;
    }
  }

  bool report_undefined_constraint(std::size_t mu) {
    const auto trouble = values_.trouble(row(mu).phi.id());
    if (!trouble) return false;
    diagnostics_.warning(
        support::code::k_undefined_start, model_.constraints[mu].velocity.span,
        fmt::format("constraint '{}' has no value at the initial state: {}", row(mu).name, trouble->reason),
        "start from another state");
    return true;
  }

  void report_violation(const Violation& violation) {
    diagnostics_.warning(support::code::k_violating_start, model_.constraints[violation.index].velocity.span,
                         fmt::format("the initial state violates constraint '{}' by {}", violation.row->name,
                                     evaluate::to_decimal(violation.residual, 3)),
                         remedy(*violation.row));
  }

  // A pivot that is zero from the start divides; one that cancels is flagged.
  void report_singular() {
    std::string reason = why_undetermined(mechanics_, values_);
    if (values_.is_true(mechanics_.solution.singular_mass_matrix)) reason = "the mass matrix is singular";
    for (const ir::Expr acceleration : mechanics_.solution.accelerations) {
      const auto trouble = values_.trouble(acceleration.id());
      if (trouble && reason.empty()) reason = trouble->reason + " in " + trouble->name;
    }
    if (reason.empty()) return;
    diagnostics_.warning(
        support::code::k_singular_start, model_.name.span, "there are no accelerations at the initial state: " + reason,
        "where coordinates do not describe every motion, start elsewhere; a quaternion has no such places");
  }

  // An open rate is searched for by Newton's method where the constraint is nonlinear; from 0 it may have no way to go.
  std::string remedy(const kinematics::ConstraintRow& row) {
    std::vector<std::string> given;
    std::vector<std::string> open;
    std::vector<std::string> stuck;
    const std::vector<bool> is_given = given_speeds();
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const auto b = values_(row.beta[mechanics_.symbols.full(i)].id());
      const std::string& name = mechanics_.symbols.speeds[i].name;
      if (b && !cln::zerop(*b)) (is_given[i.value] ? given : open).push_back(name);
      const bool is_involved = !row.beta[mechanics_.symbols.full(i)].is_zero();
      if (!row.is_linear && is_involved && !is_given[i.value]) stuck.push_back(name);
    }
    if (!stuck.empty()) {
      return fmt::format("{} is open: give it an initial_rate_guess from which the search can start", joined(stuck));
    }
    if (!given.empty()) return fmt::format("leave {} open, and the constraint determines it", joined(given));
    if (!open.empty()) return fmt::format("no values of {} satisfy all constraints", joined(open));
    return "no speed acts on it at this state; start from another one";
  }

  /// In the order of the speeds: those that the model states.
  std::vector<bool> given_speeds() const {
    std::vector<bool> result;
    for (const model::Coordinate& coordinate : model_.coordinates) {
      if (!coordinate.held_at) result.push_back(coordinate.initial_rate.has_value());
    }
    for (const model::Orientation& orientation : model_.orientations) {
      for (const auto& component : orientation.initial_angular_velocity) result.push_back(component.has_value());
    }
    return result;
  }

  const kinematics::ConstraintRow& row(std::size_t mu) const {
    return mechanics_.kinematics.constraints[kinematics::ConstraintIndex{mu}];
  }

  Mechanics& mechanics_;
  const model::Model& model_;
  support::Diagnostics& diagnostics_;
  ModelValues values_;
};

}  // namespace

std::vector<Violation> violations(const Mechanics& mechanics, ModelValues& values) {
  std::vector<Violation> result;
  for (const auto mu : mechanics.kinematics.constraints.indices()) {
    const kinematics::ConstraintRow& row = mechanics.kinematics.constraints[mu];
    const std::optional<cln::cl_F> phi = values.residual(row.phi.id(), k_residual_digits);
    if (phi && !cln::zerop(*phi)) result.push_back({mu.value, &row, *phi});
  }
  return result;
}

void check_initial_state(Mechanics& mechanics, support::Diagnostics& diagnostics) {
  InitialCheck(mechanics, diagnostics).run();
}

}  // namespace gaussgen
