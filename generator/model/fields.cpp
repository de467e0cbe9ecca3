#include "model/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/parser.hpp"
#include "model/unit_parser.hpp"
#include "spec/foreign_space.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"
#include "support/utf8.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Node;
using spec::NodeKind;
using support::Span;

namespace {

/// Where to point for a value of the wrong kind: at the value, or at its key when there is none. An empty item of a list
/// has no place of its own.
Span place_of(const Node& node, Span owner) {
  if (node.kind == NodeKind::empty) return node.span.begin == node.span.end ? owner : node.span;
  return node.kind == NodeKind::scalar ? node.span : Span{node.span.begin, node.span.begin + 1};
}

/// What other tools and books call a key.
constexpr std::pair<const char*, const char*> k_other_words[] = {
    {"holonomic", "equation"},
    {"nonholonomic", "velocity"},
    {"loop", "coincide"},
    {"com", "centre"},
    {"mass_centre", "centre"},
    {"center_of_mass", "centre"},
    {"moment_of_inertia", "inertia"},
    {"rotation", "orientation"},
    {"attitude", "orientation"},
    {"damper", "damping"},
    {"viscosity", "damping"},
    {"rest_length", "length"},
    {"contact", "rolls"},
    {"description", "about"},
    {"doc", "about"},
    {"body", "child"},
    {"body", "bodies"},
    {"bodys", "bodies"},
    {"constants", "parameters"},
    {"rotate", "orientation"},
    {"origin", "position"},
    {"at", "position"},
    {"position", "at"},
    {"offset", "at"},
    {"default", "value"},
    {"q", "coordinates"},
    {"dof", "coordinates"},
    {"prescribed", "held_at"},
    {"locked", "held_at"},
    {"formula", "value"},
    {"expression", "value"},
    {"gravity", "uniform"},
    {"moment", "torque"},
};

std::string in_our_words(const std::string& key, const std::vector<std::string>& allowed) {
  for (const auto& [word, ours] : k_other_words) {
    if (key == word && std::find(allowed.begin(), allowed.end(), ours) != allowed.end())
      return fmt::format("did you mean '{}'?", ours);
  }
  return "";
}

/// {mass:m} and {mass=m}: the word before the sign.
std::string before_sign(const std::string& key) {
  const std::size_t sign = key.find_first_of(":=");
  return sign == std::string::npos ? std::string() : key.substr(0, key.find_last_not_of(' ', sign - 1) + 1);
}

std::string hint_for_sign(const std::string& key, const std::vector<std::string>& allowed) {
  const std::string word = before_sign(key);
  if (word.empty() || std::find(allowed.begin(), allowed.end(), word) == allowed.end()) return "";
  const std::size_t sign = key.find_first_of(":=");
  const std::size_t value = key.find_first_not_of(' ', sign + 1);
  return fmt::format("write '{}: {}', with {}", word, value == std::string::npos ? "..." : key.substr(value),
                     key[sign] == ':' ? "a blank behind the ':'" : "':' in place of '='");
}

std::string hint_for_key(const Node& map, const spec::Entry& entry, const std::vector<std::string>& allowed) {
  const std::string with_sign = hint_for_sign(entry.key.text, allowed);
  if (!with_sign.empty() && entry.value.kind == NodeKind::empty) return with_sign;
  const std::string word = support::closest_or_begun(entry.key.text, allowed);
  std::string near = word.empty() ? in_our_words(entry.key.text, allowed) : fmt::format("did you mean '{}'?", word);
  const bool is_of_joint = std::find(allowed.begin(), allowed.end(), "coordinates") != allowed.end() &&
                           std::find(allowed.begin(), allowed.end(), "child") != allowed.end();
  if (near.empty() && is_of_joint && entry.key.text == "held_at")
    return "declare the coordinate under 'coordinates' with 'held_at', and name it here with 'coordinates'";
  // {about: of the centre, from the axis}: the second half arrives as a key without value, and something stands before it.
  const bool has_no_value = near.empty() && map.flow && entry.value.kind == NodeKind::empty;
  if (has_no_value && &entry == &map.entries.front())
    return "write 'key: value'; the key is one of " + support::joined(allowed);
  if (has_no_value) return "the ',' before it ends a value in {...}: quote a text that has a comma";
  return near + (near.empty() ? "" : " ") + "allowed here: " + support::joined(allowed);
}

const char* hint_for_kind(NodeKind wanted, bool empty) {
  switch (wanted) {
    case NodeKind::map: return "write 'key: value' pairs, indented below it or in {...}";
    case NodeKind::sequence: return "write the entries in brackets, as in [a, b, c]";
    default:
      return empty ? "write the value behind the ':'" : "write the value itself, without brackets or braces around it";
  }
}

/// "m:2" is one word to YAML.
bool lacks_blank(const Node& node) {
  const std::string& text = node.scalar.text;
  const std::size_t colon = text.find(':');
  return node.kind == NodeKind::scalar && node.plain && colon != std::string::npos && colon + 1 < text.size() &&
         text.find(' ') == std::string::npos;
}

const char* hint_for_blank(const std::string& text) {
  const bool is_foreign = spec::is_foreign_space(support::code_point_at(text, text.find(':') + 1).value);
  return is_foreign ? "write an ordinary space behind the ':': this one is a letter to YAML"
                    : "write a blank behind the ':', as in 'key: value'";
}

bool expect(NodeKind kind, const char* wanted, const Node& node, Span owner, const std::string& where, Reading& reading,
            const char* hint = nullptr) {
  if (node.kind == kind) return true;
  reading.diagnostics.error(code::k_wrong_kind, place_of(node, owner),
                            fmt::format("{} must be {}, and here is {}", where, wanted, kind_text(node)),
                            kind == NodeKind::map && lacks_blank(node) ? hint_for_blank(node.scalar.text)
                            : hint != nullptr                          ? hint
                                              : hint_for_kind(kind, node.kind == NodeKind::empty));
  return false;
}

/// How each key that has to be there may look.
std::string example_of(const std::string& key, const std::string& where) {
  if (key == "is" && where.rfind("speed", 0) == 0) return "is: dot(x)*cos(psi) + dot(y)*sin(psi)";
  static const std::map<std::string, const char*> k_examples{{"gauss", "1"},
                                                             {"name", "pendulum"},
                                                             {"value", "0.5"},
                                                             {"mass", "0.5"},
                                                             {"position", "[x, 0, 0]"},
                                                             {"euler", "zxz"},
                                                             {"angles", "[psi, theta, phi]"},
                                                             {"quaternion", "[e0, e1, e2, e3]"},
                                                             {"angular_velocity", "[wx, wy, wz]"},
                                                             {"velocity", "dot(x) - r*dot(phi)"},
                                                             {"dependent", "[x]"},
                                                             {"of", "[0, 1, 2]"},
                                                             {"file", "leg.yaml"},
                                                             {"type", "revolute"},
                                                             {"child", "rod"},
                                                             {"at", "[0, 0, 0]"},
                                                             {"is", "2"},
                                                             {"on", "arm"},
                                                             {"axis", "z"},
                                                             {"angle", "psi"},
                                                             {"direction", "x"},
                                                             {"stiffness", "100"},
                                                             {"limit", "mu*m*g"},
                                                             {"smooth", "0.001"},
                                                             {"directions", "[x, y]"},
                                                             {"coefficient", "0.0002"},
                                                             {"quadratic", "0.01"},
                                                             {"displaced", "rho*V"},
                                                             {"values", "[0, 3, 4]"}};
  const auto found = k_examples.find(key);
  return found == k_examples.end() ? key : fmt::format("{}: {}", key, found->second);
}

bool is_whole_number(const Node& node) {
  return node.kind == NodeKind::scalar && !node.scalar.text.empty() &&
         node.scalar.text.find_first_not_of("0123456789") == std::string::npos;
}

/// [0,5, 0, 1]: too many entries, with numbers that no blank parts; or twice as many, all of them numbers.
bool has_decimal_commas(const Node& list, std::size_t length) {
  if (!list.flow || list.items.size() <= length) return false;
  std::size_t tight = 0;
  for (std::size_t i = 0; i + 1 < list.items.size(); ++i) {
    const Node& second = list.items[i + 1];
    const bool is_number = list.items[i].kind == NodeKind::scalar && !list.items[i].scalar.text.empty() &&
                           support::is_digit(list.items[i].scalar.text.back()) && is_whole_number(second);
    if (is_number && list.items[i].span.end + 1 == second.span.begin) ++tight;
  }
  const bool are_all_tight = tight + 1 == list.items.size();
  return are_all_tight ? list.items.size() == 2 * length : tight > 0;
}

std::string hint_for_count(const Node& list, std::size_t length) {
  if (list.items.size() < length) return fmt::format("write all {}; what vanishes is written as 0", length);
  return fmt::format("keep {} of them", length);
}

}  // namespace

std::string kind_text(const Node& node) {
  switch (node.kind) {
    case NodeKind::empty: return "nothing";
    case NodeKind::scalar: return "a single value";
    case NodeKind::sequence: return "a list";
    case NodeKind::map: return "a map";
  }
  return "nothing";
}

bool expect_map(const Node& node, Span owner, const std::string& where, Reading& reading) {
  return expect(NodeKind::map, "a map of 'key: value'", node, owner, where, reading);
}

bool expect_list(const Node& node, Span owner, const std::string& where, Reading& reading, const char* hint) {
  return expect(NodeKind::sequence, "a list [...]", node, owner, where, reading, hint);
}

bool expect_scalar(const Node& node, Span owner, const std::string& where, Reading& reading) {
  return expect(NodeKind::scalar, "a single value", node, owner, where, reading);
}

bool expect_length(const Node& list, std::size_t length, const std::string& where, Reading& reading,
                   const std::string& hint) {
  if (list.items.size() == length) return true;
  reading.diagnostics.error(code::k_wrong_count, list.span,
                            fmt::format("{} needs {} entries, and here are {}", where, length, list.items.size()),
                            has_decimal_commas(list, length) ? "a comma separates entries; the decimal sign is a point"
                            : hint.empty()                   ? hint_for_count(list, length)
                                                             : hint);
  return false;
}

void check_keys(const Node& map, const std::string& where, const std::vector<std::string>& allowed, Reading& reading) {
  for (const spec::Entry& entry : map.entries) {
    const std::string& key = entry.key.text;
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    reading.diagnostics.error(code::k_unknown_key, entry.key.span, fmt::format("{} has no key '{}'", where, key),
                              hint_for_key(map, entry, allowed));
    reading.unknown_keys.insert(entry.key.span.begin);
    // It may be a declaring one with a slip in its name, or an entry that has lost its indentation.
    reading.unread.add(entry);
  }
}

bool has_misspelt(const Node& map, const std::string& key, const Reading& reading) {
  return std::any_of(map.entries.begin(), map.entries.end(), [&](const spec::Entry& entry) {
    if (reading.unknown_keys.count(entry.key.span.begin) == 0) return false;
    return support::closest_or_begun(entry.key.text, {key}) == key || before_sign(entry.key.text) == key ||
           !in_our_words(entry.key.text, {key}).empty();
  });
}

const Node* required(const Node& map, const std::string& key, Span owner, const std::string& where, Reading& reading,
                     const std::string& more) {
  const Node* node = spec::find(map, key);
  if (node == nullptr && !has_misspelt(map, key, reading))
    reading.diagnostics.error(code::k_missing_key, owner, fmt::format("{} needs the key '{}'", where, key),
                              fmt::format("add it, as in '{}'{}", example_of(key, where), more));
  return node;
}

std::string text_field(const Node& map, const std::string& key, Reading& reading) {
  for (const spec::Entry& entry : map.entries) {
    if (entry.key.text != key || entry.value.kind == NodeKind::empty) continue;
    if (expect_scalar(entry.value, entry.key.span, "'" + key + "'", reading)) return entry.value.scalar.text;
  }
  return {};
}

std::optional<Dimension> dimension_at(const Node& map, const std::string& key, const std::string& unit,
                                      Reading& reading) {
  if (unit.empty()) return std::nullopt;
  return parse_unit(spec::find(map, key)->scalar, reading.diagnostics);
}

namespace {

/// Said once, of the expression that is too much.
bool take_from_budget(const Node& node, Reading& reading) {
  if (reading.expressions.is_spent()) return false;
  reading.expressions.take(node.scalar.text.size());
  if (!reading.expressions.is_spent()) return true;
  reading.diagnostics.error(
      code::k_file_too_large, node.span,
      fmt::format("the expressions of the model have more than {} characters in all", ExpressionBudget::k_most),
      "name what is repeated as a parameter, or make fewer copies");
  return false;
}

}  // namespace

Ast read_expression(const Node& node, Span owner, Reading& reading) {
  if (node.kind == NodeKind::empty) {
    reading.diagnostics.error(code::k_empty_expression, place_of(node, owner), "an expression is missing here",
                              k_hint_for_empty_expression);
    return broken_expression();
  }
  if (!expect(NodeKind::scalar, "an expression", node, owner, "this", reading)) return broken_expression();
  if (node.is_cut) return broken_expression();  // its names are not those that were meant
  if (!take_from_budget(node, reading)) return broken_expression();
  Ast ast = parse_readable(node.scalar, reading.diagnostics, reading.tables);
  // Repetition and submodels change names.
  if (reading.source.text(node.span) != node.scalar.text) ast.text = node.scalar.text;
  return ast;
}

std::optional<Ast> expression_field(const Node& map, const std::string& key, Reading& reading) {
  for (const spec::Entry& entry : map.entries) {
    if (entry.key.text == key) return read_expression(entry.value, entry.key.span, reading);
  }
  return std::nullopt;
}

std::array<Ast, 3> read_vector(const Node& node, Span owner, const std::string& where, Reading& reading) {
  std::array<Ast, 3> vector;
  vector.fill(broken_expression());
  if (!expect_list(node, owner, where, reading) || !expect_length(node, vector.size(), where, reading)) return vector;
  for (std::size_t i = 0; i < vector.size(); ++i) vector[i] = read_expression(node.items[i], node.span, reading);
  return vector;
}

bool declares(const std::string& section) {
  static const std::set<std::string> k_sections{"parameters", "inputs", "coordinates", "orientations", "frames",
                                                "joints",     "speeds", "bodies",      "particles",    "points"};
  return k_sections.count(section) > 0;
}

namespace {

/// [m, l] and "- m: 1" name what they declare; 3, oops and [] leave it open.
bool names_entries(const Node& section) {
  const auto is_name = [](const Node& item) {
    return item.kind == NodeKind::map || (item.kind == NodeKind::scalar && !is_whole_number(item));
  };
  return section.kind == NodeKind::sequence && std::any_of(section.items.begin(), section.items.end(), is_name);
}

}  // namespace

void note_unread_section(const spec::Entry& section, Reading& reading) {
  reading.unread.add(section);
  if (declares(section.key.text) && !names_entries(section.value)) reading.unread.add_everything();
}

Name name_of(const spec::LocatedText& text) { return {text.text, text.span}; }

namespace {

std::string hint_for_left_out(const std::string& name, const Reading& reading) {
  for (const LeftOut& entry : reading.left_out) {
    if (entry.names.may_declare(name) && !entry.effect.empty())
      return fmt::format("'{}' is of the effect '{}', which does not act", entry.entry, entry.effect);
    if (entry.names.may_declare(name))
      return fmt::format("'without' of submodel '{}' leaves out '{}', and this needs it", entry.submodel, entry.entry);
  }
  return "";
}

}  // namespace

std::string did_you_mean(const Name& name, const std::vector<std::string>& candidates, Reading& reading) {
  if (!reading.searches.begin(candidates.size())) return "";
  if (std::string hint = hint_for_left_out(name.text, reading); !hint.empty()) return hint;
  const std::string prefix = reading.copies.prefix_of(name.text, name.span.begin, reading.source);
  if (prefix.empty()) return support::did_you_mean(name.text, candidates);
  std::vector<std::string> own;
  for (const std::string& candidate : candidates) {
    if (candidate.compare(0, prefix.size(), prefix) == 0) own.push_back(candidate.substr(prefix.size()));
  }
  const std::string near = support::closest(name.text.substr(prefix.size()), own);
  return near.empty() ? near : fmt::format("did you mean '{}{}'?", prefix, near);
}

}  // namespace gaussgen::model
