#include "lower/latex_name.hpp"
#include "support/characters.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace gaussgen::lower {

using support::is_digit;

namespace {

constexpr std::array<std::string_view, 34> k_greek = {
    "alpha", "beta",  "gamma",  "delta", "epsilon", "zeta",  "eta",     "theta", "iota", "kappa", "lambda", "mu",
    "nu",    "xi",    "pi",     "rho",   "sigma",   "tau",   "upsilon", "phi",   "chi",  "psi",   "omega",  "Gamma",
    "Delta", "Theta", "Lambda", "Xi",    "Pi",      "Sigma", "Upsilon", "Phi",   "Psi",  "Omega"};

/// A word without digits and underscores.
std::string word(const std::string& text, const char* font) {
  if (std::find(k_greek.begin(), k_greek.end(), text) != k_greek.end()) return "\\" + text;
  if (text.size() <= 1) return text;
  return std::string("\\") + font + "{" + text + "}";
}

/// What follows an underscore, or digits at the end.
std::string subscript(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '_' ? "," : std::string(1, c);
  const bool is_word = std::any_of(text.begin(), text.end(), [](char c) { return !is_digit(c); }) && text.size() > 1;
  return is_word ? word(result, "mathrm") : result;
}

template <class Escape>
std::string escaped(const std::string& words, Escape escape) {
  std::string result;
  for (const char c : words) result += escape(c);
  return result;
}

}  // namespace

std::string latex_name(const std::string& name) {
  if (std::all_of(name.begin(), name.end(), is_digit)) return name;
  const std::size_t underscore = name.find('_');
  const std::string stem = name.substr(0, underscore);
  const bool is_omega = stem.size() == 2 && stem[0] == 'w' && stem[1] >= 'x' && stem[1] <= 'z';
  if (is_omega && underscore == std::string::npos) return std::string("\\omega_{") + stem[1] + "}";
  std::size_t digits = stem.size();
  while (digits > 0 && is_digit(stem[digits - 1])) --digits;
  std::string below = stem.substr(digits);
  if (underscore != std::string::npos) {
    below += (below.empty() ? "" : ",") + subscript(name.substr(underscore + 1));
  }
  const std::string head = word(stem.substr(0, digits), "mathit");
  return below.empty() ? head : head + "_{" + below + "}";
}

std::string latex_text(const std::string& words) {
  return escaped(words, [](char c) -> std::string {
    switch (c) {
      case '\\': return "\\textbackslash{}";
      case '~': return "\\textasciitilde{}";
      case '^': return "\\textasciicircum{}";
      case '<': return "\\textless{}";
      case '>': return "\\textgreater{}";
      case '|': return "\\textbar{}";
      case '"': return "\\textquotedbl{}";
      case '{':
      case '}':
      case '$':
      case '&':
      case '#':
      case '%':
      case '_': return std::string("\\") + c;
      case '\n':
      case '\r':
      case '\t': return " ";
      default: return std::string(1, c);
    }
  });
}

std::string markdown_text(const std::string& words) {
  constexpr std::string_view k_special = "\\`*_{}[]#|<>$~^&";
  return escaped(words, [&](char c) -> std::string {
    if (c == '\n' || c == '\r' || c == '\t') return " ";
    return (k_special.find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
  });
}

}  // namespace gaussgen::lower
