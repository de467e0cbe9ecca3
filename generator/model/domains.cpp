// Which symbols may stand where: the comments of model.hpp, enforced.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/checks.hpp"
#include "model/expressions.hpp"
#include "model/fields.hpp"
#include "model/functions.hpp"
#include "model/unit_names.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

const char* kind_name(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::time: return "the time";
    case SymbolKind::pi: return "the number";
    case SymbolKind::parameter: return "the parameter";
    case SymbolKind::input: return "the input";
    case SymbolKind::coordinate: return "the coordinate";
    case SymbolKind::quaternion_component: return "the quaternion component";
    case SymbolKind::angular_velocity: return "the angular velocity";
    case SymbolKind::speed: return "the speed";
    case SymbolKind::place: return "the place";
    case SymbolKind::spin: return "the angular velocity";
    case SymbolKind::slip: return "the slip";
    case SymbolKind::reaction: return "the reaction";
    case SymbolKind::axis: return "the axis";
  }
  return "the symbol";
}

bool allows(const Place& place, SymbolKind kind) {
  switch (kind) {
    case SymbolKind::pi: return true;
    case SymbolKind::time: return place.time;
    case SymbolKind::parameter: return place.parameters;
    case SymbolKind::input: return place.inputs;
    case SymbolKind::coordinate:
    case SymbolKind::quaternion_component: return place.coordinates;
    case SymbolKind::angular_velocity: return place.speeds;
    case SymbolKind::speed: return place.speeds && !place.defines_speeds;
    case SymbolKind::place:
    case SymbolKind::axis: return place.places;
    case SymbolKind::spin:
    case SymbolKind::slip: return place.places && place.speeds;
    case SymbolKind::reaction: return place.reactions != Reactions::none;
  }
  return false;
}

struct Unknown {
  support::Span first;
  int uses = 0;
  bool is_place = false;  ///< of which components are used, also by distance(P, Q)
  std::uint32_t last = 0;
};

class DomainCheck {
 public:
  explicit DomainCheck(Reading& reading) : reading_(reading) {
    for (const auto& [name, symbol] : reading.model.symbols) {
      if (name.find('.') == std::string::npos) names_.push_back(name);
    }
  }

  /// Each unknown name once, however often it is used.
  void report_unknown() {
    for (const auto& [name, unknown] : unknown_) {
      const std::string more = unknown.uses == 1 ? "" : fmt::format(", used {} times", unknown.uses);
      if (unknown.is_place) {
        reading_.diagnostics.error(code::k_unknown_name, unknown.first,
                                   fmt::format("there is no frame, body or point '{}'{}", name, more),
                                   hint_for_component({name, unknown.first}, ""));
        continue;
      }
      reading_.diagnostics.error(code::k_unknown_name, unknown.first, fmt::format("unknown name '{}'{}", name, more),
                                 hint_for({name, unknown.first}));
    }
  }

  /// inputs: {u: N*m}; whether it is reported.
  bool refuse_unit(const Ast& ast, const Place& place) {
    const bool is_input = &place == &input_place();
    if (!is_input && &place != &parameter_place()) return false;
    std::vector<std::string> names;
    if (!collect_units(ast, names) || names.empty()) return false;
    const auto is_known = [&](const std::string& name) { return reading_.model.symbols.count(name) > 0; };
    // A parameter may follow from others with the names of units, and one letter is rather a name with a slip.
    const bool is_meant =
        is_input ? !std::all_of(names.begin(), names.end(), is_known)
                 : std::none_of(names.begin(), names.end(), is_known) && (names.size() > 1 || names[0].size() > 1);
    if (!is_meant) return false;
    const std::string text(reading_.source.text(ast.span));
    reading_.diagnostics.error(code::k_unknown_name, ast.span, fmt::format("'{}' is a unit, and no value", text),
                               fmt::format("write {{{}unit: {}}}", is_input ? "" : "value: 1, ", text));
    return true;
  }

  void check(const Ast& ast, const Place& place) {
    if (ast.kind == AstKind::symbol && !is_broken(ast)) return check_symbol(ast, place);
    const bool is_dot = ast.kind == AstKind::call && ast.name == k_dot;
    if (is_dot && !place.speeds) {
      reading_.diagnostics.error(code::k_dot_not_allowed, ast.span,
                                 fmt::format("dot(...) may not appear in {}: {}", place.name, place.why), place.hint);
      return;
    }
    const bool is_unknown = ast.kind == AstKind::call && ast.table == nullptr && find_function(ast.name) == nullptr;
    for (const Ast& child : ast.children) {
      if (!is_unknown || !may_be_place(child, ast)) check(child, is_dot ? within_dot(place) : place);
    }
  }

 private:
  /// disatnce(P, Q): names of places stand in no other function, and where this one is meant, anything may be one.
  bool may_be_place(const Ast& argument, const Ast& call) const {
    const bool is_name = argument.kind == AstKind::symbol && argument.name.find('.') == std::string::npos;
    if (!is_name) return false;
    const std::string prefix = reading_.copies.prefix_of(call.name, call.span.begin, reading_.source);
    const bool is_distance = !support::closest(call.name.substr(prefix.size()), {k_distance}).empty();
    return is_distance || argument.name == "space" || reading_.frames.count(argument.name) > 0;
  }

  /// Rates of places are made of the rates that speeds replace.
  static Place within_dot(const Place& around) {
    Place within = inside_dot();
    if (around.places) return within;
    within.places = false;
    within.name = around.name;
    within.why = around.why;
    within.hint = around.hint;
    return within;
  }

  /// False where something else is in it.
  static bool collect_units(const Ast& ast, std::vector<std::string>& names) {
    if (is_broken(ast)) return false;
    if (ast.kind == AstKind::symbol) names.push_back(ast.name);
    const bool may_stand = ast.kind == AstKind::number || ast.kind == AstKind::product || ast.kind == AstKind::power ||
                           ast.kind == AstKind::reciprocal;
    if (ast.kind == AstKind::symbol) return find_unit(ast.name).has_value();
    return may_stand && std::all_of(ast.children.begin(), ast.children.end(),
                                    [&](const Ast& child) { return collect_units(child, names); });
  }

  void check_symbol(const Ast& ast, const Place& place) {
    const auto symbol = reading_.model.symbols.find(ast.name);
    if (symbol == reading_.model.symbols.end()) return note_unknown(ast);
    if (allows(place, symbol->second.kind)) return;
    // A distance has three components of each place.
    if (symbol->second.kind == SymbolKind::place && !places_.insert(ast.span.begin).second) return;
    reading_.diagnostics.error(code::k_not_allowed_here, ast.span,
                               fmt::format("{} '{}' may not appear in {}: {}", kind_name(symbol->second.kind), ast.name,
                                           place.name, place.why),
                               hint_for(symbol->second.kind, place));
  }

  static const char* hint_for(SymbolKind kind, const Place& place) {
    return kind == SymbolKind::coordinate && place.hint_for_coordinate != nullptr ? place.hint_for_coordinate
                                                                                  : place.hint;
  }

  void note_unknown(const Ast& ast) {
    // A reserved name that was declared is reported at its declaration.
    if (reading_.unread.may_declare(ast.name) || reading_.refused.count(ast.name) > 0) return;
    const std::size_t point = ast.name.find('.');
    const bool is_of_distance =
        point != std::string::npos && reading_.source.text(ast.span).find('.') == std::string_view::npos;
    const bool is_place = is_of_distance || is_component_of_nothing(ast.name);
    const std::string name = is_place ? ast.name.substr(0, point) : ast.name;
    const auto [unknown, is_new] = unknown_.emplace(name, Unknown{ast.span, 0, is_place, 0});
    // The three components of one place are one use of it.
    if (is_place && !is_new && unknown->second.last == ast.span.begin) return;
    unknown->second.last = ast.span.begin;
    ++unknown->second.uses;
    if (!is_new && ast.span.begin < unknown->second.first.begin) unknown->second.first = ast.span;
  }

  /// pob.x, where neither a place nor anything else is called pob.
  bool is_component_of_nothing(const std::string& name) const {
    const std::size_t point = name.find('.');
    const bool has_component = point != std::string::npos && point + 1 < name.size() && name.back() >= 'x' &&
                               name.back() <= 'z' && name.substr(point + 1).size() <= 2;
    if (!has_component) return false;
    const std::string owner = name.substr(0, point);
    return reading_.frames.count(owner) == 0 && reading_.model.symbols.count(owner) == 0;
  }

  std::string hint_for(const Name& unknown) {
    const std::string& name = unknown.text;
    const std::string prefix = reading_.copies.prefix_of(name, unknown.span.begin, reading_.source);
    const std::string own = name.substr(prefix.size());
    constexpr std::size_t k_suffix = 4;
    const bool rate = name.size() > k_suffix && name.compare(name.size() - k_suffix, k_suffix, "_dot") == 0;
    if (rate && reading_.model.symbols.count(name.substr(0, name.size() - k_suffix)) > 0) {
      return fmt::format("write dot({}) for the rate", name.substr(0, name.size() - k_suffix));
    }
    const std::size_t point = name.find('.');
    if (point != std::string::npos)
      return hint_for_component({name.substr(0, point), unknown.span}, name.substr(point + 1));
    const auto& quantities = reading_.model.quantities;
    const bool is_output = std::any_of(quantities.begin(), quantities.end(),
                                       [&](const NamedQuantity& quantity) { return quantity.name.text == name; });
    if (is_output) return "'quantities' are outputs: write here what it stands for";
    if (own == "e") return "write exp(x) for e^x; Euler's number itself is exp(1)";
    if (own == "I") return "declare a moment of inertia under 'parameters', as I1 or J";
    if (const auto place = reading_.frames.find(name); place != reading_.frames.end()) {
      const bool is_point = reading_.model.frames[place->second].is_point;
      return fmt::format("'{0}' is a {1}; its coordinates in space are {0}.x, {0}.y and {0}.z", name,
                         is_point                          ? "point"
                         : reading_.bodies.count(name) > 0 ? "body"
                                                           : "frame");
    }
    const std::string near = did_you_mean(unknown, names_, reading_);
    return near.empty() ? "declare it under 'parameters', 'inputs' or 'coordinates'" : near;
  }

  std::string hint_for_component(const Name& name, const std::string& component) {
    const std::string& owner = name.text;
    if (component == "reaction") return hint_for_reaction(name);
    if (reading_.frames.count(owner) > 0)
      return fmt::format("'{0}' has the components x, y and z, in space, and angular velocities wx, wy and wz", owner);
    if (reading_.model.symbols.count(owner) > 0) {
      return component == "dot" ? fmt::format("write dot({}) for the rate", owner)
                                : fmt::format("'{}' has no components", owner);
    }
    const std::string near = did_you_mean_one_of(
        name, [&] { return names_of(reading_.frames); }, reading_);
    return near.empty() ? "a frame, a body or a point has components: declare it under 'points'" : near;
  }

  std::string hint_for_reaction(const Name& owner) {
    const std::string component = ".reaction";
    std::vector<std::string> known;
    for (const Coordinate& coordinate : reading_.model.coordinates) {
      if (coordinate.held_at) known.push_back(coordinate.name.text + component);
    }
    for (const Contact& contact : reading_.model.contacts) known.push_back(contact.name.text + component);
    for (const Constraint& row : reading_.model.constraints) {
      if (name_in_file(row) == owner.text && row.name.text != owner.text)
        return fmt::format("each direction has its own, as {}", row.name.text + component);
      known.push_back(row.name.text + component);
    }
    const std::string near = did_you_mean({owner.text + component, owner.span}, known, reading_);
    return near.empty() ? "reactions are of constraints and of held coordinates, by their names" : near;
  }

  Reading& reading_;
  std::vector<std::string> names_;
  std::map<std::string, Unknown> unknown_;
  std::set<std::uint32_t> places_;  ///< where those begin that were reported
};

}  // namespace

void check_domains(Reading& reading) {
  DomainCheck domains(reading);
  for_each_expression(reading.model, [&](const Ast& ast, const Place& place) {
    // Made of what stands elsewhere, and is looked at there.
    if (place.reactions == Reactions::guards) return;
    const std::size_t before = reading.diagnostics.all().size();
    if (!domains.refuse_unit(ast, place)) domains.check(ast, place);
    if (reading.diagnostics.all().size() > before) reading.faulty_values.insert(ast.span.begin);
  });
  domains.report_unknown();
}

}  // namespace gaussgen::model
