// bodies, and particles as bodies without inertia and orientation; in the order of the file.

#include <fmt/format.h>

#include "model/attitude.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/frames.hpp"
#include "model/inertia.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

/// Inertia acts through rotation and rotation counts through inertia: one without the other is a slip.
void check_attitude(const Entry& entry, Reading& reading) {
  const Node* inertia = spec::find(entry.value, "inertia");
  const Node* orientation = spec::find(entry.value, "orientation");
  if ((inertia == nullptr) == (orientation == nullptr)) return;
  if (has_misspelt(entry.value, inertia == nullptr ? "inertia" : "orientation", reading)) return;
  const bool turning = orientation != nullptr;
  reading.diagnostics.error(code::k_inertia_without_attitude, entry.key.span,
                            fmt::format("body '{}' has {}", entry.key.text,
                                        turning ? "an orientation but no inertia" : "inertia but no orientation"),
                            turning ? "add 'inertia', or list it under 'particles' without an orientation"
                                    : "add 'orientation', or list it under 'particles' without inertia");
}

/// A body with a position of its own is a frame: origin in the mass centre, placed in space.
void place_in_space(const Entry& entry, const Node& position, Body& body, Reading& reading) {
  Frame frame;
  frame.name = body.name;
  frame.about = body.about;
  frame.position = read_vector(position, entry.key.span, "'position'", reading);
  for (const Entry& field : entry.value.entries) {
    if (field.key.text == "orientation") frame.attitude = read_attitude(field, reading);
    if (field.key.text != "frame" && field.key.text != "centre") continue;
    reading.diagnostics.error(code::k_conflicting_keys, field.key.span,
                              fmt::format("'{}' has '{}' beside 'position'", body.name.text, field.key.text),
                              "'position' is in space; on a frame, write 'frame' and 'centre'");
  }
  body.frame = add_body_frame(std::move(frame), std::nullopt, reading);
}

std::vector<std::string> frames_without_body(const Reading& reading) {
  std::vector<std::string> names;
  for (const auto& [name, index] : reading.frames) {
    if (reading.bodies.count(name) == 0) names.push_back(name);
  }
  return names;
}

/// Part of a frame: of the one that has its name, or of another one, and then a frame itself.
void place_on_frame(const Entry& entry, const std::string& where, Body& body, Reading& reading) {
  const auto own = reading.frames.find(body.name.text);
  const Node* named = spec::find(entry.value, "frame");
  const std::array<Ast, 3> centre = vector_field(entry.value, "centre", reading);
  if (spec::find(entry.value, "orientation") != nullptr && !has_misspelt(entry.value, "position", reading)) {
    reading.diagnostics.error(code::k_conflicting_keys, spec::find(entry.value, "orientation")->span,
                              fmt::format("{} takes its orientation from its frame", where),
                              "remove it, or place the body in space by 'position'");
  }
  const bool is_own = own != reading.frames.end() && (named == nullptr || named->scalar.text == body.name.text);
  if (is_own) {
    body.frame = own->second;
    body.centre = centre;
    return;
  }
  if (named == nullptr && !reading.unread.may_declare_frame(body.name.text)) {
    const std::string near = did_you_mean_one_of(
        body.name, [&] { return frames_without_body(reading); }, reading);
    required(entry.value, "position", entry.key.span, where, reading,
             fmt::format("; or 'frame', as no frame and no child of a joint is called '{}'{}{}", body.name.text,
                         near.empty() ? "" : ": ", near));
  }
  Frame frame;
  frame.name = body.name;
  frame.about = body.about;
  frame.position = centre;
  if (named == nullptr) frame.position.fill(broken_expression());
  body.frame = add_body_frame(std::move(frame), parent_field(entry.value, "frame", reading), reading);
}

void read_common(const Entry& entry, const std::string& where, Body& body, Reading& reading) {
  const Node* mass = required(entry.value, "mass", entry.key.span, where, reading);
  if (mass != nullptr) body.mass = read_expression(*mass, entry.key.span, reading);
  body.about = text_field(entry.value, "about", reading);
  body.centre = {number(0), number(0), number(0)};
  if (const Node* position = spec::find(entry.value, "position")) {
    place_in_space(entry, *position, body, reading);
  } else {
    place_on_frame(entry, where, body, reading);
  }
}

void read_rotation(const Entry& entry, Body& body, Reading& reading) {
  for (const Entry& field : entry.value.entries) {
    if (field.key.text == "inertia") body.inertia = read_inertia(field, reading);
  }
  if (spec::find(entry.value, "position") != nullptr) check_attitude(entry, reading);
}

void check_unique(const Name& name, Reading& reading) {
  const auto [place, is_new] = reading.bodies.emplace(name.text, name.span);
  if (is_new) return;
  reading.diagnostics.error(
      code::k_name_clash, name.span,
      fmt::format("'{}' already names the body in {}", name.text, reading.line_text(place->second)),
      "bodies and particles share their names; rename one");
}

void read_body(const Entry& entry, bool is_particle, Reading& reading) {
  const std::string what = is_particle ? "particle" : "body";
  const std::string where = fmt::format("{} '{}'", what, entry.key.text);
  Body body;
  body.name = name_of(entry.key);
  body.mass = broken_expression();
  body.is_particle = is_particle;
  check_name(body.name, reading);
  check_unique(body.name, reading);
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, format::keys_of(is_particle ? format::particle() : format::body()), reading);
    read_common(entry, where, body, reading);
    if (!is_particle) read_rotation(entry, body, reading);
  } else if (const auto own = reading.frames.find(body.name.text); own != reading.frames.end()) {
    body.frame = own->second;
  } else {
    Frame frame;
    frame.name = body.name;
    frame.position.fill(broken_expression());
    body.frame = add_body_frame(std::move(frame), std::nullopt, reading);
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
