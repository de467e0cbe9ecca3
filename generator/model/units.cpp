// Numbers are taken as they are. Where a unit shows that a conversion is expected, say so.

#include <fmt/format.h>

#include <string>

#include "model/checks.hpp"
#include "model/unit_lexer.hpp"
#include "model/unit_names.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

/// The first word of `unit` that stands for a multiple of an SI unit, or an empty text.
std::string scaled_unit(const std::string& unit) {
  for (const UnitToken& token : unit_tokens(unit)) {
    if (token.kind != UnitTokenKind::name) continue;
    std::string word = unit.substr(token.begin, token.end - token.begin);
    const auto known = find_unit(word);
    if (known && !known->is_coherent) return word;
  }
  return "";
}

void check_unit(const Name& name, const std::string& unit, Reading& reading) {
  const std::string word = scaled_unit(unit);
  if (word.empty()) return;
  reading.diagnostics.warning(
      support::code::k_scaled_unit, name.span,
      fmt::format("the unit '{}' of '{}' is not converted: numbers are taken as they are", word, name.text),
      "use m, kg, s, rad and what follows from them; functions take radians");
}

}  // namespace

void check_units(Reading& reading) {
  for (const Parameter& parameter : reading.model.parameters) check_unit(parameter.name, parameter.unit, reading);
  for (const Input& input : reading.model.inputs) check_unit(input.name, input.unit, reading);
  for (const Table& table : reading.model.tables) {
    check_unit(table.name, table.unit, reading);
    if (table.of_unit != table.unit) check_unit(table.name, table.of_unit, reading);
  }
  for (const Coordinate& coordinate : reading.model.coordinates) check_unit(coordinate.name, coordinate.unit, reading);
  for (const Speed& speed : reading.model.speeds) check_unit(speed.name, speed.unit, reading);
  for (const NamedQuantity& quantity : reading.model.quantities) check_unit(quantity.name, quantity.unit, reading);
}

}  // namespace gaussgen::model
