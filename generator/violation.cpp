#include "violation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "open_rates.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

namespace {

constexpr int k_residual_digits = 13;

/// "x, y or z"
std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  }
  return text;
}

/// In the order of the speeds: those along which the initial configuration is given.
std::vector<bool> stated_positions(const model::Model& model) {
  std::vector<bool> result;
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (!coordinate.held_at) result.push_back(coordinate.initial.has_value());
  }
  for (const model::Orientation& orientation : model.orientations) result.insert(result.end(), 3, !orientation.is_open);
  return result;
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// What moves an equation of positions: coordinates, and orientations by their names.
struct Movers {
  std::vector<std::string> given, open, given_orientations, open_orientations;
};

Movers movers_of(const Mechanics& mechanics, const kinematics::ConstraintRow& row, ModelValues& values) {
  Movers result;
  const std::vector<bool> is_given = stated_positions(mechanics.model);
  const std::size_t count = mechanics.symbols.plain_count();
  for (const auto i : mechanics.symbols.speeds.indices()) {
    const auto b = values(row.beta[mechanics.symbols.full(i)].id());
    if (!b || cln::zerop(*b)) continue;
    if (i.value < count) {
      (is_given[i.value] ? result.given : result.open).push_back(mechanics.symbols.speeds[i].label);
    } else {
      const std::string& name = mechanics.model.orientations[(i.value - count) / 3].name.text;
      add_once("'" + name + "'", is_given[i.value] ? result.given_orientations : result.open_orientations);
    }
  }
  return result;
}

std::string remedy_of_positions(const Mechanics& mechanics, const kinematics::ConstraintRow& row, ModelValues& values) {
  const Movers movers = movers_of(mechanics, row, values);
  if (!movers.open.empty() || !movers.open_orientations.empty()) {
    const bool is_of_coordinates = !movers.open.empty();
    return fmt::format(
        "the search for {} found nothing: give an {} near the wanted position, and check that the parts can reach each "
        "other",
        joined(is_of_coordinates ? movers.open : movers.open_orientations),
        is_of_coordinates ? "initial_guess" : "'initial'");
  }
  const std::string orientations = joined(movers.given_orientations);
  if (!movers.given.empty())
    return fmt::format("give {} an initial_guess instead of a value, or let 'gauss-gen --assemble' move all values{}",
                       joined(movers.given), orientations.empty() ? "" : ", and the orientation " + orientations);
  if (!orientations.empty())
    return fmt::format("correct 'initial' of the orientation {}, or let 'gauss-gen --assemble' turn it", orientations);
  return "no coordinate moves it at this position: start from another one";
}

/// No more than a radian with as many digits makes of it: a sine that has to be 0 is made of nothing but its angle.
bool is_rounding_of_angles(const cln::cl_F& f, const kinematics::ConstraintRow& row, const Mechanics& mechanics,
                           ModelValues& values) {
  cln::cl_F sum = cln::cl_float(0, f);
  for (const auto i : mechanics.symbols.speeds.indices()) {
    const std::string& unit = mechanics.symbols.speeds[i].unit;
    const auto b = unit == "rad/s" || unit.empty() ? values(row.beta[mechanics.symbols.full(i)].id()) : std::nullopt;
    if (b) sum = sum + cln::abs(*b);
  }
  return !(sum < cln::abs(f) * cln::cl_float(cln::expt_pos(cln::cl_I(10), k_residual_digits), f));
}

}  // namespace

std::vector<Violation> violations(const Mechanics& mechanics, ModelValues& values) {
  std::vector<Violation> result;
  for (const auto mu : mechanics.kinematics.constraints.indices()) {
    const kinematics::ConstraintRow& row = mechanics.kinematics.constraints[mu];
    if (row.f) {
      const std::optional<cln::cl_F> f = values.residual(row.f->id(), k_residual_digits);
      if (f && !cln::zerop(*f) && !is_rounding_of_angles(*f, row, mechanics, values))
        result.push_back({mu.value, &row, true, *f});
    }
    const std::optional<cln::cl_F> phi = values.residual(row.phi.id(), k_residual_digits);
    const bool is_reported = !result.empty() && result.back().index == mu.value;
    if (!is_reported && phi && !cln::zerop(*phi)) result.push_back({mu.value, &row, false, *phi});
  }
  return result;
}

// An open rate is searched for by Newton's method where the constraint is nonlinear; from 0 it may have no way to go.
std::string remedy(const Mechanics& mechanics, const Violation& violation, ModelValues& values) {
  const kinematics::ConstraintRow& row = *violation.row;
  if (violation.is_of_positions) return remedy_of_positions(mechanics, row, values);
  std::vector<std::string> given;
  std::vector<std::string> open;
  std::vector<std::string> stuck;
  bool has_angular_velocity = false;
  const std::vector<bool> is_given = stated_speeds(mechanics.model);
  for (const auto i : mechanics.symbols.speeds.indices()) {
    const auto b = values(row.beta[mechanics.symbols.full(i)].id());
    const std::string& name = mechanics.symbols.speeds[i].name;
    if (b && !cln::zerop(*b)) (is_given[i.value] ? given : open).push_back(name);
    const bool is_involved = !row.beta[mechanics.symbols.full(i)].is_zero();
    if (row.is_linear || !is_involved || is_given[i.value]) continue;
    stuck.push_back(name);
    const model::SymbolKind kind = mechanics.model.resolve(mechanics.symbols.speeds[i].label).kind;
    has_angular_velocity = has_angular_velocity || kind == model::SymbolKind::angular_velocity;
  }
  if (has_angular_velocity) {
    return fmt::format(
        "{} is open: state about what it is in 'initial_angular_velocity', and let 'gauss-gen --assemble' move it from "
        "there",
        joined(stuck));
  }
  if (!stuck.empty()) {
    return fmt::format("{} is open: give it an initial_rate_guess from which the search can start", joined(stuck));
  }
  if (!given.empty()) return fmt::format("leave {} open, and the constraint determines it", joined(given));
  if (!open.empty()) return fmt::format("no values of {} satisfy all constraints", joined(open));
  return "no speed acts on it at this state; start from another one";
}

}  // namespace gaussgen
