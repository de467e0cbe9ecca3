#include "scene_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "model/fields.hpp"
#include "model/names.hpp"
#include "spec/reader.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

const std::vector<std::string>& keys_of_scenes() {
  static const std::vector<std::string> k_keys{
      "gauss",        "scene",    "about",      "model",        "counts",  "parameters", "initial",   "inputs",
      "start",        "duration", "every",      "samples",      "outputs", "method",     "tolerance", "error",
      "step",         "number",   "projection", "strategy",     "engine",  "code",       "gain",      "formulation",
      "formulations", "exact",    "ensemble",   "longest_step", "effects", "instances"};
  return k_keys;
}

const std::vector<std::string>& keys_of_instances() {
  static const std::vector<std::string> k_keys{"about",   "effects", "parameters", "initial", "inputs",      "exact",
                                               "outputs", "method",  "tolerance",  "step",    "longest_step"};
  return k_keys;
}

namespace {

namespace code = support::code;

class Reader {
 public:
  Reader(const support::Source& source, const spec::Node& root, support::Diagnostics& diagnostics)
      : source_(source), root_(root), diagnostics_(diagnostics), reading_{source, diagnostics, {}} {}

  SceneChoice read() {
    const std::filesystem::path file(source_.name());
    SceneChoice choice;
    model::check_keys(root_, "the scene", keys_of_scenes(), reading_);
    choice.name = name_of_code(text_of("scene").value_or(file.stem().string()));
    if (const auto model = text_of("model")) {
      choice.model = beside(source_.name(), *model);
    } else {
      diagnostics_.error(code::k_missing_key, root_.span, "a scene names its model", "write 'model: ball.yaml'");
    }
    read_counts(choice);
    read_effects(root_, choice.effects);
    read_values(root_, choice.values);
    read_instances(choice);
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

  static void read_effects(const spec::Node& map, std::vector<PlacedWord>& to) {
    const spec::Node* const node = spec::find(map, "effects");
    if (node == nullptr) return;
    if (node->kind == spec::NodeKind::scalar) to.push_back({node->scalar.text, node->span});
    for (const spec::Node& word : node->items) to.push_back({word.scalar.text, word.span});
  }

  static void read_values(const spec::Node& map, std::vector<SceneValue>& to) {
    for (const char* const section : {"parameters", "initial", "inputs"}) {
      const spec::Node* const node = spec::find(map, section);
      if (node == nullptr) continue;
      for (const spec::Entry& entry : node->entries)
        to.push_back({entry.key.text, entry.value.scalar.text, entry.key.span, std::string(section) == "initial"});
    }
  }

  void read_instances(SceneChoice& choice) {
    for (const spec::Entry& section : root_.entries) {
      if (section.key.text != "instances") continue;
      choice.instances_place = section.key.span;
      if (!model::expect_map(section.value, section.key.span, "'instances'", reading_)) return;
      if (section.value.entries.empty())
        diagnostics_.error(code::k_wrong_count, section.value.span, "there is no instance",
                           "name some, such as {near: {effects: [+air]}, far: {}}, or leave 'instances' out");
      for (const spec::Entry& entry : section.value.entries) read_instance(entry, choice);
    }
  }

  void read_instance(const spec::Entry& entry, SceneChoice& choice) {
    InstanceOfScene one{entry.key.text, entry.key.span, {}, {}};
    if (model::check_name(model::name_of(entry.key), reading_) && one.name == "variants")
      diagnostics_.error(code::k_reserved_name, one.span, "the table of all of them is called 'variants'",
                         "choose another name");
    const bool is_plain = entry.value.kind == spec::NodeKind::empty;
    if (!is_plain && model::expect_map(entry.value, entry.key.span, fmt::format("instance '{}'", one.name), reading_)) {
      model::check_keys(entry.value, fmt::format("instance '{}'", one.name), keys_of_instances(), reading_);
      read_effects(entry.value, one.effects);
      read_values(entry.value, one.values);
    }
    choice.instances.push_back(std::move(one));
  }

  const support::Source& source_;
  const spec::Node& root_;
  support::Diagnostics& diagnostics_;
  model::Reading reading_;
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

const InstanceOfScene* find_instance(const SceneChoice& scene, const std::string& name) {
  const auto& all = scene.instances;
  const auto found = std::find_if(all.begin(), all.end(), [&](const InstanceOfScene& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

SceneChoice as_instance(const SceneChoice& scene, const InstanceOfScene& one) {
  SceneChoice result = scene;
  result.name += "_" + one.name;
  result.effects = choice_of_instance(scene.effects, one.effects);
  auto& values = result.values;
  const auto is_said_anew = [&](const SceneValue& value) {
    return std::any_of(one.values.begin(), one.values.end(),
                       [&](const SceneValue& own) { return own.name == value.name; });
  };
  values.erase(std::remove_if(values.begin(), values.end(), is_said_anew), values.end());
  values.insert(values.end(), one.values.begin(), one.values.end());
  result.instances.clear();
  return result;
}

std::optional<SceneChoice> read_scene_choice(const support::Source& scene, support::Diagnostics& diagnostics) {
  const auto root = spec::read_yaml(scene, diagnostics);
  if (!root || diagnostics.has_errors()) return std::nullopt;
  SceneChoice choice = Reader(scene, *root, diagnostics).read();
  if (diagnostics.has_errors()) return std::nullopt;
  return choice;
}

}  // namespace gaussgen
