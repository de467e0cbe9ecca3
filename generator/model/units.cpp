// Units are words of the user so far; nothing is converted. Where a word shows that a conversion is expected, say so.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "model/checks.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

/// Units that people mix with metres, kilograms, seconds and radians.
constexpr std::array<const char*, 26> k_scaled_units = {
    "deg", "degree", "degrees", "rpm", "rev", "turn", "nm", "um",  "mm", "cm", "dm", "km", "inch",
    "in",  "ft",     "g",       "mg",  "lb",  "ms",   "us", "min", "h",  "kN", "MN", "mN", "kJ"};

constexpr const char* k_degree_sign = "\xC2\xB0";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The first word of `unit` that stands for a multiple of an SI unit, or an empty text.
std::string scaled_unit(const std::string& unit) {
  if (unit.find(k_degree_sign) != std::string::npos) return k_degree_sign;
  for (std::size_t begin = 0; begin < unit.size();) {
    if (!is_letter(unit[begin])) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < unit.size() && is_letter(unit[end])) ++end;
    const std::string word = unit.substr(begin, end - begin);
    if (std::find(k_scaled_units.begin(), k_scaled_units.end(), word) != k_scaled_units.end()) return word;
    begin = end;
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
  for (const Coordinate& coordinate : reading.model.coordinates) check_unit(coordinate.name, coordinate.unit, reading);
}

}  // namespace gaussgen::model
