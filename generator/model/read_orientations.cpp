// orientations: unit quaternions with their angular velocities.

#include <fmt/format.h>

#include <algorithm>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/orientation_fields.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;
using support::Span;

namespace {

/// In the file of the orientation.
void note_unread_everything(const Entry& owner, Reading& reading) {
  reading.unread.add_everything(reading.copies.prefix_of(owner.key.text, owner.key.span.begin, reading.source));
}

/// A list that is too short, or that is not there, lacks names of which nothing is known.
void note_unread(const Entry& owner, std::size_t size, const std::string& key, std::size_t wanted, Reading& reading) {
  if (size < wanted && !has_misspelt(owner.value, key, reading)) return note_unread_everything(owner, reading);
  reading.unread.add(owner);
}

/// Reads a list of names into `names` and declares them.
template <std::size_t N>
void read_names(const Entry& owner, const std::string& key, std::array<Name, N>& names, SymbolKind kind,
                const std::string& what, Reading& reading) {
  const std::string where = fmt::format("'{}' of orientation '{}'", key, owner.key.text);
  const Node* list =
      required(owner.value, key, owner.key.span, fmt::format("orientation '{}'", owner.key.text), reading);
  const bool usable = list != nullptr && expect_list(*list, owner.key.span, where, reading) &&
                      expect_length(*list, N, where, reading, fmt::format("write {} names", N));
  if (!usable) return note_unread(owner, list == nullptr ? 0 : list->items.size(), key, N, reading);
  const std::size_t first = N * reading.model.orientations.size();
  for (std::size_t i = 0; i < N; ++i) {
    if (!expect_scalar(list->items[i], list->span, "a component", reading)) {
      reading.unread.add(list->items[i]);
      continue;
    }
    names[i] = name_of(list->items[i].scalar);
    declare(names[i], kind, first + i, what, reading);
  }
}

Axes read_axes(const Node& map, Reading& reading) {
  const Node* node = spec::find(map, "frame");
  if (node == nullptr || !expect_scalar(*node, map.span, "'frame'", reading)) return Axes::body;
  const std::string& word = node->scalar.text;
  if (word != "space" && word != "body") {
    const std::string near = support::did_you_mean(word, {"space", "body"});
    reading.diagnostics.error(code::k_unknown_word, node->span, fmt::format("there is no frame '{}'", word),
                              near.empty() ? "the frame is 'space' or 'body'" : near);
  }
  return word == "space" ? Axes::space : Axes::body;
}

void read_initial(const Node& map, Orientation& orientation, Reading& reading) {
  const Node* list = spec::find(map, "initial");
  orientation.is_open = list == nullptr;
  if (list == nullptr) return;
  const std::string where = "the initial quaternion";
  if (!expect_list(*list, map.span, where, reading) || !expect_length(*list, 4, where, reading)) return;
  for (std::size_t i = 0; i < 4; ++i) orientation.initial[i] = read_expression(list->items[i], list->span, reading);
}

void read_velocity_by_name(const Node& map, Orientation& orientation, Reading& reading) {
  std::vector<std::string> names;
  for (const Name& name : orientation.angular_velocity) names.push_back(name.text);
  // Of a component that could not be read the name is open.
  const bool are_known = std::find(names.begin(), names.end(), "") == names.end();
  if (are_known) check_keys(map, "'initial_angular_velocity'", names, reading);
  for (std::size_t i = 0; i < names.size(); ++i)
    orientation.initial_angular_velocity[i] = expression_field(map, names[i], reading);
}

void read_initial_velocity(const Node& map, Orientation& orientation, Reading& reading) {
  const Node* node = spec::find(map, "initial_angular_velocity");
  if (node == nullptr) return;
  if (node->kind == NodeKind::map) return read_velocity_by_name(*node, orientation, reading);
  const std::array<Ast, 3> values = read_vector(*node, map.span, "'initial_angular_velocity'", reading);
  for (std::size_t i = 0; i < values.size(); ++i) orientation.initial_angular_velocity[i] = values[i];
}

void read_orientation(const Entry& entry, Reading& reading) {
  Orientation orientation;
  orientation.name = name_of(entry.key);
  orientation.initial = {number(1), number(0), number(0), number(0)};
  check_name(orientation.name, reading);
  reading.orientations.emplace(entry.key.text, reading.model.orientations.size());
  if (expect_map(entry.value, entry.key.span, fmt::format("orientation '{}'", entry.key.text), reading)) {
    check_keys(entry.value, fmt::format("orientation '{}'", entry.key.text), format::keys_of(format::orientation()),
               reading);
    read_names(entry, "quaternion", orientation.quaternion, SymbolKind::quaternion_component,
               "the quaternion component", reading);
    read_names(entry, "angular_velocity", orientation.angular_velocity, SymbolKind::angular_velocity,
               "the angular velocity", reading);
    orientation.about = text_field(entry.value, "about", reading);
    orientation.axes = read_axes(entry.value, reading);
    read_initial(entry.value, orientation, reading);
    read_initial_velocity(entry.value, orientation, reading);
  } else {
    note_unread_everything(entry, reading);
  }
  reading.model.orientations.push_back(std::move(orientation));
}

template <std::size_t N>
void declare_components(const std::array<const char*, N>& suffixes, const Name& owner, std::array<Name, N>& names,
                        SymbolKind kind, const std::string& what, Reading& reading) {
  const std::size_t first = N * reading.model.orientations.size();
  for (std::size_t i = 0; i < N; ++i) {
    names[i] = {owner.text + suffixes[i], owner.span};
    declare(names[i], kind, first + i, what, reading);
  }
}

}  // namespace

std::size_t add_orientation(const Name& owner, const Node& map, Reading& reading) {
  Orientation orientation;
  orientation.name = owner;
  orientation.axes = Axes::body;
  orientation.about = "of joint " + owner.text;
  orientation.is_open = true;
  orientation.initial = {number(1), number(0), number(0), number(0)};
  declare_components<4>({"_e0", "_e1", "_e2", "_e3"}, owner, orientation.quaternion, SymbolKind::quaternion_component,
                        "the quaternion component", reading);
  declare_components<3>({"_wx", "_wy", "_wz"}, owner, orientation.angular_velocity, SymbolKind::angular_velocity,
                        "the angular velocity", reading);
  read_initial_velocity(map, orientation, reading);
  const std::size_t index = reading.model.orientations.size();
  reading.orientations.emplace(owner.text, index);
  reading.model.orientations.push_back(std::move(orientation));
  return index;
}

void read_orientations(const Node& root, Reading& reading) {
  read_section(root, "orientations", reading, [&](const Entry& entry) { read_orientation(entry, reading); });
}

}  // namespace gaussgen::model
