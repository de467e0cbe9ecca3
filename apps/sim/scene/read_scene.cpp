#include "sim/scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/fields.hpp"
#include "scene_choice.hpp"
#include "sim/scene/choices.hpp"
#include "sim/scene/read_ensemble.hpp"
#include "sim/scene/read_fields.hpp"
#include "sim/scene/read_instances.hpp"
#include "sim/scene/read_numbers.hpp"
#include "spec/reader.hpp"
#include "support/error_codes.hpp"

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

class SceneReader {
 public:
  SceneReader(const spec::Node& root, model::Reading& reading)
      : root_(root), reading_(reading), fields_(root, root.span, reading) {}

  Scene read() {
    model::check_keys(root_, k_where, gaussgen::keys_of_scenes(), reading_);
    check_version();
    read_name();
    scene_.about = model::text_field(root_, "about", reading_);
    if (const spec::Node* const file = model::required(root_, "model", root_.span, k_where, reading_)) {
      if (model::expect_scalar(*file, root_.span, "'model'", reading_)) scene_.model = {file->scalar.text, file->span};
    }
    read_counts();
    fields_.effects(scene_.effects);
    fields_.given("parameters", scene_.parameters);
    fields_.given("initial", scene_.initial);
    fields_.given("inputs", scene_.inputs);
    fields_.given("exact", scene_.exact);
    scene_.start = model::expression_field(root_, "start", reading_);
    scene_.duration = model::expression_field(root_, "duration", reading_);
    scene_.every = model::expression_field(root_, "every", reading_);
    read_samples();
    fields_.outputs(scene_.outputs);
    scene_.method = fields_.choice("method", method_names());
    scene_.number = fields_.choice("number", number_names());
    scene_.projection = fields_.choice("projection", projection_names());
    scene_.strategy = fields_.choice("strategy", strategy_names());
    scene_.code = fields_.choice("code", code_names());
    scene_.engine = fields_.choice("engine", engine_names());
    scene_.tolerance = fields_.positive("tolerance", scene_.places);
    read_error();
    scene_.step = fields_.positive("step", scene_.places);
    scene_.longest_step = fields_.positive("longest_step", scene_.places);
    scene_.gain = fields_.positive("gain", scene_.places);
    if (const spec::Node* const ensemble = spec::find(root_, "ensemble"))
      scene_.ensemble = read_ensemble(*ensemble, root_, reading_);
    fields_.refuse_pair("every", "samples");
    fields_.refuse_pair("tolerance", "error");
    fields_.refuse_pair("step", "error");
    read_forms();
    read_instances(root_, scene_, reading_);
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
      FieldReader fields(entry.value, entry.value.span, reading_);
      form.strategy = fields.choice("strategy", strategy_names());
      fields.given("parameters", form.parameters);
      fields.given("initial", form.initial);
      scene_.forms.push_back(std::move(form));
    });
  }

  void read_error() {
    scene_.error = fields_.positive("error", scene_.places);
    if (scene_.error && *scene_.error >= 1)
      error(code::k_out_of_range, scene_.places["error"],
            "an error of 1 is the whole range of an output: it is below 1", "such as error: 1e-6");
  }

  void read_samples() {
    const spec::Node* const node = spec::find(root_, "samples");
    if (node == nullptr) return;
    if (const auto number = numbers_.whole(*node, node->span, 2, k_most_samples, 501)) scene_.samples = *number;
  }

  const spec::Node& root_;
  model::Reading& reading_;
  FieldReader fields_;
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
