#include "scene_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "spec/reader.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

namespace code = support::code;

class Reader {
 public:
  Reader(const support::Source& source, const spec::Node& root, support::Diagnostics& diagnostics)
      : source_(source), root_(root), diagnostics_(diagnostics) {}

  SceneChoice read() {
    const std::filesystem::path file(source_.name());
    SceneChoice choice;
    choice.name = name_of_code(text_of("scene").value_or(file.stem().string()));
    if (const auto model = text_of("model")) {
      choice.model = beside(source_.name(), *model);
    } else {
      diagnostics_.error(code::k_missing_key, root_.span, "a scene names its model", "write 'model: ball.yaml'");
    }
    read_counts(choice);
    read_effects(choice);
    for (const char* const section : {"parameters", "initial", "inputs"}) read_values(section, choice);
    return choice;
  }

 private:
  std::optional<std::string> text_of(const char* key) const {
    const spec::Node* const node = spec::find(root_, key);
    if (node == nullptr || node->kind != spec::NodeKind::scalar) return std::nullopt;
    return node->scalar.text;
  }

  static std::string name_of_code(std::string text) {
    for (char& c : text) {
      const bool is_letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
      if (!is_letter && !('0' <= c && c <= '9')) c = '_';
    }
    const bool begins_well = !text.empty() && text.front() != '_' && !('0' <= text.front() && text.front() <= '9');
    return begins_well ? text : "scene_" + text;
  }

  void read_counts(SceneChoice& choice) {
    const spec::Node* const node = spec::find(root_, "counts");
    if (node == nullptr) return;
    for (const spec::Entry& entry : node->entries) {
      const std::string& text = entry.value.scalar.text;
      std::int64_t count = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
      if (error == std::errc() && end == text.data() + text.size())
        choice.counts[entry.key.text] = count;
      else
        diagnostics_.error(code::k_wrong_count, entry.value.span, fmt::format("'{}' is no whole number", text));
    }
  }

  void read_effects(SceneChoice& choice) const {
    const spec::Node* const node = spec::find(root_, "effects");
    if (node == nullptr) return;
    const auto take = [&](const spec::Node& word) {
      choice.effects.push_back(word.scalar.text);
      choice.places.push_back(word.span);
    };
    if (node->kind == spec::NodeKind::scalar) take(*node);
    for (const spec::Node& word : node->items) take(word);
  }

  void read_values(const char* section, SceneChoice& choice) const {
    const spec::Node* const node = spec::find(root_, section);
    if (node == nullptr) return;
    for (const spec::Entry& entry : node->entries) choice.values.emplace_back(entry.key.text, entry.value.scalar.text);
  }

  const support::Source& source_;
  const spec::Node& root_;
  support::Diagnostics& diagnostics_;
};

}  // namespace

std::string beside(const std::string& file, const std::string& named) {
  const std::filesystem::path path(named);
  return path.is_absolute() ? named : (std::filesystem::path(file).parent_path() / path).string();
}

bool is_scene(const support::Source& source) {
  support::Diagnostics ignored;
  const auto root = spec::read_yaml(source, ignored);
  return root && root->kind == spec::NodeKind::map &&
         (spec::find(*root, "model") != nullptr || spec::find(*root, "scene") != nullptr);
}

std::optional<SceneChoice> read_scene_choice(const support::Source& scene, support::Diagnostics& diagnostics) {
  const auto root = spec::read_yaml(scene, diagnostics);
  if (!root || diagnostics.has_errors()) return std::nullopt;
  SceneChoice choice = Reader(scene, *root, diagnostics).read();
  if (diagnostics.has_errors()) return std::nullopt;
  return choice;
}

}  // namespace gaussgen
