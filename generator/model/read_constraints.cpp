// constraints on velocities, and the choice of the speeds that they determine.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;

namespace {

/// Reactions of held coordinates and of constraints are reported side by side, by name.
void check_label(const Name& name, Reading& reading) {
  const auto symbol = reading.model.symbols.find(name.text);
  if (symbol == reading.model.symbols.end() || symbol->second.kind != SymbolKind::coordinate) return;
  const Coordinate& coordinate = reading.model.coordinates[symbol->second.index];
  if (!coordinate.held_at) return;
  reading.diagnostics.error(
      code::k_name_clash, name.span,
      fmt::format("'{}' already names the held coordinate in line {}", name.text, reading.line(coordinate.name.span)),
      "both would label a reaction; rename the constraint");
}

void read_constraint(const Entry& entry, Reading& reading) {
  const std::string where = fmt::format("constraint '{}'", entry.key.text);
  VelocityConstraint constraint;
  constraint.name = name_of(entry.key);
  constraint.velocity = broken_expression();
  check_name(constraint.name, reading);
  check_label(constraint.name, reading);
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, {"velocity", "point", "about"}, reading);
    const Node* velocity = required(entry.value, "velocity", entry.key.span, where, reading);
    if (velocity != nullptr) constraint.velocity = read_expression(*velocity, entry.key.span, reading);
    const Node* point = spec::find(entry.value, "point");
    if (point != nullptr) constraint.point = read_vector(*point, entry.key.span, "'point'", reading);
    constraint.about = text_field(entry.value, "about", reading);
  }
  reading.model.constraints.push_back(std::move(constraint));
}

}  // namespace

void read_constraints(const Node& root, Reading& reading) {
  read_section(root, "constraints", reading, [&](const Entry& entry) { read_constraint(entry, reading); });
}

void read_elimination(const Node& root, Reading& reading) {
  const Node* elimination = spec::find(root, "elimination");
  if (elimination == nullptr || !expect_map(*elimination, elimination->span, "'elimination'", reading)) return;
  check_keys(*elimination, "'elimination'", {"dependent"}, reading);
  const Node* dependent = required(*elimination, "dependent", elimination->span, "'elimination'", reading);
  if (dependent == nullptr || !expect_list(*dependent, elimination->span, "'dependent'", reading)) return;
  for (const Node& item : dependent->items) {
    if (expect_scalar(item, dependent->span, "a dependent speed", reading))
      reading.model.dependent.push_back(name_of(item.scalar));
  }
}

}  // namespace gaussgen::model
