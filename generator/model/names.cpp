#include "model/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/character_name.hpp"
#include "model/emitted_names.hpp"
#include "model/functions.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::model {

namespace code = support::code;

using support::is_letter;
using support::is_name_character;

namespace {

/// For "spring-rate" and "spring rate".
std::string joined_by_underscore(std::string name) {
  for (char& c : name) c = c == '-' || c == ' ' || c == '.' ? '_' : c;
  const bool is_name = std::all_of(name.begin(), name.end(), is_name_character) && is_letter(name.front()) &&
                       name.size() <= k_longest_name && name.back() != '_' && name.find("__") == std::string::npos;
  return is_name ? ", such as " + name : std::string();
}

/// What YAML reads wherever such a word has no quotes; empty for words that are texts.
std::string read_by_yaml(const std::string& name) {
  for (const char* word : {"true", "True", "TRUE", "false", "False", "FALSE"}) {
    if (name == word) return "a logical value";
  }
  for (const char* word : {"null", "Null", "NULL"}) {
    if (name == word) return "nothing";
  }
  return {};
}

/// Empty when the name is valid.
std::string fault_of(const std::string& name) {
  if (name.empty()) return "it is empty";
  for (std::size_t i = 0; i < name.size(); ++i) {
    const support::CodePoint point = support::code_point_at(name, i);
    if (point.value >= 0x80) return fmt::format("{}; this has {}", advise(point.value).hint, advise(point.value).name);
  }
  if (!std::all_of(name.begin(), name.end(), is_name_character))
    return "a name has ASCII letters, digits and '_' only" + joined_by_underscore(name);
  if (!is_letter(name.front())) return "a name begins with a letter";
  if (name.size() > k_longest_name) return fmt::format("a name has at most {} characters", k_longest_name);
  if (name.back() == '_') return "a name does not end with '_'";
  if (name.find("__") != std::string::npos) return "a name has no '__' in it";
  if (const std::string other = read_by_yaml(name); !other.empty())
    return fmt::format("to YAML it is {}, not a text; choose another name, such as {}1", other, name);
  return {};
}

bool refuse_as_ours(const Name& name, Reading& reading) {
  reading.diagnostics.error(code::k_reserved_name, name.span,
                            fmt::format("'{}' is a name of emitted code and cannot be used", name.text),
                            "choose another name, such as my_" + name.text);
  return false;
}

bool moves(SymbolKind kind) {
  return kind == SymbolKind::coordinate || kind == SymbolKind::quaternion_component ||
         kind == SymbolKind::angular_velocity || kind == SymbolKind::speed;
}

}  // namespace

bool check_name(const Name& name, Reading& reading) {
  const std::string fault = fault_of(name.text);
  if (fault.empty()) return !is_emitted_macro(name.text) || refuse_as_ours(name, reading);
  reading.diagnostics.error(code::k_invalid_name, name.span, fmt::format("'{}' is not a valid name", name.text), fault);
  return false;
}

void check_model_name(const Name& name, Reading& reading) {
  if (check_name(name, reading) && is_taken_in_gauss(name.text)) refuse_as_ours(name, reading);
}

namespace {

/// Enters the name among those that are declared; false if it is reserved or not the first of its name.
bool enter(const Name& name, const std::string& what, Reading& reading) {
  const bool valid = check_name(name, reading);
  if (name.text.empty()) return false;  // it stands for an expression that is reported
  if (valid && is_reserved(name.text)) {
    reading.diagnostics.error(
        code::k_reserved_name, name.span,
        fmt::format("'{}' has a fixed meaning in expressions and cannot be declared", name.text),
        name.text == "I" ? "write I1 or J for a moment of inertia" : "choose another name, such as " + name.text + "1");
    reading.refused.insert(name.text);
    return false;
  }
  const auto [place, is_new] = reading.declared.emplace(name.text, Declared{name.span, what});
  if (is_new) return true;
  reading.refused.insert(name.text);
  reading.diagnostics.error(
      code::k_name_clash, name.span,
      fmt::format("'{}' already names {} in {}", name.text, place->second.what, reading.line_text(place->second.span)),
      "parameters, inputs, tables, coordinates, speeds and components of orientations share their names; rename one");
  return false;
}

}  // namespace

void declare(const Name& name, SymbolKind kind, std::size_t index, const std::string& what, Reading& reading) {
  if (enter(name, what, reading)) reading.model.symbols[name.text] = {kind, index};
}

bool declare_table(const Name& name, Reading& reading) { return enter(name, "the table", reading); }

namespace {

void refuse_rate_name(const std::string& rate, const std::string& of, const char* what, const std::string& written,
                      Reading& reading) {
  const auto clash = reading.declared.find(rate);
  if (clash == reading.declared.end()) return;
  const Declared& owner = reading.declared.at(of);
  reading.diagnostics.error(
      code::k_rate_clash, clash->second.span,
      fmt::format("'{}' is the name of the {} of '{}' of {}", rate, what, of, reading.line_text(owner.span)), written);
}

}  // namespace

void check_rate_names(Reading& reading) {
  for (const auto& [name, symbol] : reading.model.symbols) {
    if (!moves(symbol.kind)) continue;
    refuse_rate_name(name + "_dot", name, "rate",
                     fmt::format("rename it; in expressions the rate is written dot({})", name), reading);
    if (symbol.kind == SymbolKind::coordinate)
      refuse_rate_name(name + "_ddot", name, "acceleration", "rename it: emitted code calls accelerations so", reading);
  }
}

}  // namespace gaussgen::model
