// bodies, and particles as bodies without inertia and orientation; in the order of the file.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/inertia.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

const std::vector<std::string> k_body_keys = {"mass", "inertia", "position", "orientation", "about"};
const std::vector<std::string> k_particle_keys = {"mass", "position", "about"};

bool is_euler_sequence(const std::string& text) {
  if (text.size() != 3 || text.find_first_not_of("xyz") != std::string::npos) return false;
  return text[0] != text[1] && text[1] != text[2];
}

EulerAngles read_euler(const Node& map, support::Span owner, Reading& reading) {
  const std::string where = "an orientation by Euler angles";
  EulerAngles euler;
  euler.angles.fill(broken_expression());
  check_keys(map, where, {"euler", "angles"}, reading);
  const Node* sequence = required(map, "euler", owner, where, reading);
  if (sequence != nullptr && expect_scalar(*sequence, owner, "'euler'", reading)) {
    euler.sequence = sequence->scalar.text;
    if (!is_euler_sequence(euler.sequence)) {
      reading.diagnostics.error(
          code::k_unknown_word, sequence->span, fmt::format("'{}' is not a sequence of axes", euler.sequence),
          "three letters of x, y, z without equal neighbours, such as zxz or zyx; an angle that is not "
          "needed is 0");
    }
  }
  const Node* angles = required(map, "angles", owner, where, reading);
  // As many angles as letters: that is one mistake.
  const bool is_reported = angles != nullptr && !euler.sequence.empty() && !is_euler_sequence(euler.sequence) &&
                           angles->items.size() == euler.sequence.size();
  if (angles != nullptr && !is_reported) euler.angles = read_vector(*angles, owner, "'angles'", reading);
  return euler;
}

QuaternionOrientation find_orientation(const Node& scalar, Reading& reading) {
  const auto found = reading.orientations.find(scalar.scalar.text);
  if (found != reading.orientations.end()) return {found->second};
  if (!reading.incomplete) {
    std::vector<std::string> names;
    for (const auto& orientation : reading.orientations) names.push_back(orientation.first);
    const std::string near = support::did_you_mean(scalar.scalar.text, names);
    reading.diagnostics.error(
        code::k_wrong_reference, scalar.span, fmt::format("there is no orientation '{}'", scalar.scalar.text),
        near.empty() ? "declare it under 'orientations', or write {euler: zxz, angles: [...]}" : near);
  }
  return {k_no_orientation};
}

void read_orientation(const Entry& entry, Body& body, Reading& reading) {
  if (entry.value.kind == NodeKind::map) {
    body.orientation = read_euler(entry.value, entry.key.span, reading);
  } else if (expect_scalar(entry.value, entry.key.span, "'orientation'", reading)) {
    body.orientation = find_orientation(entry.value, reading);
  } else {
    body.orientation = QuaternionOrientation{k_no_orientation};
  }
}

/// Inertia acts through rotation and rotation counts through inertia: one without the other is a slip.
void check_attitude(const Entry& entry, Reading& reading) {
  const Node* inertia = spec::find(entry.value, "inertia");
  const Node* orientation = spec::find(entry.value, "orientation");
  if ((inertia == nullptr) == (orientation == nullptr)) return;
  const bool turning = orientation != nullptr;
  reading.diagnostics.error(code::k_inertia_without_attitude, entry.key.span,
                            fmt::format("body '{}' has {}", entry.key.text,
                                        turning ? "an orientation but no inertia" : "inertia but no orientation"),
                            turning ? "add 'inertia', or list it under 'particles' without an orientation"
                                    : "add 'orientation', or list it under 'particles' without inertia");
}

void read_common(const Entry& entry, const std::string& where, Body& body, Reading& reading) {
  const Node* mass = required(entry.value, "mass", entry.key.span, where, reading);
  if (mass != nullptr) body.mass = read_expression(*mass, entry.key.span, reading);
  const Node* position = required(entry.value, "position", entry.key.span, where, reading);
  if (position != nullptr) body.position = read_vector(*position, entry.key.span, "'position'", reading);
  body.about = text_field(entry.value, "about", reading);
}

void read_rotation(const Entry& entry, Body& body, Reading& reading) {
  for (const Entry& field : entry.value.entries) {
    if (field.key.text == "inertia") body.inertia = read_inertia(field, reading);
    if (field.key.text == "orientation") read_orientation(field, body, reading);
  }
  check_attitude(entry, reading);
}

void check_unique(const Name& name, Reading& reading) {
  const auto [place, is_new] = reading.bodies.emplace(name.text, name.span);
  if (is_new) return;
  reading.diagnostics.error(
      code::k_name_clash, name.span,
      fmt::format("'{}' already names the body in line {}", name.text, reading.line(place->second)),
      "bodies and particles share their names; rename one");
}

void read_body(const Entry& entry, bool is_particle, Reading& reading) {
  const std::string what = is_particle ? "particle" : "body";
  const std::string where = fmt::format("{} '{}'", what, entry.key.text);
  Body body;
  body.name = name_of(entry.key);
  body.mass = broken_expression();
  body.position.fill(broken_expression());
  check_name(body.name, reading);
  check_unique(body.name, reading);
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, is_particle ? k_particle_keys : k_body_keys, reading);
    read_common(entry, where, body, reading);
    if (!is_particle) read_rotation(entry, body, reading);
  }
  reading.model.bodies.push_back(std::move(body));
}

}  // namespace

void read_bodies(const Node& root, Reading& reading) {
  for (const Entry& section : root.entries) {
    const bool is_particles = section.key.text == "particles";
    if (!is_particles && section.key.text != "bodies") continue;
    read_section(root, section.key.text, reading, [&](const Entry& entry) { read_body(entry, is_particles, reading); });
  }
}

}  // namespace gaussgen::model
