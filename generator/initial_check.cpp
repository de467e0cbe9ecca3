#include "initial_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "artefact_builder.hpp"
#include "constraint_check.hpp"
#include "evaluate/decimal.hpp"
#include "general_start.hpp"
#include "generic_point.hpp"
#include "ir/contract.hpp"
#include "nearest_position.hpp"
#include "open_rates.hpp"
#include "strategy/projection.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"
#include "undefined_parts.hpp"
#include "usual_rank.hpp"
#include "vanishing_gradient.hpp"
#include "violation.hpp"

namespace gaussgen {

namespace {

constexpr int k_digits = 17;
constexpr int k_moved_digits = 12;
constexpr int k_shown_digits = 9;

/// Accelerations hold the second derivatives of positions.
constexpr int k_most_derivatives = 2;

/// False: it has no value.
bool bind_start(Mechanics& mechanics, ModelValues& values, std::vector<InitialValue>& state) {
  state = initial_values(mechanics, values);
  const bool has_state = bind_initial_values(mechanics, state, values);
  if (has_state && violations(mechanics, values).empty()) return true;
  find_start_otherwise(mechanics, support::Rational(0), k_digits);
  if (!mechanics.known_start) return has_state;
  state = initial_values(mechanics, values);
  return bind_initial_values(mechanics, state, values);
}

class InitialCheck {
 public:
  InitialCheck(Mechanics& mechanics, const StartOptions& options, support::Diagnostics& diagnostics)
      : mechanics_(mechanics),
        model_(mechanics.model),
        options_(options),
        diagnostics_(diagnostics),
        values_(mechanics, support::Rational(0), k_digits) {}

  void run() {
    std::vector<InitialValue> state;
    const bool has_state = bind_start(mechanics_, values_, state);
    const std::vector<UndefinedPart> undefined = undefined_parts(mechanics_, values_);
    for (const UndefinedPart& part : undefined) report_undefined(part);
    const bool has_open_rates = undefined.empty() && report_undetermined_rates();
    if (undefined.empty() && !has_state && !has_open_rates && !report_unmet(state)) report_undefined_state(state);
    const std::vector<Violation> violated = violations(mechanics_, values_);
    ConstraintCheck constraints(mechanics_, values_, options_.is_emitted, diagnostics_);
    report_vanishing(violated, constraints);
    constraints.report_positions(violated);
    constraints.report_contradictions();
    positions_hold_ =
        std::none_of(violated.begin(), violated.end(), [](const Violation& v) { return v.is_of_positions; });
    for (const Violation& violation : violated) {
      if (!constraints.is_contradictory(violation.index)) report_violation(violation);
    }
    if (!undefined.empty() || !has_state) return report_redundant(mechanics_, diagnostics_);
    if (violated.empty() && !options_.is_assembled && !has_open_rates) {
      report_silent();
      report_choice(chosen_rates(mechanics_, state, values_));
    }
    constraints.report_redundant();
    if (violated.empty()) report_locked();
    if (constraints.leave_undetermined()) return report_undetermined(true);
    const bool is_lost = values_.is_true(mechanics_.solution.singular_mass_matrix) || !has_accelerations();
    if (is_lost && !(has_general_way(mechanics_) && constraints.has_general_solution()))
      report_singular(constraints.has_dependent());
  }

 private:
  /// Of constraints that look as if: violated, or with a gradient that nearly vanishes beside what it may be.
  void report_vanishing(const std::vector<Violation>& violated, ConstraintCheck& constraints) {
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      const bool is_violated = std::any_of(violated.begin(), violated.end(),
                                           [&](const Violation& violation) { return violation.index == mu; });
      if (!is_violated && !has_small_gradient(mechanics_, values_, mu)) continue;
      if (!vanishes_with_gradient(mechanics_, mu)) continue;
      constraints.pass_over(mu);
      mechanics_.vanishing.insert(mu);
      const model::Constraint& row = model_.constraints[mu];
      diagnostics_.warning(support::code::k_vanishing_gradient, row.span, holds_nothing(row), hint_for_vanishing(row));
    }
  }

  std::string hint_for_vanishing(const model::Constraint& row) const {
    if (row.may_vanish)
      return "its other directions and the joints hold this one, too: nothing to do, but its reaction is not told";
    const auto base = options_.source == nullptr ? std::nullopt : base_of_power(row, *options_.source);
    return base ? fmt::format("state '{}' instead", *base)
                : "as that of a square does: state what is squared, or each of the terms in a sum of squares";
  }

  void report_undefined(const UndefinedPart& part) {
    diagnostics_.warning(support::code::k_undefined_start, part.span,
                         "this has no value at the initial state: " + part.reason,
                         "start from another state, or change the parameters in it");
  }

  std::vector<std::size_t> open_speeds() const {
    const std::vector<bool> open = strategy::open_speeds(model_, mechanics_.expressions);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i]) result.push_back(i);
    }
    return result;
  }

  std::vector<std::string> names_of_speeds(const std::vector<std::size_t>& speeds) const {
    std::vector<std::string> names;
    for (const std::size_t i : speeds) names.push_back(mechanics_.symbols.speeds[kinematics::FreeIndex{i}].name);
    return names;
  }

  /// Open rates that neither constraints determine nor inertia, by which the least motion would be chosen: emitted `initial_state` says
  /// singular_mass_matrix there.
  bool report_undetermined_rates() {
    const std::vector<std::size_t> open = open_speeds();
    if (open.empty() || mechanics_.dynamics.l() == 0) return false;
    strategy::Matrix rows;
    const auto add = [&](const strategy::Vector& row) {
      rows.emplace_back();
      for (const std::size_t i : open) rows.back().push_back(row[i]);
    };
    for (const std::size_t i : open) add(mechanics_.dynamics.g[i]);
    for (const strategy::Vector& row : mechanics_.dynamics.b) add(row);
    const auto here = values_(rows);
    if (!here) return false;
    std::vector<std::size_t> undetermined;
    for (const std::size_t column : dependent_columns(*here)) undetermined.push_back(open[column]);
    if (undetermined.empty()) return false;
    const std::size_t freedom = open.size() - values_.rank(*here);
    const std::string names = support::joined(names_of_speeds(undetermined));
    diagnostics_.warning(
        support::code::k_undefined_start, span_of_speed(model_, mechanics_.dynamics.labels[undetermined.front()]),
        fmt::format("nothing determines the initial rate{} {}: the constraints leave {} of them open, and what moves "
                    "then has no mass, by which "
                    "the least motion could be chosen",
                    undetermined.size() == 1 ? "" : "s", names, freedom),
        fmt::format("state {} of them, give what they move a mass, or let a constraint say more", freedom));
    return true;
  }

  /// Of a start that the general way has found: constraints that act on open rates elsewhere, and not here.
  void report_silent() {
    if (!mechanics_.known_start) return;
    const std::vector<bool> is_open = strategy::open_speeds(model_, mechanics_.expressions);
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      const strategy::Vector& row = mechanics_.dynamics.b[mu];
      std::vector<std::size_t> silenced;
      bool acts = false;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const auto entry = values_.residual(row[i].id(), k_digits);
        const bool is_zero = entry && cln::zerop(*entry);
        acts = acts || !is_zero;
        if (is_open[i] && is_zero && !row[i].is_zero()) silenced.push_back(i);
      }
      if (!acts || silenced.empty() || !vanishes_along(is_open, row)) continue;
      const std::vector<std::string> names = names_of_speeds(silenced);
      diagnostics_.warning(
          support::code::k_chosen_start, span_of_speed(model_, mechanics_.dynamics.labels[silenced.front()]),
          fmt::format("constraint '{}', which acts on {} elsewhere, says nothing of {} at the initial state: the least "
                      "motion, weighed by "
                      "mass, that the others allow is taken",
                      mechanics_.dynamics.constraints[mu], support::joined(names), names.size() == 1 ? "it" : "them"),
          fmt::format("state {}, or start elsewhere", support::joined(names)));
    }
  }

  /// Equations of positions that hold at this place alone: emitted code knows no more than their rank there, which is less than usual.
  void report_locked() {
    if (!has_general_way(mechanics_)) return;
    const auto locked = locked_motions(mechanics_);
    if (!locked) return;
    const auto& all = mechanics_.kinematics.constraints;
    const auto indices = all.indices();
    const auto first =
        std::find_if(indices.begin(), indices.end(), [&](const auto mu) { return all[mu].f.has_value(); });
    diagnostics_.warning(
        support::code::k_dependent_start, model_.constraints[(*first).value].name.span,
        fmt::format(
            "the constraints hold at no other place near the initial one, as far as a search sees: they lock the "
            "parts there, though {} motion{} left to first order",
            *locked, *locked == 1 ? " is" : "s are"),
        "give lengths some play if it ought to move; if not, fix the parts to each other, since accelerations and "
        "multipliers follow from first orders");
  }

  void report_undefined_state(const std::vector<InitialValue>& state) {
    for (const InitialValue& value : state) {
      const auto trouble = values_.trouble(value.node);
      if (!trouble) continue;
      diagnostics_.warning(support::code::k_undefined_start, span_of(value.symbol),
                           fmt::format("the initial value of {} is undefined: {}", value.name, trouble->reason),
                           hint_for_open_rates());
      return;
    }
  }

  // A constraint that says something of given rates alone here is no equation for the others.
  std::string hint_for_open_rates() {
    const std::vector<bool> open = strategy::open_speeds(model_, mechanics_.expressions);
    std::vector<std::string> names;
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      if (open[i.value]) names.push_back(mechanics_.symbols.speeds[i].name);
    }
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      if (!names.empty() && vanishes_along(open, mechanics_.dynamics.b[mu]))
        return fmt::format(
            "constraint '{}' says nothing of the rates that are left open: state {} too, or start elsewhere",
            mechanics_.dynamics.constraints[mu], support::joined(names));
    }
    return "check the initial values and the rates that the constraints determine";
  }

  bool vanishes_along(const std::vector<bool>& open, const strategy::Vector& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto entry = open[i] ? values_.residual(row[i].id(), k_digits) : std::nullopt;
      if (open[i] && (!entry || !cln::zerop(*entry))) return false;
    }
    return true;
  }

  /// Whether open rates have no value since given ones contradict the constraints, which say nothing of the open ones here.
  bool report_unmet(const std::vector<InitialValue>& state) {
    std::vector<double> position;
    for (std::size_t i = 0; i < mechanics_.symbols.configuration.size(); ++i) {
      const auto value = values_(state[i].node);
      if (!value) return false;
      position.push_back(evaluate::to_double(*value));
    }
    const std::vector<bool> open = strategy::open_speeds(model_, mechanics_.expressions);
    const auto unmet = unmet_by_speeds(mechanics_, position, open, 0);
    for (const auto& [index, residual] : unmet) {
      const auto& row = mechanics_.kinematics.constraints[kinematics::ConstraintIndex{index}];
      report_violation({index, &row, false, cln::cl_float(residual, cln::float_format(k_digits))});
    }
    return !unmet.empty();
  }

  void report_violation(const Violation& violation) {
    if (options_.is_elsewhere) return;
    if (mechanics_.vanishing.count(violation.index) > 0) return report_violation_of_vanishing(violation);
    const support::Span span = model_.constraints[violation.index].span;
    if (const model::DryFriction* const friction = sticking(model_.constraints[violation.index]))
      return report_slip(*friction, span, violation.residual);
    const std::string message = fmt::format("the initial state violates constraint '{}' by {}", violation.row->name,
                                            evaluate::to_decimal(violation.residual, 3));
    const std::string hint = positions_hold_ || violation.is_of_positions || !acts_on_open(violation)
                                 ? remedy(mechanics_, violation, values_)
                                 : "first let the positions fit: open rates are sought where they do";
    if (options_.is_emitted) {
      diagnostics_.error(support::code::k_impossible_start, span, message, hint);
    } else {
      diagnostics_.warning(support::code::k_violating_start, span, message, hint);
    }
  }

  /// That by which a row is there.
  const model::DryFriction* sticking(const model::Constraint& row) const {
    for (const model::DryFriction& friction : model_.frictions) {
      const auto is_row = [&](const model::Name& name) { return name.text == row.name.text; };
      if (std::any_of(friction.rows.begin(), friction.rows.end(), is_row)) return &friction;
    }
    return nullptr;
  }

  /// Where nobody has said which regime, friction sticks.
  void report_slip(const model::DryFriction& friction, support::Span span, const cln::cl_F& slip) {
    const std::string& name = friction.name.text;
    const bool has_sense = friction.law.slips.size() == 1;
    const std::string message =
        fmt::format("the initial state slips by {}, and this is the regime in which '{}' sticks",
                    evaluate::to_decimal(slip, 3), name);
    const std::string hint = fmt::format("--regime {}={} is that of this start; gauss-sim run finds it by itself", name,
                                         !has_sense          ? "slides"
                                         : cln::minusp(slip) ? "backwards"
                                                             : "forwards");
    if (options_.is_emitted) {
      diagnostics_.error(support::code::k_impossible_start, span, message, hint);
    } else {
      diagnostics_.warning(support::code::k_violating_start, span, message, hint);
    }
  }

  bool acts_on_open(const Violation& violation) const {
    const std::vector<bool> given = stated_speeds(model_);
    const auto indices = mechanics_.symbols.speeds.indices();
    return std::any_of(indices.begin(), indices.end(), [&](const auto i) {
      return !given[i.value] && !violation.row->beta[mechanics_.symbols.full(i)].is_zero();
    });
  }

  // How far it holds says little: it grows as a power of what it is about.
  void report_violation_of_vanishing(const Violation& violation) {
    const model::Constraint& row = model_.constraints[violation.index];
    const auto code = options_.is_emitted ? support::code::k_impossible_start : support::code::k_violating_start;
    const std::string message = fmt::format("no start that satisfies constraint '{}' is found", row.name.text);
    if (options_.is_emitted) {
      diagnostics_.error(code, row.span, message, hint_for_vanishing(row));
    } else {
      diagnostics_.warning(code, row.span, message, hint_for_vanishing(row));
    }
  }

  /// Those that state initial values of the open rates.
  std::string keys_of(const OpenRates& open) const {
    bool has_rate = false, has_angular_velocity = false, has_speed = false;
    for (const OpenRate& rate : open.rates) {
      const model::SymbolKind kind = model_.resolve(rate.label).kind;
      has_rate = has_rate || kind == model::SymbolKind::coordinate;
      has_angular_velocity = has_angular_velocity || kind == model::SymbolKind::angular_velocity;
      has_speed = has_speed || kind == model::SymbolKind::speed;
    }
    std::string keys;
    const auto add = [&](bool is_used, const char* key) {
      if (is_used) keys += (keys.empty() ? "" : " or ") + std::string(key);
    };
    add(has_rate, "initial_rate");
    add(has_angular_velocity, "initial_angular_velocity");
    add(has_speed, "'initial' of the speed");
    return keys;
  }

  void report_choice(const OpenRates& open) {
    if (open.rates.empty()) return;
    std::vector<std::string> values;
    for (const OpenRate& rate : open.rates) {
      values.push_back(fmt::format("{} = {}", rate.name, evaluate::to_decimal(rate.value, 3)));
    }
    diagnostics_.warning(
        support::code::k_chosen_start, span_of_speed(model_, open.rates.front().label),
        fmt::format(
            "the constraints leave {} of these initial rates open, and the least motion, weighed by mass, is taken: {}",
            open.freedom, support::joined(values)),
        fmt::format("state {} of them by {}", open.freedom, keys_of(open)));
  }

  // A pivot that is zero from the start divides; one that cancels is flagged.
  void report_singular(bool has_dependent) {
    const bool is_singular = values_.is_true(mechanics_.solution.singular_mass_matrix);
    if (is_singular || (!has_accelerations() && !report_pole() && !report_slack_spring()))
      report_undetermined(has_dependent);
  }

  /// Whether there are no accelerations since a spring that has a length has none at this position.
  bool report_slack_spring() {
    kinematics::Frames& frames = mechanics_.expressions.frames();
    for (const model::Force& force : model_.forces) {
      const auto* spring = std::get_if<model::Spring>(&force.law);
      if (spring == nullptr || !spring->length) continue;
      const ir::Vector3 gap = frames.origin(spring->second) - frames.origin(spring->first);
      const auto square = values_(ir::dot(gap, gap).id());
      if (!square || !cln::zerop(*square)) continue;
      diagnostics_.warning(
          support::code::k_singular_start, force.name.span,
          "there are no accelerations at the initial state: both ends of this spring are at the same place, so that "
          "it pulls in no direction",
          "start with its ends apart; a spring without 'length' needs no direction");
      return true;
    }
    return false;
  }

  bool has_accelerations() {
    const auto& all = mechanics_.solution.accelerations;
    return std::none_of(all.begin(), all.end(), [&](const ir::Expr a) { return values_.trouble(a.id()).has_value(); });
  }

  /// Whether there are no accelerations since a derivative of an expression has a pole.
  bool report_pole() {
    for (int derivative = 1; derivative <= k_most_derivatives; ++derivative) {
      for (const UndefinedPart& part : undefined_parts(mechanics_, values_, derivative)) {
        diagnostics_.warning(
            support::code::k_singular_start, part.span,
            "there are no accelerations at the initial state: a derivative of this has no value there: " + part.reason,
            "start from another state");
        return true;
      }
    }
    return false;
  }

  void report_undetermined(bool has_dependent) {
    const std::vector<std::string> labels = undetermined_speeds();
    const std::vector<std::string> massless = massless_bodies();
    const bool is_by_constraints = labels.empty() && has_dependent;
    std::string cause = is_by_constraints ? "constraints depend on each other, and some motion has no mass of its own"
                                          : "the mass matrix is singular";
    if (labels.size() == 1) cause += fmt::format(", nothing determines the acceleration of '{}'", labels[0]);
    if (labels.size() > 1)
      cause += fmt::format(", nothing tells the accelerations of {} apart", support::joined(labels));
    diagnostics_.warning(
        support::code::k_singular_start, labels.empty() ? model_.name.span : span_of_speed(model_, labels[0]),
        "there are no accelerations at the initial state: " + cause,
        is_by_constraints ? "start from another state, or leave out what says the same twice"
        : has_dependent   ? "let a constraint that says nothing of its own here tell them apart, give what they move a "
                            "mass, or start elsewhere"
        : massless.empty()
            ? "where coordinates do not describe every motion, start elsewhere; a quaternion has no such places"
            : fmt::format("give {} a mass: what is without mass and moves alone has no acceleration",
                          support::joined(massless)));
  }

  std::vector<std::string> massless_bodies() {
    std::vector<std::string> names;
    for (const model::Body& body : model_.bodies) {
      const auto mass = values_(mechanics_.expressions(body.mass).id());
      if (mass && cln::zerop(*mass)) names.push_back("'" + body.name.text + "'");
    }
    return names;
  }

  /// Those that neither inertia nor constraints tell from each other.
  std::vector<std::string> undetermined_speeds() {
    std::vector<std::string> labels;
    const auto here = values_(strategy::g_above_b(mechanics_.dynamics));
    if (!here) return labels;
    for (const std::size_t a : dependent_columns(*here)) labels.push_back(mechanics_.dynamics.labels[a]);
    return labels;
  }

  support::Span span_of(ir::SymbolId symbol) const {
    for (const kinematics::Speed& speed : mechanics_.symbols.speeds) {
      if (speed.symbol == symbol) return span_of_speed(model_, speed.label);
    }
    for (const kinematics::ConfigurationVariable& q : mechanics_.symbols.configuration) {
      if (q.symbol == symbol) return span_of_speed(model_, q.name);
    }
    return model_.name.span;
  }

  Mechanics& mechanics_;
  const model::Model& model_;
  StartOptions options_;
  support::Diagnostics& diagnostics_;
  ModelValues values_;
  bool positions_hold_ = true;
};

}  // namespace

void check_initial_state(Mechanics& mechanics, const StartOptions& options, support::Diagnostics& diagnostics) {
  InitialCheck(mechanics, options, diagnostics).run();
}

bool is_start_of(Mechanics& mechanics) {
  ModelValues values(mechanics, support::Rational(0), k_digits);
  std::vector<InitialValue> state;
  return !bind_start(mechanics, values, state) || violations(mechanics, values).empty();
}

std::vector<std::string> assembled_values(Mechanics& mechanics, const StatedStart& stated,
                                          const support::Rational& time) {
  ModelValues values(mechanics, time, k_digits);
  const std::vector<InitialValue> reached = initial_values(mechanics, values);
  std::vector<std::string> moved;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (!stated[i]) continue;
    const auto from = values(stated[i]->id());
    const auto to = values(reached[i].node);
    if (!from || !to) continue;
    const cln::cl_F size =
        values.number(cln::expt(support::Rational(10), -k_moved_digits)) * cln::max(cln::abs(*from), cln::abs(*to));
    if (cln::abs(*to - *from) <= size) continue;
    moved.push_back(fmt::format("{}: {} -> {}", reached[i].name, evaluate::to_decimal(*from, k_shown_digits),
                                evaluate::to_decimal(*to, k_shown_digits)));
  }
  return moved;
}

}  // namespace gaussgen
