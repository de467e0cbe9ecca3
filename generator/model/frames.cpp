#include "model/frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/fields.hpp"
#include "model/names.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

constexpr const char* k_space_name = "space";
constexpr const char* k_body = "the body";
constexpr std::size_t k_unplaced = static_cast<std::size_t>(-2);

void refuse_second(const Name& name, const std::string& what, Reading& reading) {
  const auto other = reading.frames.find(name.text);
  if (other == reading.frames.end() && name.text != k_space_name) return;
  const std::string owner =
      other == reading.frames.end()
          ? "space itself"
          : fmt::format("the place in {}", reading.line_text(reading.model.frames[other->second].name.span));
  // What is on the second one is not seen, since the name finds the first.
  reading.has_unknown_carrier = true;
  reading.diagnostics.error(code::k_name_clash, name.span, fmt::format("'{}' already names {}", name.text, owner),
                            what == k_child
                                ? "a frame is the child of one joint; a loop is closed by a constraint"
                                : fmt::format("frames, points and bodies share their names; rename {}", what));
}

class FrameOrder {
 public:
  explicit FrameOrder(Reading& reading)
      : reading_(reading), model_(reading.model), position_(model_.frames.size(), k_unplaced) {}

  void run() {
    for (const std::optional<Name>& parent : reading_.parents) find(parent);
    for (const std::size_t i : reading_.second) {
      if (is_known_[i]) refuse_second(model_.frames[i].name, k_body, reading_);
    }
    for (std::size_t i = 0; i < parent_.size(); ++i) place(i);
    std::vector<Frame> sorted;
    for (const std::size_t i : order_) {
      sorted.push_back(std::move(model_.frames[i]));
      sorted.back().parent = parent_[i] == k_space ? k_space : position_[parent_[i]];
    }
    model_.frames = std::move(sorted);
    for (Body& body : model_.bodies) body.frame = position_[body.frame];
    for (Joint& joint : model_.joints) joint.frame = position_[joint.frame];
    for (auto& entry : reading_.frames) entry.second = position_[entry.second];
  }

 private:
  void find(const std::optional<Name>& parent) {
    const auto found = parent ? find_frame(*parent, reading_) : k_space;
    if (!found) reading_.has_unknown_carrier = true;
    is_known_.push_back(found.has_value());
    parent_.push_back(found.value_or(k_space));
  }

  /// The frame after all that carry it: from it towards space, then back.
  void place(std::size_t frame) {
    std::vector<std::size_t> path;
    for (std::size_t at = frame; at != k_space && position_[at] == k_unplaced; at = parent_[at]) {
      const auto before = std::find(path.begin(), path.end(), at);
      if (before != path.end()) {
        report_cycle({before, path.end()});
        parent_[path.back()] = k_space;
        break;
      }
      path.push_back(at);
    }
    for (auto at = path.rbegin(); at != path.rend(); ++at) {
      position_[*at] = order_.size();
      order_.push_back(*at);
    }
  }

  void report_cycle(const std::vector<std::size_t>& cycle) {
    std::string path;
    for (const std::size_t i : cycle) path += model_.frames[i].name.text + " -> ";
    path += model_.frames[cycle.front()].name.text;
    reading_.diagnostics.error(code::k_cyclic_frames, reading_.parents[cycle.front()]->span,
                               cycle.size() == 1 ? "this is placed against itself"
                                                 : "these carry each other, and nothing places them in space: " + path,
                               "one of them needs the parent 'space'; a loop is closed by a constraint");
  }

  Reading& reading_;
  Model& model_;
  std::vector<std::size_t> parent_;
  std::vector<bool> is_known_;         ///< the parent
  std::vector<std::size_t> position_;  ///< in the sorted list
  std::vector<std::size_t> order_;
};

/// Empty when no joint has the name.
std::string hint_for_joint(const std::string& name, const Reading& reading) {
  for (const Joint& joint : reading.model.joints) {
    if (joint.name.text == name && joint.frame != k_space)
      return fmt::format("'{}' is a joint; the frame that it carries is '{}'", name,
                         reading.model.frames[joint.frame].name.text);
  }
  return "";
}

std::vector<std::string> places_of(const Reading& reading) {
  std::vector<std::string> names = names_of(reading.frames);
  names.emplace_back(k_space_name);
  return names;
}

std::string without_digits(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), support::is_digit), text.end());
  return text;
}

/// link_$(i-1) in the first copy; `near` would be another copy of what is meant, or the copy itself.
std::string hint_for_index(const Name& unknown, const std::string& near, const Reading& reading) {
  const std::string written(reading.source.text(unknown.span));
  const bool is_copy = written.find('$') != std::string::npos &&
                       without_digits(near).find("'" + without_digits(unknown.text) + "'") != std::string::npos;
  if (!is_copy) return near;
  return fmt::format("'{}' is '{}' in one of the copies, which count from 1: write the first or the last one by itself",
                     written, unknown.text);
}

std::string hint_for_unknown(const Name& unknown, Reading& reading) {
  const std::string& name = unknown.text;
  const std::string of_joint = reading.searches.are_spent() ? "" : hint_for_joint(name, reading);
  if (!of_joint.empty()) return of_joint;
  const auto symbol = reading.model.symbols.find(name);
  if (symbol != reading.model.symbols.end() && symbol->second.kind == SymbolKind::coordinate)
    return fmt::format("'{}' is a coordinate, not a place; a force along it is 'generalized: {{{}: F}}'", name, name);
  const std::size_t sign = name.find_first_of("+-");
  if (sign != std::string::npos)
    return "a name has no signs; with an index, arithmetic stands in brackets, as in link_$(i-1)";
  const std::string near = did_you_mean_one_of(
      unknown, [&] { return places_of(reading); }, reading);
  return near.empty() ? "declare it under 'frames', 'joints', 'bodies' or 'points'"
                      : hint_for_index(unknown, near, reading);
}

std::size_t add_checked_frame(Frame frame, std::optional<Name> parent, Reading& reading) {
  const std::size_t index = reading.model.frames.size();
  reading.frames.emplace(frame.name.text, index);
  reading.model.frames.push_back(std::move(frame));
  reading.parents.push_back(std::move(parent));
  return index;
}

}  // namespace

std::size_t add_frame(Frame frame, std::optional<Name> parent, const std::string& what, Reading& reading) {
  if (check_name(frame.name, reading)) refuse_second(frame.name, what, reading);
  return add_checked_frame(std::move(frame), std::move(parent), reading);
}

std::size_t add_body_frame(Frame frame, std::optional<Name> parent, Reading& reading) {
  const auto other = reading.frames.find(frame.name.text);
  const auto body = reading.bodies.find(frame.name.text);
  // Two bodies of one name are reported where bodies are read.
  const bool is_body = other != reading.frames.end() && body != reading.bodies.end() &&
                       reading.model.frames[other->second].name.span == body->second;
  // With a slip in 'frame', the body may be meant to be on the frame of its name: that is known when places are.
  const bool is_second = !is_body && parent && other != reading.frames.end();
  if (is_second) reading.second.push_back(reading.model.frames.size());
  if (!is_second && !is_body) refuse_second(frame.name, k_body, reading);
  return add_checked_frame(std::move(frame), std::move(parent), reading);
}

std::optional<Name> parent_field(const spec::Node& map, const std::string& key, Reading& reading) {
  const spec::Node* node = spec::find(map, key);
  if (node == nullptr) return std::nullopt;
  if (!expect_scalar(*node, map.span, "'" + key + "'", reading)) {
    reading.has_unknown_carrier = true;
    return std::nullopt;
  }
  if (node->scalar.text == k_space_name) return std::nullopt;
  return name_of(node->scalar);
}

std::array<Ast, 3> vector_field(const spec::Node& map, const std::string& key, Reading& reading) {
  for (const spec::Entry& entry : map.entries) {
    if (entry.key.text == key) return read_vector(entry.value, entry.key.span, "'" + key + "'", reading);
  }
  return {number(0), number(0), number(0)};
}

std::optional<std::size_t> find_frame(const Name& name, Reading& reading) {
  if (name.text == k_space_name) return k_space;
  const auto found = reading.frames.find(name.text);
  if (found != reading.frames.end()) return found->second;
  if (!reading.unread.may_declare_frame(name.text)) {
    reading.diagnostics.error(code::k_wrong_reference, name.span,
                              fmt::format("there is no frame, body or point '{}'", name.text),
                              hint_for_unknown(name, reading));
  }
  return std::nullopt;
}

std::optional<std::size_t> find_frame_at(const spec::Node& node, support::Span owner, const std::string& what,
                                         Reading& reading) {
  if (!expect_scalar(node, owner, what, reading)) return std::nullopt;
  return find_frame(name_of(node.scalar), reading);
}

std::size_t frame_at(const spec::Node& node, support::Span owner, const std::string& what, Reading& reading) {
  return find_frame_at(node, owner, what, reading).value_or(k_space);
}

void order_frames(Reading& reading) {
  FrameOrder(reading).run();
  for (const auto& [name, index] : reading.frames) {
    for (std::size_t i = 0; i < 3; ++i) {
      reading.model.symbols[name + "." + "xyz"[i]] = {SymbolKind::place, 3 * index + i};
      reading.model.symbols[name + ".w" + "xyz"[i]] = {SymbolKind::spin, 3 * index + i};
    }
  }
}

}  // namespace gaussgen::model
