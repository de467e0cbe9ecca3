// Every expression of the model in the unit of its place.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/checks.hpp"
#include "model/expressions.hpp"
#include "model/inference.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using Kind = Measure::Kind;

namespace {

constexpr std::size_t k_most_names = 6;

Dimension per_second() { return {{0, 0, -1}}; }
Dimension length() { return {{1}}; }
Dimension energy() { return {{2, 1, -2}}; }
Dimension power() { return energy() * per_second(); }

Measure in(const char* unit, const Dimension& dimension) { return {Kind::known, dimension, unit}; }

/// The unit of a force is that of work over that of the coordinate; an angular velocity belongs to an angle.
Measure force_on(const Measure& owner, bool is_angular_velocity) {
  if (is_angular_velocity) return in("N*m", energy());
  return owner.kind == Kind::known ? known(energy() / owner.dimension) : Measure{};
}

Measure over(const Measure& a, const Measure& b) {
  return a.kind == Kind::known && b.kind == Kind::known ? known(a.dimension / b.dimension) : Measure{};
}

Measure rate_of(const Measure& owner) {
  return owner.kind == Kind::known ? known(owner.dimension * per_second()) : Measure{};
}

/// What a place wants; unknown where everything is right.
Measure wanted_at(const Slot& slot, const Model& model) {
  const Measure owner = slot.owner == nullptr ? Measure{} : measure_of(model, slot.owner->text);
  switch (slot.quantity) {
    case Quantity::any: return {};
    case Quantity::number: return in("1", {});
    case Quantity::stated: {
      const std::optional<Dimension>& stated = slot.stated->dimension;
      return stated ? in(slot.stated->unit.c_str(), *stated) : Measure{};
    }
    case Quantity::angle: return in("rad", {});
    case Quantity::length: return in("m", length());
    case Quantity::mass: return in("kg", {{0, 1}});
    case Quantity::inertia: return in("kg*m^2", {{2, 1}});
    case Quantity::acceleration: return in("m/s^2", {{1, 0, -2}});
    case Quantity::energy: return in("J", energy());
    case Quantity::force: return in("N", {{1, 1, -2}});
    case Quantity::torque: return in("N*m", energy());
    case Quantity::stiffness: return in("N/m", {{0, 1, -2}});
    case Quantity::damping: return in("N*s/m", {{0, 1, -1}});
    case Quantity::owner: return owner;
    case Quantity::rate_of_owner: return rate_of(owner);
    case Quantity::force_on_owner: {
      const auto symbol = model.symbols.find(slot.owner->text);
      const bool is_speed = symbol != model.symbols.end() && symbol->second.kind == SymbolKind::speed;
      if (is_speed) return owner.kind == Kind::known ? known(power() / owner.dimension) : Measure{};
      return force_on(owner, symbol != model.symbols.end() && symbol->second.kind == SymbolKind::angular_velocity);
    }
    case Quantity::stiffness_on_owner: return over(force_on(owner, false), owner);
    case Quantity::damping_on_owner: return over(force_on(owner, false), rate_of(owner));
    case Quantity::force_along: return in("N", {{1, 1, -2}});
    case Quantity::speed_along: return {};
    case Quantity::multiplier: {
      const std::optional<Dimension>& dimension = slot.row->multiplier_dimension;
      return dimension ? in(slot.row->multiplier_unit.c_str(), *dimension) : Measure{};
    }
  }
  return {};
}

std::string subject(const Slot& slot) {
  const bool is_of_spring =
      slot.quantity == Quantity::stiffness_on_owner || slot.quantity == Quantity::damping_on_owner;
  if (slot.owner == nullptr || is_of_spring) return slot.place.name;
  const std::string name = "'" + slot.owner->text + "'";
  if (slot.quantity == Quantity::rate_of_owner) return "the rate of " + name;
  if (slot.quantity == Quantity::force_on_owner) return "the generalized force on " + name;
  return name;
}

class DimensionCheck {
 public:
  explicit DimensionCheck(Reading& reading)
      : reading_(reading), infer_(reading.model, reading.source, reading.diagnostics) {}

  /// A formula without a unit has the one that follows from its parts, which stand before it.
  void complete_parameters() {
    for (Parameter& parameter : reading_.model.parameters) complete(parameter, parameter.value);
  }

  void complete_speeds() {
    for (Speed& speed : reading_.model.speeds) complete(speed, speed.is);
  }

  /// Likewise a quantity, if its components have one unit; numbers, such as a 0 among lengths, have that of the others.
  void complete_quantities() {
    for (NamedQuantity& quantity : reading_.model.quantities) {
      if (!quantity.unit.empty()) continue;
      std::vector<Measure> measures;
      for (const Ast& value : quantity.values) measures.push_back(inferred(value));
      const auto first = std::find_if(measures.begin(), measures.end(),
                                      [](const Measure& measure) { return measure.kind == Kind::known; });
      if (first == measures.end()) continue;
      const bool is_one = std::all_of(measures.begin(), measures.end(), [&](const Measure& measure) {
        return measure.kind == Kind::literal ||
               (measure.kind == Kind::known && agree(measure.dimension, first->dimension));
      });
      if (!is_one) continue;
      quantity.dimension = first->dimension;
      quantity.unit = unit_of(*first);
    }
  }

  void complete_multipliers() {
    for (Constraint& constraint : reading_.model.constraints) {
      const Measure unit = std::visit([&](const auto& law) { return multiplier_of(law); }, constraint.law);
      if (unit.kind == Kind::known) {
        constraint.multiplier_unit = unit_of(unit);
        constraint.multiplier_dimension = unit.dimension;
      }
      note_reaction(constraint.name.text, unit);
    }
    for (const Coordinate& coordinate : reading_.model.coordinates) {
      if (coordinate.held_at)
        note_reaction(coordinate.name.text, force_on(measure_of(reading_.model, coordinate.name.text), false));
    }
    // Open ones have none, but what is written with it is wrong or right all the same.
    for (const Contact& contact : reading_.model.contacts)
      note_reaction(contact.name.text, over(known(energy()), inferred(contact.gap)));
  }

  void complete_impulses() {
    for (Contact& contact : reading_.model.contacts) {
      const Measure gap = inferred(contact.gap);
      if (gap.kind != Kind::known) continue;
      const Dimension impulse = energy() / (gap.dimension * per_second());
      contact.impulse_unit = agree(gap.dimension, length()) ? "N*s" : text(impulse);
    }
  }

  void check(const Ast& ast, const Slot& slot) {
    if (done_.count(&ast) > 0) return;
    // Parts that a shorthand adds up stand at this place, each by itself.
    if (ast.is_derived && ast.kind == AstKind::sum) {
      for (const Ast& part : ast.children) check(part, slot);
      return;
    }
    const Measure wanted = slot.along == nullptr ? wanted_at(slot, reading_.model) : beside(slot);
    const bool is_free = wanted.kind != Kind::known;
    const Measure found = infer_(ast, is_free ? nullptr : &wanted.dimension);
    if (is_free || found.kind != Kind::known || agree(found.dimension, wanted.dimension) || is_faulty(ast)) return;
    infer_.report(code::k_wrong_dimension, ast,
                  fmt::format("{} is {}, and this is {}", subject(slot), phrase(wanted), phrase(found)),
                  hint_for(ast, wanted, found));
  }

  void report_missing() {
    for (const Parameter& parameter : reading_.model.parameters) {
      if (!parameter.is_formula) note_missing(parameter);
    }
    for (const Input& input : reading_.model.inputs) note_missing(input);
    for (const Table& table : reading_.model.tables) note_missing(table);
    for (const Coordinate& coordinate : reading_.model.coordinates) note_missing(coordinate);
    if (missing_.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < std::min(missing_.size(), k_most_names); ++i) {
      names += (i == 0 ? "" : ", ") + missing_[i].text;
    }
    if (missing_.size() > k_most_names) names += fmt::format(" and {} more", missing_.size() - k_most_names);
    reading_.diagnostics.warning(code::k_missing_unit, missing_[0].span,
                                 fmt::format("no unit is given for {}: what is computed with {} is not checked", names,
                                             missing_.size() == 1 ? "it" : "them"),
                                 fmt::format("add {}, as in 'unit: m'; 'unit: 1' is a plain number",
                                             lacks_of_table_        ? "'unit', and 'of_unit' to tables"
                                             : missing_.size() == 1 ? "one"
                                                                    : "theirs"));
  }

 private:
  void note_reaction(const std::string& of, const Measure& unit) {
    for (NamedReaction& reaction : reading_.model.reactions) {
      if (reaction.of == of && unit.kind == Kind::known) reaction.dimension = unit.dimension;
    }
  }

  Measure beside(const Slot& slot) {
    const Measure velocity = infer_(*slot.along);
    return slot.quantity == Quantity::force_along ? over(known(power()), velocity) : velocity;
  }

  /// λ φ is a power.
  Measure multiplier_of(const VelocityLaw& law) { return over(known(power()), inferred(law.phi)); }

  /// R f is an energy.
  Measure multiplier_of(const PositionLaw& law) {
    // The f of a shorthand is a length.
    return law.f.is_derived ? known(energy() / length()) : over(known(energy()), inferred(law.f));
  }

  Measure multiplier_of(const SlipLaw& law) {
    const auto is_plain = [&](const Ast& component) {
      const Measure measure = inferred(component);
      return measure.kind == Kind::literal || (measure.kind == Kind::known && is_number(measure.dimension));
    };
    return std::all_of(law.direction.begin(), law.direction.end(), is_plain) ? known(energy() / length()) : Measure{};
  }

  /// With what stands for the name that may not stand there, the unit is another one.
  bool is_faulty(const Ast& ast) const { return reading_.faulty_values.count(ast.span.begin) > 0; }

  Measure inferred(const Ast& ast) {
    done_.insert(&ast);
    return infer_(ast);
  }

  template <class Owner>
  void complete(Owner& owner, const Ast& value) {
    if (!owner.unit.empty()) return;
    const Measure measure = inferred(value);
    if (measure.kind != Kind::known || is_faulty(value)) return;
    owner.dimension = measure.dimension;
    owner.unit = unit_of(measure);
  }

  std::string hint_for(const Ast& ast, const Measure& wanted, const Measure& found) const {
    const std::string names = units_of_names(reading_.model, {&ast});
    if (reading_.along_joints.count(ast.span.begin) > 0)
      return fmt::format("the joint measures it {}: name another coordinate, or none; {}", phrase(wanted), names);
    if (!is_number(found.dimension)) return names;
    return fmt::format("multiply it by a parameter {}; {}", phrase(wanted), names);
  }

  template <class Entry>
  void note_missing(const Entry& entry) {
    if (entry.unit.empty()) missing_.push_back({"'" + entry.name.text + "'", entry.name.span});
  }

  void note_missing(const Table& table) {
    if (!table.unit.empty() && !table.of_unit.empty()) return;
    const bool lacks_both = table.unit.empty() && table.of_unit.empty();
    const char* const what = lacks_both ? "arguments and values" : table.unit.empty() ? "values" : "arguments";
    lacks_of_table_ = true;
    missing_.push_back({fmt::format("the {} of '{}'", what, table.name.text), table.name.span});
  }

  Reading& reading_;
  Inference infer_;
  std::set<const Ast*> done_;
  std::vector<Name> missing_;  ///< in words: 'x'
  bool lacks_of_table_ = false;
};

}  // namespace

void check_dimensions(Reading& reading) {
  if (!has_units(reading.model)) return;
  DimensionCheck dimensions(reading);
  dimensions.complete_parameters();
  dimensions.complete_speeds();
  dimensions.complete_multipliers();
  dimensions.complete_impulses();
  dimensions.complete_quantities();
  for_each_slot(reading.model, [&](const Ast& ast, const Slot& slot) { dimensions.check(ast, slot); });
  // Next to errors this is of no interest.
  if (!reading.diagnostics.has_errors()) dimensions.report_missing();
}

}  // namespace gaussgen::model
