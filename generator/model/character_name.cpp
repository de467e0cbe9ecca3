#include "model/character_name.hpp"

#include <fmt/format.h>

namespace gaussgen::model {

namespace {

struct Known {
  char32_t value;
  const char* name;
  const char* hint;
};

constexpr Known k_known[] = {
    {'=', "", "an expression stands for one value; a constraint is written as the expression that is zero"},
    {'<', "", "comparisons are not part of expressions"},
    {'>', "", "comparisons are not part of expressions"},
    {'[', "", "round brackets group; '[...]' is a list of the file format"},
    {'{', "", "round brackets group; '{...}' is a map of the file format"},
    {'\'', "", "write the time derivative of x as dot(x)"},
    {'%', "", "write 12/100 for twelve percent, and $(i%2) for the remainder of an index"},
    {'!', "", "the factorial is not available"},
    {'|', "", "write sqrt(x^2) for the absolute value"},
    {'_', "", "a name begins with a letter"},
    {'.', "", "a number needs a digit beside its point, as in 0.5"},
    {0x00A0, "no-break space", "replace it by an ordinary space"},
    {0x00B2, "superscript two", "write ^2"},
    {0x00B3, "superscript three", "write ^3"},
    {0x00B7, "middle dot", "write * for a product"},
    {0x00D7, "multiplication sign", "write * for a product"},
    {0x00F7, "division sign", "write / for a quotient"},
    {0x02D9, "dot above", "write the time derivative of x as dot(x)"},
    {0x0307, "combining dot above", "write the time derivative of x as dot(x)"},
    {0x2010, "hyphen", "write the ASCII minus -"},
    {0x2013, "en dash", "write the ASCII minus -"},
    {0x2014, "em dash", "write the ASCII minus -"},
    {0x2212, "minus sign", "write the ASCII minus -"},
    {0x2215, "division slash", "write / for a quotient"},
    {0x221A, "square root", "write sqrt(...)"},
    {0x22C5, "dot operator", "write * for a product"},
    {0x2019, "right single quotation mark", "write the time derivative of x as dot(x)"},
    {0x3000, "ideographic space", "replace it by an ordinary space"},
};

constexpr const char* k_greek[] = {"alpha",   "beta", "gamma", "delta",       "epsilon", "zeta", "eta",
                                   "theta",   "iota", "kappa", "lambda",      "mu",      "nu",   "xi",
                                   "omicron", "pi",   "rho",   "final sigma", "sigma",   "tau",  "upsilon",
                                   "phi",     "chi",  "psi",   "omega"};
constexpr char32_t k_first_small = 0x03B1;
constexpr char32_t k_first_capital = 0x0391;

std::string utf8(char32_t value) {
  std::string text;
  const auto add = [&](char32_t bits) { text.push_back(static_cast<char>(static_cast<unsigned char>(bits))); };
  if (value < 0x80) {
    add(value);
  } else if (value < 0x800) {
    add(0xC0 | (value >> 6));
    add(0x80 | (value & 0x3F));
  } else if (value < 0x10000) {
    add(0xE0 | (value >> 12));
    add(0x80 | ((value >> 6) & 0x3F));
    add(0x80 | (value & 0x3F));
  } else {
    add(0xF0 | (value >> 18));
    add(0x80 | ((value >> 12) & 0x3F));
    add(0x80 | ((value >> 6) & 0x3F));
    add(0x80 | (value & 0x3F));
  }
  return text;
}

std::string label(char32_t value, const std::string& name) {
  const auto number = static_cast<std::uint32_t>(value);
  return name.empty() ? fmt::format("'{}' (U+{:04X})", utf8(value), number)
                      : fmt::format("'{}' (U+{:04X}, {})", utf8(value), number, name);
}

CharacterAdvice greek(char32_t value, char32_t first, const char* size) {
  const std::string letter = k_greek[value - first];
  return {label(value, fmt::format("Greek {} letter {}", size, letter)),
          fmt::format("spell the name in ASCII letters, such as {}", letter == "final sigma" ? "sigma" : letter)};
}

}  // namespace

CharacterAdvice advise(char32_t value) {
  for (const Known& known : k_known) {
    if (known.value != value) continue;
    return {value < 0x80 ? "'" + utf8(value) + "'" : label(value, known.name), known.hint};
  }
  if (value >= k_first_small && value <= k_first_small + 24) return greek(value, k_first_small, "small");
  if (value >= k_first_capital && value <= k_first_capital + 24) return greek(value, k_first_capital, "capital");
  if (value < 0x80) return {"'" + utf8(value) + "'", "expressions hold numbers, names, + - * / ^ and round brackets"};
  return {label(value, ""), "expressions and names are written in ASCII"};
}

}  // namespace gaussgen::model
