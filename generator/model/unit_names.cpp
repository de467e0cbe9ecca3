#include "model/unit_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "support/suggest.hpp"

namespace gaussgen::model {

namespace {

enum class Kind { si, si_without_prefix, scaled, scaled_with_prefix };

/// Powers of m, kg, s, A, K, mol, cd, rad.
struct Row {
  const char* name;
  std::array<int, 8> powers;
  Kind kind;
};

constexpr auto k_si = Kind::si;
constexpr auto k_alone = Kind::si_without_prefix;
constexpr auto k_scaled = Kind::scaled;
constexpr auto k_prefixed = Kind::scaled_with_prefix;

constexpr Row k_rows[] = {
    {"m", {1}, k_si},
    {"kg", {0, 1}, k_alone},
    {"s", {0, 0, 1}, k_si},
    {"A", {0, 0, 0, 1}, k_si},
    {"K", {0, 0, 0, 0, 1}, k_si},
    {"mol", {0, 0, 0, 0, 0, 1}, k_si},
    {"cd", {0, 0, 0, 0, 0, 0, 1}, k_si},
    {"rad", {0, 0, 0, 0, 0, 0, 0, 1}, k_si},
    {"sr", {0, 0, 0, 0, 0, 0, 0, 2}, k_si},
    {"Hz", {0, 0, -1}, k_si},
    {"N", {1, 1, -2}, k_si},
    {"Pa", {-1, 1, -2}, k_si},
    {"J", {2, 1, -2}, k_si},
    {"W", {2, 1, -3}, k_si},
    {"C", {0, 0, 1, 1}, k_si},
    {"V", {2, 1, -3, -1}, k_si},
    {"ohm", {2, 1, -3, -2}, k_si},
    {"\xCE\xA9", {2, 1, -3, -2}, k_si},      // Greek capital omega
    {"\xE2\x84\xA6", {2, 1, -3, -2}, k_si},  // the sign of its own
    {"S", {-2, -1, 3, 2}, k_si},
    {"F", {-2, -1, 4, 2}, k_si},
    {"H", {2, 1, -2, -2}, k_si},
    {"T", {0, 1, -2, -1}, k_si},
    {"Wb", {2, 1, -2, -1}, k_si},
    // Angles and their rates.
    {"deg", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"degree", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"degrees", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"\xC2\xB0", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"gon", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"arcmin", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"arcsec", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"rev", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"turn", {0, 0, 0, 0, 0, 0, 0, 1}, k_scaled},
    {"rpm", {0, 0, -1, 0, 0, 0, 0, 1}, k_scaled},
    // Time.
    {"min", {0, 0, 1}, k_scaled},
    {"h", {0, 0, 1}, k_scaled},
    {"d", {0, 0, 1}, k_scaled},
    {"day", {0, 0, 1}, k_scaled},
    // Length, area, volume and speed.
    {"in", {1}, k_scaled},
    {"inch", {1}, k_scaled},
    {"ft", {1}, k_scaled},
    {"yd", {1}, k_scaled},
    {"mi", {1}, k_scaled},
    {"nmi", {1}, k_scaled},
    {"ha", {2}, k_scaled},
    {"l", {3}, k_prefixed},
    {"L", {3}, k_prefixed},
    {"mph", {1, 0, -1}, k_scaled},
    {"kmh", {1, 0, -1}, k_scaled},
    {"kn", {1, 0, -1}, k_scaled},
    // Mass, force, pressure, energy and power.
    {"g", {0, 1}, k_prefixed},
    {"t", {0, 1}, k_prefixed},
    {"lb", {0, 1}, k_scaled},
    {"lbm", {0, 1}, k_scaled},
    {"oz", {0, 1}, k_scaled},
    {"slug", {0, 1}, k_scaled},
    {"lbf", {1, 1, -2}, k_scaled},
    {"kgf", {1, 1, -2}, k_scaled},
    {"kp", {1, 1, -2}, k_scaled},
    {"dyn", {1, 1, -2}, k_scaled},
    {"bar", {-1, 1, -2}, k_prefixed},
    {"atm", {-1, 1, -2}, k_scaled},
    {"psi", {-1, 1, -2}, k_scaled},
    {"mmHg", {-1, 1, -2}, k_scaled},
    {"erg", {2, 1, -2}, k_scaled},
    {"cal", {2, 1, -2}, k_prefixed},
    {"eV", {2, 1, -2}, k_prefixed},
    {"Wh", {2, 1, -2}, k_prefixed},
    {"hp", {2, 1, -3}, k_scaled},
    {"PS", {2, 1, -3}, k_scaled},
    {"\xC2\xB0"
     "C",
     {0, 0, 0, 0, 1},
     k_scaled},
    {"degC", {0, 0, 0, 0, 1}, k_scaled},
};

constexpr std::string_view k_prefixes[] = {"da", "Y", "Z", "E", "P", "T",        "G",        "M", "k", "h", "d",
                                           "c",  "m", "u", "n", "p", "\xC2\xB5", "\xCE\xBC", "f", "a", "z", "y"};

struct Word {
  const char* name;
  const char* unit;
};

/// Whole words for units; a plural falls under its singular.
constexpr Word k_words[] = {{"metre", "m"},  {"meter", "m"},    {"kilogram", "kg"}, {"kilogramme", "kg"},
                            {"second", "s"}, {"sec", "s"},      {"radian", "rad"},  {"newton", "N"},
                            {"joule", "J"},  {"watt", "W"},     {"pascal", "Pa"},   {"hertz", "Hz"},
                            {"volt", "V"},   {"ampere", "A"},   {"amp", "A"},       {"kelvin", "K"},
                            {"none", "1"},   {"number", "1"},   {"ratio", "1"},     {"dimensionless", "1"},
                            {"hour", "h"},   {"minute", "min"}, {"kph", "km/h"},    {"sqm", "m^2"}};

const Row* find_row(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(k_rows), std::end(k_rows), [&](const Row& row) { return row.name == name; });
  return found == std::end(k_rows) ? nullptr : found;
}

Dimension dimension_of(const Row& row) {
  Dimension dimension;
  for (std::size_t i = 0; i < dimension.powers.size(); ++i) dimension.powers[i] = row.powers[i];
  dimension.angle = row.powers.back();
  return dimension;
}

std::string word_for(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const Word& word : k_words) {
    if (name == word.name || name == std::string(word.name) + "s") return word.unit;
  }
  return {};
}

/// Nm, Nms, kgm: names of SI units side by side, longest first; empty where that is not it.
std::string split(std::string_view name) {
  for (std::size_t size = name.size(); size > 0; --size) {
    const Row* row = find_row(name.substr(0, size));
    if (row == nullptr || (row->kind != k_si && row->kind != k_alone)) continue;
    if (size == name.size()) return row->name;
    const std::string rest = split(name.substr(size));
    if (!rest.empty()) return std::string(row->name) + "*" + rest;
  }
  return {};
}

}  // namespace

std::optional<KnownUnit> find_unit(std::string_view name) {
  if (const Row* row = find_row(name)) return KnownUnit{dimension_of(*row), row->kind == k_si || row->kind == k_alone};
  for (const std::string_view prefix : k_prefixes) {
    if (name.substr(0, prefix.size()) != prefix) continue;
    const Row* row = find_row(name.substr(prefix.size()));
    if (row != nullptr && (row->kind == k_si || row->kind == k_prefixed)) return KnownUnit{dimension_of(*row), false};
  }
  return std::nullopt;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const Row& row : k_rows) names.emplace_back(row.name);
  return names;
}

std::string hint_for_unit(const std::string& name) {
  const std::string word = word_for(name);
  if (!word.empty()) return fmt::format("write '{}'", word);
  const std::string product = split(name);
  if (!product.empty()) return fmt::format("write '{}'", product);
  const std::string near = support::did_you_mean(name, unit_names());
  return near.empty() ? "units are m, kg, s, rad, A, K and what follows from them, as N or kg*m^2; 1 is a plain number"
                      : near;
}

}  // namespace gaussgen::model
