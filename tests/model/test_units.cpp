#include "building.hpp"
#include "catch_shim.hpp"
#include "model/unit_names.hpp"
#include "model/unit_parser.hpp"

using namespace gaussgen;

namespace {

/// The dimension in usual units, or the message of the only mistake.
std::string read(const std::string& unit) {
  support::Diagnostics diagnostics;
  const auto dimension = model::parse_unit(spec::located(unit), diagnostics);
  CHECK(dimension.has_value() == diagnostics.all().empty());
  CHECK(diagnostics.all().size() <= 1);
  return dimension ? model::text(*dimension) : diagnostics.all()[0].message;
}

bool same(const std::string& a, const std::string& b) { return read(a) == read(b); }

bool is_coherent(const std::string& name) {
  const auto unit = model::find_unit(name);
  REQUIRE(unit);
  return unit->is_coherent;
}

}  // namespace

TEST_CASE("a unit is its base units to their powers") {
  CHECK(read("1") == "1");
  CHECK(read("m") == "m");
  CHECK(read("kg*m^2") == "kg*m^2");
  CHECK(read("kg/m/s") == "kg/(m*s)");
  CHECK(read("1/s^2") == "1/s^2");
  CHECK(read("m^-2*kg") == "kg/m^2");
  CHECK(read("m^(1/2)") == "m^(1/2)");
  CHECK(read("m^(-3/2)*s") == "s/m^(3/2)");
  CHECK(read("(m/s)^2") == "m^2/s^2");
  CHECK(read("1/(m*(s*A))^2") == "1/(m^2*s^2*A^2)");
  CHECK(read("K*mol*cd") == "K*mol*cd");
}

TEST_CASE("quotients go from left to right") {
  CHECK(read("m/s*s") == "m");
  CHECK(read("m/s/s") == "m/s^2");
}

TEST_CASE("blanks, middle dots and raised digits are read") {
  CHECK(read(" kg * m ^ 2 / s ") == "N*m*s");
  CHECK(read("kg\xC2\xB7m\xC2\xB2\xE2\x8B\x85s\xE2\x81\xBB\xC2\xB2") == "N*m");
  CHECK(read("s\xE2\x81\xBB\xC2\xB9") == "1/s");
  CHECK(read("m\xC2\xB9\xC2\xB2") == "m^12");
}

TEST_CASE("derived units are what they stand for") {
  CHECK(same("N", "kg*m/s^2"));
  CHECK(same("Pa", "N/m^2"));
  CHECK(same("J", "N*m"));
  CHECK(same("W", "J/s"));
  CHECK(same("C", "A*s"));
  CHECK(same("V", "W/A"));
  CHECK(same("ohm", "V/A"));
  CHECK(same("\xCE\xA9", "ohm"));
  CHECK(same("\xE2\x84\xA6", "ohm"));
  CHECK(same("S", "1/ohm"));
  CHECK(same("F", "C/V"));
  CHECK(same("H", "V*s/A"));
  CHECK(same("Wb", "V*s"));
  CHECK(same("T", "Wb/m^2"));
  CHECK(same("Hz", "1/s"));
}

TEST_CASE("units outside of SI have its dimensions") {
  for (const char* length : {"km", "mm", "um", "\xC2\xB5m", "nm", "dam", "in", "ft", "yd", "mi"})
    CHECK(same(length, "m"));
  for (const char* mass : {"g", "mg", "t", "lb", "slug", "oz"}) CHECK(same(mass, "kg"));
  for (const char* time : {"ms", "us", "min", "h", "d"}) CHECK(same(time, "s"));
  for (const char* force : {"kN", "MN", "lbf", "kgf", "dyn"}) CHECK(same(force, "N"));
  for (const char* pressure : {"bar", "mbar", "psi", "atm", "MPa"}) CHECK(same(pressure, "Pa"));
  for (const char* angle : {"deg", "degrees", "\xC2\xB0", "rev", "mrad"}) CHECK(read(angle) == "rad");
  for (const char* energy : {"cal", "kWh", "eV", "erg"}) CHECK(same(energy, "J"));
  CHECK(read("rpm") == "rad/s");
  CHECK(read("l") == "m^3");
  CHECK(same("hp", "W"));
}

TEST_CASE("only units of SI are taken without a conversion") {
  for (const char* name : {"m", "kg", "s", "A", "K", "rad", "N", "Pa", "J", "Hz", "ohm", "T"}) CHECK(is_coherent(name));
  for (const char* name : {"mm", "g", "ms", "deg", "rpm", "kN", "min", "t", "l", "bar", "psi"})
    CHECK_FALSE(is_coherent(name));
}

TEST_CASE("a name is a unit before it is a prefix with one") {
  CHECK(same("min", "s"));
  CHECK(same("ft", "m"));
  CHECK(same("Pa", "N/m^2"));
  CHECK(same("cd", "cd"));
  CHECK_FALSE(model::find_unit("kkg"));
  CHECK_FALSE(model::find_unit("kft"));
  CHECK_FALSE(model::find_unit("k"));
}

TEST_CASE("angles are numbers that are shown in angles and their rates alone") {
  CHECK(read("rad") == "rad");
  CHECK(read("rad/s^2") == "rad/s^2");
  CHECK(read("m*rad/s") == "m/s");
  CHECK(read("N*m/rad") == "N*m");
  CHECK(read("rad/rad") == "1");
}

TEST_CASE("dimensions are printed in units that people use") {
  CHECK(read("kg*m/s^2") == "N");
  CHECK(read("kg/s^2") == "N/m");
  CHECK(read("kg/s") == "N*s/m");
  CHECK(read("kg*m^2/s") == "N*m*s");
  CHECK(read("kg*m^2/s^3") == "W");
  CHECK(read("J/m^3") == "Pa");
  CHECK(read("kg/m^3") == "kg/m^3");
}

TEST_CASE("a slip in a unit gets what was meant") {
  CHECK(model::hint_for_unit("Nm") == "write 'N*m'");
  CHECK(model::hint_for_unit("Nms") == "write 'N*m*s'");
  CHECK(model::hint_for_unit("kgm") == "write 'kg*m'");
  CHECK(model::hint_for_unit("Meters") == "write 'm'");
  CHECK(model::hint_for_unit("sec") == "write 's'");
  CHECK(model::hint_for_unit("none") == "write '1'");
  CHECK(model::hint_for_unit("raf") == "did you mean 'rad'?");
  CHECK(model::hint_for_unit("furlong").substr(0, 9) == "units are");
}

TEST_CASE("what is no unit is refused, however odd") {
  for (const char* text : {"",         "*",
                           "m*",       "m m",
                           "2",        "0",
                           "m^",       "m^0",
                           "m^(1/0)",  "m^(1",
                           "m^123",    "m^1/2",
                           "(",        ")",
                           "()",       "m)",
                           "^2",       "m^-",
                           "1.5*m",    "-",
                           "m-s",      "$",
                           "\xFF",     "m\xE2\x81\xB0",
                           "\xC2\xB2", "m\xC2\xB2\xC2\xB3\xC2\xB2",
                           "m^^2",     "m**2"}) {
    INFO(text);
    support::Diagnostics diagnostics;
    CHECK_FALSE(model::parse_unit(spec::located(text), diagnostics));
    REQUIRE(diagnostics.all().size() == 1);
    CHECK_FALSE(diagnostics.all()[0].hint.empty());
  }
  CHECK(read(std::string(100, '(')) == "the brackets of this unit are too deep");
}
