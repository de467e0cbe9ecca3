// coordinates: free ones with initial values, held ones with the law that they follow.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;

namespace {

/// A held coordinate starts where its law says.
void refuse_initial_values(const Node& map, Reading& reading) {
  for (const Entry& entry : map.entries) {
    if (entry.key.text.rfind("initial", 0) != 0) continue;
    reading.diagnostics.error(code::k_conflicting_keys, entry.key.span,
                              fmt::format("a held coordinate takes no '{}': 'held_at' determines it", entry.key.text),
                              "remove one of the two keys");
  }
}

void refuse_needless_guess(const Node& map, const std::string& key, const char* what, Reading& reading) {
  for (const Entry& entry : map.entries) {
    if (entry.key.text != key + "_guess") continue;
    reading.diagnostics.error(code::k_conflicting_keys, entry.key.span,
                              fmt::format("'{0}_guess' beside '{0}', which determines the {1}", key, what),
                              "remove one of the two keys");
  }
}

void read_fields(const Node& map, Coordinate& coordinate, Reading& reading) {
  check_keys(map, fmt::format("coordinate '{}'", coordinate.name.text), format::keys_of(format::coordinate()), reading);
  read_unit(map, coordinate, reading);
  coordinate.about = text_field(map, "about", reading);
  coordinate.held_at = expression_field(map, "held_at", reading);
  if (coordinate.held_at) return refuse_initial_values(map, reading);
  coordinate.initial = expression_field(map, "initial", reading);
  coordinate.guess = expression_field(map, "initial_guess", reading);
  coordinate.initial_rate = expression_field(map, "initial_rate", reading);
  coordinate.rate_guess = expression_field(map, "initial_rate_guess", reading);
  if (coordinate.initial && coordinate.guess) refuse_needless_guess(map, "initial", "value", reading);
  if (coordinate.initial_rate && coordinate.rate_guess) refuse_needless_guess(map, "initial_rate", "rate", reading);
}

void read_coordinate(const Entry& entry, Reading& reading) {
  Coordinate coordinate;
  coordinate.name = name_of(entry.key);
  const bool empty = entry.value.kind == spec::NodeKind::empty;
  if (!empty && expect_map(entry.value, entry.key.span, fmt::format("coordinate '{}'", entry.key.text), reading)) {
    read_fields(entry.value, coordinate, reading);
  }
  declare(coordinate.name, SymbolKind::coordinate, reading.model.coordinates.size(), "the coordinate", reading);
  reading.model.coordinates.push_back(std::move(coordinate));
}

}  // namespace

void read_coordinates(const Node& root, Reading& reading) {
  read_section(root, "coordinates", reading, [&](const Entry& entry) { read_coordinate(entry, reading); });
}

}  // namespace gaussgen::model
