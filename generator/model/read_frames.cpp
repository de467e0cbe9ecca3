// frames: axes placed against others; points: places on them.

#include <fmt/format.h>

#include "model/attitude.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/frames.hpp"
#include "model/sections.hpp"

namespace gaussgen::model {

using spec::Entry;
using spec::Node;

namespace {

Frame begin_frame(const Entry& entry) {
  Frame frame;
  frame.name = name_of(entry.key);
  frame.position = {number(0), number(0), number(0)};
  return frame;
}

void read_frame(const Entry& entry, Reading& reading) {
  const std::string where = fmt::format("frame '{}'", entry.key.text);
  Frame frame = begin_frame(entry);
  std::optional<Name> parent;
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, format::keys_of(format::frame()), reading);
    parent = parent_field(entry.value, "parent", reading);
    frame.position = vector_field(entry.value, "position", reading);
    frame.about = text_field(entry.value, "about", reading);
    for (const Entry& field : entry.value.entries) {
      if (field.key.text == "orientation") frame.attitude = read_attitude(field, reading);
    }
  } else {
    frame.position.fill(broken_expression());  // nothing is known of what moves it
  }
  add_frame(std::move(frame), std::move(parent), "the frame", reading);
}

void read_point(const Entry& entry, Reading& reading) {
  const std::string where = fmt::format("point '{}'", entry.key.text);
  Frame frame = begin_frame(entry);
  frame.is_point = true;
  std::optional<Name> parent;
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, format::keys_of(format::point()), reading);
    parent = parent_field(entry.value, "on", reading);
    const Node* at = required(entry.value, "at", entry.key.span, where, reading);
    if (at != nullptr) frame.position = read_vector(*at, entry.key.span, "'at'", reading);
    frame.about = text_field(entry.value, "about", reading);
  } else {
    frame.position.fill(broken_expression());
  }
  add_frame(std::move(frame), std::move(parent), "the point", reading);
}

}  // namespace

void read_frames(const Node& root, Reading& reading) {
  read_section(root, "frames", reading, [&](const Entry& entry) { read_frame(entry, reading); });
  read_section(root, "points", reading, [&](const Entry& entry) { read_point(entry, reading); });
}

}  // namespace gaussgen::model
