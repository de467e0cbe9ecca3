#include "sim/scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/fields.hpp"
#include "sim/scene/choices.hpp"
#include "sim/scene/read_ensemble.hpp"
#include "sim/scene/read_numbers.hpp"
#include "spec/reader.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
namespace spec = gaussgen::spec;
using gaussgen::support::Diagnostics;
using gaussgen::support::Source;
using gaussgen::support::Span;

const char* const k_where = "the scene";
constexpr long k_most_samples = 100'000'000;

const std::vector<std::string>& keys() {
  static const std::vector<std::string> k_keys{
      "gauss",     "scene", "about",       "model",        "counts",     "parameters", "initial",
      "inputs",    "start", "duration",    "every",        "samples",    "outputs",    "method",
      "tolerance", "error", "step",        "number",       "projection", "strategy",   "engine",
      "code",      "gain",  "formulation", "formulations", "exact",      "ensemble",   "longest_step", "effects"};
  return k_keys;
}

class SceneReader {
 public:
  SceneReader(const spec::Node& root, model::Reading& reading) : root_(root), reading_(reading) {}

  Scene read() {
    model::check_keys(root_, k_where, keys(), reading_);
    check_version();
    read_name();
    scene_.about = model::text_field(root_, "about", reading_);
    if (const spec::Node* const file = model::required(root_, "model", root_.span, k_where, reading_)) {
      if (model::expect_scalar(*file, root_.span, "'model'", reading_)) scene_.model = {file->scalar.text, file->span};
    }
    read_counts();
    read_effects();
    read_given(root_, "parameters", scene_.parameters);
    read_given(root_, "initial", scene_.initial);
    read_given(root_, "inputs", scene_.inputs);
    read_given(root_, "exact", scene_.exact);
    scene_.start = model::expression_field(root_, "start", reading_);
    scene_.duration = model::expression_field(root_, "duration", reading_);
    scene_.every = model::expression_field(root_, "every", reading_);
    read_samples();
    read_outputs();
    scene_.method = choice(root_, "method", method_names());
    scene_.number = choice(root_, "number", number_names());
    scene_.projection = choice(root_, "projection", projection_names());
    scene_.strategy = choice(root_, "strategy", strategy_names());
    scene_.code = choice(root_, "code", code_names());
    scene_.engine = choice(root_, "engine", engine_names());
    scene_.tolerance = positive("tolerance");
    read_error();
    scene_.step = positive("step");
    scene_.longest_step = positive("longest_step");
    scene_.gain = positive("gain");
    if (const spec::Node* const ensemble = spec::find(root_, "ensemble"))
      scene_.ensemble = read_ensemble(*ensemble, root_, reading_);
    refuse_pair("every", "samples");
    refuse_pair("tolerance", "error");
    refuse_pair("step", "error");
    read_forms();
    return std::move(scene_);
  }

 private:
  void error(const std::string& id, Span span, const std::string& message, const std::string& hint = "") {
    reading_.diagnostics.error(id, span, message, hint);
  }

  void check_version() {
    const spec::Node* const version = model::required(root_, "gauss", root_.span, k_where, reading_);
    if (version == nullptr || version->scalar.text == "1") return;
    error(code::k_format_version, version->span, "this program reads version 1 of the format", "write 'gauss: 1'");
  }

  /// It names files beside each other, so it must not lead elsewhere.
  void read_name() {
    const spec::Node* const node = spec::find(root_, "scene");
    if (node == nullptr || node->kind == spec::NodeKind::empty) return;
    if (!model::expect_scalar(*node, root_.span, "'scene'", reading_)) return;
    scene_.name = node->scalar.text;
    const std::string& name = scene_.name;
    const bool is_folder = name.empty() || name == "." || name == "..";
    const bool has_separator =
        std::any_of(name.begin(), name.end(), [](unsigned char c) { return c == '/' || c == '\\' || c < ' '; });
    if (is_folder || has_separator)
      error(code::k_invalid_name, node->span, fmt::format("'{}' cannot name files", name),
            "a name has no '/', no '\\' and no control characters, and is not '.' or '..'; -o says where a table is "
            "written");
  }

  void read_counts() {
    model::read_section(root_, "counts", reading_, [&](const spec::Entry& entry) {
      if (const auto number = numbers_.whole(entry.value, entry.key.span, 1, 1'000'000, 10))
        scene_.counts.push_back({{entry.key.text, entry.key.span}, *number});
    });
  }

  /// One word, or a list of them.
  void read_effects() {
    const spec::Node* const node = spec::find(root_, "effects");
    if (node == nullptr) return;
    if (node->kind == spec::NodeKind::scalar) return scene_.effects.push_back({node->scalar.text, node->span});
    if (!model::expect_list(*node, root_.span, "'effects'", reading_)) return;
    if (node->items.empty())
      error(code::k_wrong_count, node->span, "there is no effect in the list", "write 'effects: none' for none at all");
    for (const spec::Node& item : node->items) {
      if (model::expect_scalar(item, node->span, "an effect", reading_))
        scene_.effects.push_back({item.scalar.text, item.span});
    }
  }

  void read_forms() {
    if (const std::string own = model::text_field(root_, "formulation", reading_); !own.empty()) scene_.form = own;
    model::read_section(root_, "formulations", reading_, [&](const spec::Entry& entry) {
      GivenForm form;
      form.name = {entry.key.text, entry.key.span};
      if (form.name.text == scene_.form)
        error(code::k_conflicting_keys, form.name.span, fmt::format("'{}' is the scene itself", form.name.text),
              "'formulation' gives the scene's own description another name");
      if (!model::expect_map(entry.value, entry.key.span, "formulation '" + entry.key.text + "'", reading_)) return;
      model::check_keys(entry.value, "formulation '" + entry.key.text + "'",
                        {"model", "strategy", "parameters", "initial"}, reading_);
      if (const spec::Node* const file = spec::find(entry.value, "model");
          file != nullptr && model::expect_scalar(*file, entry.key.span, "'model'", reading_))
        form.model = Word{file->scalar.text, file->span};
      form.strategy = choice(entry.value, "strategy", strategy_names());
      read_given(entry.value, "parameters", form.parameters);
      read_given(entry.value, "initial", form.initial);
      scene_.forms.push_back(std::move(form));
    });
  }

  void read_given(const spec::Node& in, const std::string& section, std::vector<Given>& all) {
    model::read_section(in, section, reading_, [&](const spec::Entry& entry) {
      all.push_back({entry.key.text, model::read_expression(entry.value, entry.key.span, reading_), entry.key.span});
    });
  }

  void read_error() {
    scene_.error = positive("error");
    if (scene_.error && *scene_.error >= 1)
      error(code::k_out_of_range, scene_.places["error"],
            "an error of 1 is the whole range of an output: it is below 1", "such as error: 1e-6");
  }

  std::optional<double> positive(const std::string& key) {
    if (const spec::Node* const node = spec::find(root_, key)) scene_.places[key] = node->span;
    return numbers_.positive(root_, key);
  }

  void read_samples() {
    const spec::Node* const node = spec::find(root_, "samples");
    if (node == nullptr) return;
    if (const auto number = numbers_.whole(*node, node->span, 2, k_most_samples, 501)) scene_.samples = *number;
  }

  void read_outputs() {
    const spec::Node* const list = spec::find(root_, "outputs");
    if (list == nullptr || !model::expect_list(*list, root_.span, "'outputs'", reading_)) return;
    if (list->items.empty())
      error(code::k_wrong_count, list->span, "there is no output in the list",
            "name some, or leave 'outputs' out: the table has the state and the energy then");
    for (const spec::Node& item : list->items) {
      if (!model::expect_scalar(item, list->span, "an output", reading_)) continue;
      scene_.outputs.push_back({item.scalar.text, item.span});
    }
  }

  std::optional<Word> choice(const spec::Node& in, const std::string& key, const std::vector<std::string>& words) {
    const spec::Node* const node = spec::find(in, key);
    if (node == nullptr || !model::expect_scalar(*node, in.span, "'" + key + "'", reading_)) return std::nullopt;
    const std::string& word = node->scalar.text;
    for (const std::string& known : words) {
      if (known == word) return Word{word, node->span};
    }
    const std::string near = gaussgen::support::did_you_mean(word, words);
    error(code::k_unknown_word, node->span, fmt::format("there is no {} '{}'", key, word),
          near.empty() ? "there are " + gaussgen::support::joined(words) : near);
    return std::nullopt;
  }

  void refuse_pair(const std::string& first, const std::string& second) {
    const spec::Node* const both = spec::find(root_, second);
    if (both == nullptr || spec::find(root_, first) == nullptr) return;
    error(code::k_conflicting_keys, both->span, fmt::format("'{}' and '{}' exclude each other", first, second),
          "leave one of the two out");
  }

  const spec::Node& root_;
  model::Reading& reading_;
  Scene scene_;
  NumberReader numbers_{reading_};
};

}  // namespace

std::optional<Scene> read_scene(const Source& source, Diagnostics& diagnostics) {
  const auto root = spec::read_yaml(source, diagnostics);
  if (!root) return std::nullopt;
  model::Reading reading{source, diagnostics, {}};
  if (!model::expect_map(*root, root->span, "a scene", reading)) return std::nullopt;
  return SceneReader(*root, reading).read();
}

}  // namespace gausssim
