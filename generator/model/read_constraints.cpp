// constraints: on velocities, on positions, or between places; and the choice of the speeds that they determine.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/ast_build.hpp"
#include "model/attitude.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/frames.hpp"
#include "model/names.hpp"
#include "model/read_laws.hpp"
#include "model/regime.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;

namespace {

/// What is not known may move by any coordinate.
std::size_t unsure_place_at(const Node& node, support::Span owner, const std::string& what, Reading& reading) {
  const auto found = find_frame_at(node, owner, what, reading);
  if (!found) reading.has_unknown_carrier = true;
  return found.value_or(k_space);
}

/// Reactions of held coordinates and of constraints are reported side by side, by name.
void check_label(const Name& name, Reading& reading) {
  const auto symbol = reading.model.symbols.find(name.text);
  if (symbol == reading.model.symbols.end() || symbol->second.kind != SymbolKind::coordinate) return;
  const Coordinate& coordinate = reading.model.coordinates[symbol->second.index];
  if (!coordinate.held_at) return;
  reading.diagnostics.error(
      code::k_name_clash, name.span,
      fmt::format("'{}' already names the held coordinate in {}", name.text, reading.line_text(coordinate.name.span)),
      "both would label a reaction; rename the constraint");
}

class ConstraintReader {
 public:
  ConstraintReader(const Entry& entry, Reading& reading)
      : map_(entry.value), name_(name_of(entry.key)), reading_(reading) {}

  void run() {
    const std::string where = fmt::format("constraint '{}'", name_.text);
    check_name(name_, reading_);
    if (!expect_map(map_, name_.span, where, reading_)) return add(VelocityLaw{broken_expression()}, name_.span);
    about_ = text_field(map_, "about", reading_);
    const Entry* law = find_law(where);
    if (law == nullptr) return add(VelocityLaw{broken_expression()}, name_.span);
    check_keys(map_, where, format::keys_beside(format::constraint(), law->key.text), reading_);
    breaks_at_ = expression_field(map_, "breaks_at", reading_);
    is_broken_ = breaks_at_ && mode_of(name_.text, {Mode::holds, Mode::broken}, reading_) == Mode::broken;
    read_law(*law, where);
  }

 private:
  /// The key that says what kind of constraint it is; a missing, second or misspelt one is reported.
  const Entry* find_law(const std::string& where) {
    const Entry* law = nullptr;
    for (const Entry& field : map_.entries) {
      if (!format::is_law(format::constraint(), field.key.text)) continue;
      if (law != nullptr) {
        reading_.diagnostics.error(code::k_conflicting_keys, field.key.span,
                                   fmt::format("{} has '{}' beside '{}'", where, field.key.text, law->key.text),
                                   "write two constraints with names of their own");
        return nullptr;
      }
      law = &field;
    }
    if (law != nullptr) return law;
    const std::size_t findings = reading_.diagnostics.all().size();
    check_keys(map_, where, format::keys_of(format::constraint()), reading_);
    if (reading_.diagnostics.all().size() == findings) {
      reading_.diagnostics.error(code::k_missing_key, name_.span, fmt::format("{} has no law", where),
                                 "add one of velocity: dot(x) - r*dot(phi), equation: x^2 + y^2 - L^2, rolls: body, "
                                 "no_slip: body, coincide: [P, Q], distance: [P, Q]");
    }
    return nullptr;
  }

  void read_law(const Entry& law, const std::string& where) {
    const std::string& key = law.key.text;
    if (key == "velocity") add(VelocityLaw{read_expression(law.value, law.key.span, reading_)}, law.value.span);
    if (key == "equation") add(PositionLaw{read_expression(law.value, law.key.span, reading_)}, law.value.span);
    if (key == "rolls") read_rolling(law, where);
    if (key == "no_slip") read_slip(law, where);
    if (key == "coincide") read_coincidence(law);
    if (key == "distance") read_distance(law);
  }

  template <class Law>
  void add(Law law, support::Span span, const std::string& suffix = "") {
    Constraint constraint;
    constraint.name = {name_.text + suffix, name_.span};
    constraint.about = about_;
    constraint.span = span;
    constraint.law = std::move(law);
    constraint.may_vanish = !suffix.empty();
    constraint.breaks_at = breaks_at_;
    if (is_broken_) return reading_.model.broken.push_back(std::move(constraint));
    if (const Node* point = spec::find(map_, "point")) {
      constraint.point = read_vector(*point, name_.span, "'point'", reading_);
    }
    reading_.model.constraints.push_back(std::move(constraint));
  }

  std::size_t place_at(const Node& node, support::Span owner, const std::string& what) {
    return unsure_place_at(node, owner, what, reading_);
  }

  SlipLaw read_contact(const Entry& law, const std::string& where) {
    return read_contact_of(map_, name_.span, law, where, reading_);
  }

  // No slip in three directions: along those in which the motion is held already, nothing remains to be said.
  void read_rolling(const Entry& law, const std::string& where) {
    SlipLaw contact = read_contact(law, where);
    contact.axes = contact.surface;
    for (std::size_t i = 0; i < 3; ++i) {
      SlipLaw row = contact;
      row.direction[i] = number(1);
      add(std::move(row), law.value.span, std::string("_") + "xyz"[i]);
    }
  }

  void read_slip(const Entry& law, const std::string& where) {
    SlipLaw contact = read_contact(law, where);
    if (const Node* in = spec::find(map_, "in")) contact.axes = place_at(*in, name_.span, "'in'");
    const Node* direction = required(map_, "direction", name_.span, where, reading_);
    if (direction == nullptr) return add(VelocityLaw{broken_expression()}, name_.span);
    const auto axis = read_axis(*direction, name_.span, "'direction'", reading_);
    if (const char* letter = std::get_if<char>(&axis)) {
      contact.direction[static_cast<std::size_t>(*letter - 'x')] = number(1);
    } else {
      contact.direction = std::get<std::array<Ast, 3>>(axis);
    }
    add(std::move(contact), law.value.span);
  }

  /// Two places by name, or nothing after a report.
  std::optional<std::array<Name, 2>> read_pair(const Entry& law) {
    const std::string where = "'" + law.key.text + "'";
    if (!expect_list(law.value, law.key.span, where, reading_, k_hint_for_pair) ||
        !expect_length(law.value, 2, where, reading_, k_hint_for_pair)) {
      return std::nullopt;
    }
    std::array<Name, 2> pair;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!expect_scalar(law.value.items[i], law.value.span, "a place", reading_)) return std::nullopt;
      pair[i] = name_of(law.value.items[i].scalar);
      if (!find_frame(pair[i], reading_)) return std::nullopt;
    }
    return pair;
  }

  void read_coincidence(const Entry& law) {
    const auto pair = read_pair(law);
    const Node* in = spec::find(map_, "in");
    const std::size_t axes = in == nullptr ? k_space : place_at(*in, name_.span, "'in'");
    for (std::size_t i = 0; i < 3; ++i) {
      PositionLaw row{pair ? gap_along(*pair, axes, i) : broken_expression(), true};
      if (pair) row.phi = closing_along(*pair, axes, i);
      add(std::move(row), law.value.span, std::string("_") + "xyz"[i]);
    }
  }

  /// (P - Q)·e for an axis e of a frame.
  Ast gap_along(const std::array<Name, 2>& pair, std::size_t frame, std::size_t axis) {
    const auto gap = [&](std::size_t i) { return difference_of(component_of(pair[0], i), component_of(pair[1], i)); };
    if (frame == k_space) return gap(axis);
    std::vector<Ast> terms;
    for (std::size_t i = 0; i < 3; ++i) terms.push_back(product_of(axis_of(frame, axis, i, pair[0].span), gap(i)));
    return node_of(AstKind::sum, pair[0].span, std::move(terms));
  }

  /// A component in space of an axis of a frame.
  Ast axis_of(std::size_t frame, std::size_t axis, std::size_t component, support::Span span) {
    const std::string name =
        fmt::format("{}.{}:{}", reading_.model.frames[frame].name.text, "xyz"[axis], "xyz"[component]);
    reading_.model.symbols[name] = {SymbolKind::axis, 9 * frame + 3 * axis + component};
    return symbol_of(name, span);
  }

  /// e·c_k d((P - Q)·c_k)/dt over the axes c of what carries both places. Before they meet, as in a search for a start, (P - Q)·e also
  /// changes as e turns, and as all that carries the loop turns: neither closes it.
  std::optional<Ast> closing_along(const std::array<Name, 2>& pair, std::size_t frame, std::size_t axis) {
    const std::size_t carrier = common_carrier(*find_frame(pair[0], reading_), *find_frame(pair[1], reading_));
    if (frame == carrier) return std::nullopt;
    const support::Span span = pair[0].span;
    std::vector<Ast> terms;
    for (std::size_t k = 0; k < 3; ++k) {
      Ast closing = call_of("dot", gap_along(pair, carrier, k));
      if (carrier == k_space) {
        terms.push_back(product_of(axis_of(frame, axis, k, span), std::move(closing)));
      } else if (frame == k_space) {
        terms.push_back(product_of(axis_of(carrier, k, axis, span), std::move(closing)));
      } else {
        std::vector<Ast> inner;
        for (std::size_t i = 0; i < 3; ++i)
          inner.push_back(product_of(axis_of(frame, axis, i, span), axis_of(carrier, k, i, span)));
        terms.push_back(product_of(node_of(AstKind::sum, span, std::move(inner)), std::move(closing)));
      }
    }
    return node_of(AstKind::sum, span, std::move(terms));
  }

  /// The last frame from which the chains to both part. (A ring of frames, which is an error, ends in space.)
  std::size_t common_carrier(std::size_t a, std::size_t b) const {
    const std::vector<std::size_t> ways = carriers_of(a);
    for (const std::size_t frame : carriers_of(b)) {
      if (std::find(ways.begin(), ways.end(), frame) != ways.end()) return frame;
    }
    return k_space;
  }

  std::vector<std::size_t> carriers_of(std::size_t frame) const {
    std::vector<std::size_t> result;
    for (; frame != k_space && result.size() < reading_.model.frames.size();
         frame = reading_.model.frames[frame].parent)
      result.push_back(frame);
    return result;
  }

  void read_distance(const Entry& law) {
    const auto pair = read_pair(law);
    const Node* length = required(map_, "is", name_.span, fmt::format("constraint '{}'", name_.text), reading_);
    Ast value = length == nullptr ? broken_expression() : read_expression(*length, name_.span, reading_);
    Ast distance = pair ? distance_between((*pair)[0], (*pair)[1]) : broken_expression();
    add(PositionLaw{difference_of(std::move(distance), std::move(value))}, law.value.span);
  }

  const Node& map_;
  Name name_;
  std::string about_;
  std::optional<Ast> breaks_at_;
  bool is_broken_ = false;  ///< in the regime that is read
  Reading& reading_;
};

}  // namespace

namespace {

/// The directions of `c` are c_x, c_y and c_z, and another constraint may be called so.
void check_rows(Reading& reading) {
  std::map<std::string, const Constraint*> owners;
  for (const Constraint& row : reading.model.constraints) {
    check_label(row.name, reading);
    const auto [owner, is_first] = owners.emplace(row.name.text, &row);
    if (is_first) continue;
    const Constraint& other = *owner->second;
    const Name& direction = row.may_vanish ? row.name : other.name;
    const Name& whole = row.may_vanish ? other.name : row.name;
    reading.diagnostics.error(code::k_name_clash, whole.span,
                              fmt::format("'{}' already names a direction of the constraint in {}", row.name.text,
                                          reading.line_text(direction.span)),
                              "both would label a reaction; rename one of them");
  }
}

}  // namespace

SlipLaw read_contact_of(const Node& map, support::Span owner, const Entry& law, const std::string& where,
                        Reading& reading) {
  SlipLaw contact;
  contact.direction = {number(0), number(0), number(0)};
  contact.frame = unsure_place_at(law.value, law.key.span, "the body", reading);
  if (const Node* on = spec::find(map, "on")) contact.surface = unsure_place_at(*on, owner, "'on'", reading);
  const Node* at = required(map, "at", owner, where, reading);
  if (at == nullptr || at->kind == spec::NodeKind::scalar) {
    contact.at = at == nullptr ? k_space : unsure_place_at(*at, owner, "'at'", reading);
  } else {
    contact.at = read_vector(*at, owner, "'at'", reading);
  }
  return contact;
}

void read_constraints(const Node& root, Reading& reading) {
  read_section(root, "constraints", reading, [&](const Entry& entry) { ConstraintReader(entry, reading).run(); });
  check_rows(reading);
}

void read_elimination(const Node& root, Reading& reading) {
  const Node* elimination = spec::find(root, "elimination");
  if (elimination == nullptr || !expect_map(*elimination, elimination->span, "'elimination'", reading)) return;
  check_keys(*elimination, "'elimination'", format::keys_of(format::elimination()), reading);
  const Node* dependent = required(*elimination, "dependent", elimination->span, "'elimination'", reading);
  if (dependent == nullptr || !expect_list(*dependent, elimination->span, "'dependent'", reading)) return;
  for (const Node& item : dependent->items) {
    if (expect_scalar(item, dependent->span, "a dependent speed", reading))
      reading.model.dependent.push_back(name_of(item.scalar));
  }
}

}  // namespace gaussgen::model
