// Dimensions as people write them.

#include <utility>
#include <vector>

#include "model/dimension.hpp"
#include "model/unit_parser.hpp"

namespace gaussgen::model {

using support::Rational;

namespace {

using Powers = std::vector<std::pair<std::string, Rational>>;

/// What a mechanic would say instead of base units.
constexpr const char* k_usual[] = {"N", "N*m", "W", "Pa", "N/m", "N*s/m", "N*m*s",
                                   "C", "V",   "F", "H",  "ohm", "T",     "Wb"};

std::vector<std::pair<std::string, Dimension>> read_usual() {
  std::vector<std::pair<std::string, Dimension>> usual;
  support::Diagnostics unused;
  for (const char* name : k_usual) usual.emplace_back(name, *parse_unit(spec::located(name), unused));
  return usual;
}

std::string with_exponent(const std::string& name, const Rational& exponent) {
  if (exponent == 1) return name;
  const std::string digits = support::to_text(exponent);
  return name + "^" + (support::is_integer(exponent) ? digits : "(" + digits + ")");
}

/// kg/(m*s^2)
std::string quotient(const Powers& powers) {
  std::string above, below;
  int divisors = 0;
  for (const auto& [name, exponent] : powers) {
    if (exponent == 0) continue;
    std::string& side = exponent > 0 ? above : below;
    side += (side.empty() ? "" : "*") + with_exponent(name, cln::abs(exponent));
    divisors += exponent < 0 ? 1 : 0;
  }
  if (above.empty()) above = "1";
  return divisors == 0 ? above : above + "/" + (divisors == 1 ? below : "(" + below + ")");
}

}  // namespace

std::string text(const Dimension& dimension) {
  static const auto k_known = read_usual();
  for (const auto& [name, known] : k_known) {
    if (agree(dimension, known)) return name;
  }
  // Mass first, as in kg*m^2; a mark of angle is worth a word in angles and their rates only, since r*omega is in m/s.
  Dimension without_time = dimension;
  without_time.powers[2] = 0;
  Powers powers;
  if (is_number(without_time)) powers.emplace_back("rad", dimension.angle);
  for (const std::size_t i : {1U, 0U, 2U, 3U, 4U, 5U, 6U}) powers.emplace_back(k_base_units[i], dimension.powers[i]);
  return quotient(powers);
}

}  // namespace gaussgen::model
