#include "sim/run/prepare.hpp"
#include "scene_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "cli/assignments.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "ir/graph.hpp"
#include "mechanics.hpp"
#include "model/evaluate.hpp"
#include "pipeline.hpp"
#include "sim/engine/plugin_text.hpp"
#include "sim/model/layout.hpp"
#include "sim/regimes/columns_of_regimes.hpp"
#include "sim/run/among_instances.hpp"
#include "sim/run/check_choices.hpp"
#include "sim/run/exact_columns.hpp"
#include "sim/run/given_bodies.hpp"
#include "sim/run/jumps.hpp"
#include "sim/run/number_range.hpp"
#include "sim/run/scene_values.hpp"
#include "sim/run/setting.hpp"
#include "sim/run/shared_codes.hpp"
#include "sim/scene/instances.hpp"
#include "sim/scene/read_scene.hpp"
#include "support/error_codes.hpp"
#include "support/files.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
using gaussgen::support::Diagnostics;
using gaussgen::support::Source;

/// What is wrong with a scene shows when its model is read: motions with these values are not asked for.
struct BadScene {};

/// What another instance was derived with does for this one.
struct KnownCode {
  SharedCode code;
};

/// A model beside the file that is not there, if its name is near; else where it was looked for.
std::string hint_for(const std::string& missing) {
  const std::filesystem::path path(missing);
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", error))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().filename().string());
  const std::string near = gaussgen::support::did_you_mean(path.filename().string(), names);
  return near.empty() ? "paths begin at the folder of the scene" : near;
}

/// The scene with another description of its motion.
void take_form(const std::string& name, Scene& scene) {
  const auto form =
      std::find_if(scene.forms.begin(), scene.forms.end(), [&](const GivenForm& one) { return one.name.text == name; });
  if (form == scene.forms.end()) return;
  const auto add = [&](const std::vector<Given>& more, std::vector<Given>& all) {
    if (form->model) all.clear();
    all.insert(all.end(), more.begin(), more.end());
  };
  add(form->initial, scene.initial);
  if (!form->parameters.empty()) add(form->parameters, scene.parameters);
  if (form->model) scene.model = *form->model;
  if (form->strategy) scene.strategy = form->strategy;
}

/// Not the start, nor inputs.
bool set_parameters_alone(const std::vector<std::string>& sets, const model::Model& read) {
  return std::all_of(sets.begin(), sets.end(), [&](const std::string& set) {
    const std::string name = set.substr(0, set.find('='));
    return std::any_of(read.parameters.begin(), read.parameters.end(),
                       [&](const model::Parameter& one) { return one.name.text == name; });
  });
}

int operations_of(const gaussgen::PipelineResult& compiled, const std::string& output) {
  for (const auto& one : compiled.outputs) {
    if (one.output == output) return one.operations;
  }
  return 0;
}

std::array<double, 3> gravity_of(const model::Model& read, const Span& span, model::Values values) {
  std::array<double, 3> sum{};
  values["t"] = span.start;
  for (const model::Force& force : read.forces) {
    const auto* const uniform = std::get_if<model::UniformField>(&force.law);
    for (std::size_t i = 0; uniform != nullptr && i < 3; ++i)
      sum[i] += model::value_of(uniform->field[i], values).value_or(0);
  }
  return sum;
}

gaussgen::Strategy strategy_of(const Scene& scene) {
  using gaussgen::Strategy;
  for (const Strategy one : {Strategy::tree, Strategy::metric, Strategy::multipliers}) {
    if (scene.strategy && gaussgen::name_of(one) == scene.strategy->text) return one;
  }
  return Strategy::automatic;
}

/// Whoever asks for what is not there is told of all that could be.
std::optional<gaussgen::PipelineResult> with_all_outputs(Source& source, gaussgen::PipelineOptions options) {
  options.plain = true;
  options.where_possible = sampled_outputs();
  Diagnostics ignored;
  try {
    return compile(source, options, ignored, nullptr);
  } catch (const gaussgen::ir::TooManyNodes&) {
    return std::nullopt;
  }
}

/// Nobody has asked for what is empty, where outputs were chosen for the user.
Diagnostics without_empty_outputs(const Diagnostics& all) {
  Diagnostics kept;
  for (const auto& found : all.all()) {
    if (found.code != std::string(code::k_empty_output)) kept.add(found);
  }
  return kept;
}

gaussgen::model::GivenCounts counts_of(const Scene& scene) {
  gaussgen::model::GivenCounts counts;
  for (const GivenCount& given : scene.counts) counts[given.name.text] = given.count;
  return counts;
}

/// For whatever is done with the model.
gaussgen::PipelineOptions pipeline_options(const Request& request, const Scene& scene) {
  gaussgen::PipelineOptions options;
  options.fold = scene.code && scene.code->text == "folded";
  options.plain = scene.code && scene.code->text == "expanded";
  options.where_possible = request.where_possible;
  options.choices.is_ground = true;
  for (const char* const output : {"guards", "impact_system"}) options.where_possible.emplace_back(output);
  options.choices.counts = counts_of(scene);
  for (const Word& word : scene.effects) options.choices.effects.push_back(word.text);
  options.strategy = strategy_of(scene);
  options.outputs = generator_outputs(scene.outputs);
  for (const char* const output : {"initial_state", "project", "energy", "residuals"})
    options.outputs.push_back(output);
  options.outputs.insert(options.outputs.end(), request.also.begin(), request.also.end());
  const bool uses_gains = scene.projection && scene.projection->text == "gains";
  if (uses_gains) options.where_possible.push_back("mass_matrix");
  if (scene.method && scene.method->text == "taylor") options.outputs.push_back("taylor");
  if (chooses_method(scene) && !request.leaves_series_out) options.where_possible.push_back("taylor");
  return options;
}

class Preparation {
 public:
  explicit Preparation(const Request& request)
      : request_(request), scene_text_(request.text ? *request.text : cli::read_source(request.file)) {}

  std::optional<PreparedModel> run(const std::function<void(Scene&)>& change) {
    const auto begin = std::chrono::steady_clock::now();
    if (!read_scene_and_model(change)) return std::nullopt;
    options_ = pipeline_options(request_, result_.scene);
    options_.adjust = [this](model::Model& read) { take_values(read); };
    const auto& welcome = options_.where_possible;
    result_.wants_gains = std::find(welcome.begin(), welcome.end(), "mass_matrix") != welcome.end();
    if (!derive()) return std::nullopt;
    result_.generate_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }

  int exit_code() const { return exit_code_; }

  /// What was found so far; nothing the second time.
  bool report_mistakes() {
    if (!in_scene_.has_errors()) return false;
    exit_code_ = report(in_scene_, scene_text_);
    in_scene_ = {};
    return true;
  }

 private:
  bool read_scene_and_model(const std::function<void(Scene&)>& change) {
    is_scene_ = gaussgen::is_scene(scene_text_);
    if (is_scene_) {
      std::optional<Scene> scene = read_scene(scene_text_, in_scene_);
      if (scene) result_.scene = std::move(*scene);
    }
    if (!choose_instance()) return !report_mistakes();
    Scene& scene = result_.scene;
    if (!request_.form.empty()) take_form(request_.form, scene);
    change(scene);
    unused_ = check_choices(scene, in_scene_);
    result_.model_file = is_scene_ ? gaussgen::beside(request_.file, scene.model.text) : request_.file;
    if (is_scene_ && scene.model.text.empty()) return !report_mistakes();
    if (is_scene_ && !std::filesystem::exists(result_.model_file))
      refuse_file(scene.model, result_.model_file);
    else if (is_scene_)
      read_model(scene.model);
    if (model_text_ && gaussgen::is_scene(*model_text_)) {
      in_scene_.error(code::k_submodel_file, scene.model.span, fmt::format("'{}' is a scene itself", scene.model.text),
                      "name its model");
      model_text_.reset();
    }
    check_forms();
    return !is_scene_ || model_text_ || !report_mistakes();
  }

  /// False where there are several motions, and one is wanted: nothing can be looked for then.
  bool choose_instance() {
    Scene& scene = result_.scene;
    const std::vector<std::string> names = instance_names(scene);
    if (request_.instance.empty()) {
      if (names.empty()) return true;
      in_scene_.error(code::k_conflicting_keys, scene.instances_place,
                      "these are several motions, of which this takes one; 'gauss-sim run' takes all of them",
                      fmt::format("--instance {} takes that one; there are {}", names.front(),
                                  gaussgen::support::joined_first(names)));
      return false;
    }
    if (const Instance* const found = find_instance(scene, request_.instance)) {
      const Instance one = *found;
      own_ = one.extent;
      take_instance(one, scene);
      return true;
    }
    const std::string near = gaussgen::support::did_you_mean(request_.instance, names);
    throw cli::UsageError(fmt::format(
        "--instance: '{}' has no instance{}", request_.file,
        names.empty() ? "s"
                      : fmt::format(" '{}'; {}", request_.instance,
                                    near.empty() ? "there are " + gaussgen::support::joined_first(names) : near)));
  }

  int report(const Diagnostics& found, const Source& source) {
    if (request_.among == nullptr) return cli::report(found, source, request_.messages);
    if (&source == &scene_text_)
      request_.among->note(found, request_.instance, own_);
    else
      cli::report(request_.among->not_yet_said(found), source, request_.messages);
    cli::MessageOptions silent = request_.messages;
    silent.is_silent = true;
    return cli::report(found, source, silent);
  }

  /// Each may be chosen, whatever is done now.
  void check_forms() {
    for (const GivenForm& form : result_.scene.forms) {
      if (!form.model) continue;
      const std::string file = gaussgen::beside(request_.file, form.model->text);
      if (!std::filesystem::exists(file)) refuse_file(*form.model, file);
    }
  }

  void read_model(const Word& named) {
    std::string why;
    auto text = gaussgen::support::read_file(result_.model_file, why);
    if (!text)
      in_scene_.error(code::k_submodel_file, named.span, fmt::format("'{}' {}", named.text, why), "name its model");
    else
      model_text_.emplace(Source{result_.model_file, std::move(*text), gaussgen::support::read_regular_file});
  }

  void refuse_file(const Word& named, const std::string& file) {
    in_scene_.error(code::k_submodel_file, named.span, fmt::format("there is no file '{}'", named.text),
                    hint_for(file));
  }

  Source& model_text() { return model_text_ ? *model_text_ : scene_text_; }

  /// What scene and options change in the model.
  void take_values(model::Model& read) {
    const Scene& scene = result_.scene;
    GivenBodies bodies(scene, own_);
    bodies.look_at(read);
    give_values(scene, read, in_scene_);
    if (!request_.sets.empty() && !in_scene_.has_errors()) bodies.note_scene(read);
    sets_ = sets_for(read);
    cli::apply_overrides(sets_, read);
    if (request_.adjust) request_.adjust(scene, read, in_scene_);
    parameters_ = model::parameter_values(read);
    if (!in_scene_.has_errors()) bodies.check(read, request_.sets, in_scene_);
    check_range_of_numbers(scene, read, parameters_, in_scene_);
    remarks_ = remarks_on_quaternions(read, parameters_);
    result_.parameters.clear();
    for (const model::Parameter& one : read.parameters) result_.parameters.emplace_back(one.name.text, one.value);
    result_.known_effects = read.effects;
    result_.effects.clear();
    for (const model::Effect& effect : read.effects) {
      if (effect.acts) result_.effects.push_back(effect.name.text);
    }
    switches_ = switches_of(read);
    result_.edge = function_with_edge(read);
    result_.acts_in_time = acts_in_time(read);
    if (const std::string remark = remark_on_edge(); !remark.empty()) remarks_.push_back(remark);
    if (set_parameters_alone(request_.sets, read)) closed_forms_ = read.exact;
    result_.span = read_times(scene, parameters_, in_scene_);
    if (in_scene_.has_errors()) throw BadScene{};
    result_.gravity = gravity_of(read, result_.span, parameters_);
    if (!looks_for_code_) return;
    key_ = key_of_code(read, options_);
    if (const SharedCode* const known = request_.among->codes.find(key_)) throw KnownCode{*known};
  }

  /// Among instances, a value for an effect is one for those in which it acts.
  std::vector<std::string> sets_for(const model::Model& read) {
    return request_.among == nullptr ? request_.sets : request_.among->sets_for(request_.sets, read);
  }

  std::string remark_on_edge() const {
    const Scene& scene = result_.scene;
    if (result_.edge.empty() || chooses_method(scene) || find_method(scene.method->text)->sees_jumps) return "";
    return fmt::format("'{}' may step over a place where a force jumps, as by {}, without a word: {} and {} see it",
                       scene.method->text, result_.edge, k_method_of_any_model, k_method_of_edges);
  }

  std::optional<gaussgen::PipelineResult> compiled(Diagnostics& found) {
    const Diagnostics before = in_scene_;
    looks_for_code_ = request_.among != nullptr;
    while (true) {
      try {
        auto result = compile(model_text(), options_, found, nullptr);
        looks_for_code_ = false;
        return result;
      } catch (const KnownCode& known) {
        looks_for_code_ = false;
        in_scene_ = before;
        return by_known_code(known.code, found = {});
      } catch (const model::UnknownCount& unknown) {
        refuse_count(unknown);
        found = {};
      } catch (const model::WrongEffects& wrong) {
        refuse_effects(wrong);
        found = {};
      }
    }
  }

  /// Only the start is derived, and all is checked that values may make wrong.
  std::optional<gaussgen::PipelineResult> by_known_code(const SharedCode& code, Diagnostics& found) {
    gaussgen::PipelineOptions of_start = options_;
    of_start.outputs = {"initial_state"};
    of_start.where_possible.clear();
    auto start = compile(model_text(), of_start, found, nullptr);
    if (!start) return std::nullopt;
    options_.where_possible = code.where_possible;
    result_.code = request_.among->codes.number_of(code);
    auto result = with_values_of(*start, *code.result);
    start_ = std::make_shared<Described>(Described{std::move(start->tree), std::move(start->unit)});
    return result;
  }

  /// What was derived now is for other instances, too.
  void keep_code(const gaussgen::PipelineResult& derived) {
    if (request_.among == nullptr || start_) return;
    SharedCode code{key_, std::make_shared<gaussgen::PipelineResult>(derived), options_.where_possible,
                    plugin_header(derived.tree)};
    result_.code = request_.among->codes.add(std::move(code), may_be_shared(derived, options_));
  }

  void refuse_count(const model::UnknownCount& unknown) {
    options_.choices.counts.erase(unknown.name());
    for (const GivenCount& given : result_.scene.counts) {
      if (given.name.text != unknown.name()) continue;
      if (is_of_option(given.name.span)) throw cli::UsageError(cli::unknown_count(unknown));
      const bool has_none = unknown.known().empty();
      const std::string near = gaussgen::support::did_you_mean(unknown.name(), unknown.known());
      in_scene_.error(
          code::k_wrong_reference, given.name.span,
          has_none
              ? fmt::format("the model has no '{}' that could be changed, since it has no 'counts'", unknown.name())
              : fmt::format("the model has no count '{}'", unknown.name()),
          has_none || !near.empty() ? near : "its counts are " + gaussgen::support::joined(unknown.known()));
    }
  }

  void refuse_effects(const model::WrongEffects& wrong) {
    const std::vector<Word>& words = result_.scene.effects;
    if (is_of_option(words.front().span)) throw cli::UsageError(cli::wrong_effects(wrong, options_.choices.effects));
    for (const model::EffectMistake& one : wrong.mistakes())
      in_scene_.error(code::k_effect_choice, words[one.word].span, one.message, one.hint);
    options_.choices.effects.clear();
  }

  bool derive() {
    Diagnostics found;
    std::optional<gaussgen::PipelineResult> result;
    try {
      result = compiled(found);
      if (result && !start_ && leaves_series_out(*result)) result = compiled(found = {});
      if (result) keep_code(*result);
    } catch (const BadScene&) {
      check_outputs_of_bad_scene();
    }
    const bool is_bad = report_mistakes();
    if (is_bad && !found.has_errors()) return false;
    const int code = report(without_empty_outputs(found), model_text());
    if (!is_bad) exit_code_ = code;
    if (is_bad || !result || code != cli::k_ok) return false;
    return take(std::move(*result));
  }

  /// Of the scene itself, once for all its forms.
  void warn() {
    if (request_.form.empty()) remarks_.insert(remarks_.end(), unused_.begin(), unused_.end());
    if (request_.form.empty() && !in_scene_.all().empty()) report(in_scene_, scene_text_);
    for (const std::string& remark : remarks_) {
      const bool is_said = request_.among != nullptr && !request_.among->is_new(remark);
      if (!request_.messages.is_silent && !is_said) cli::warn(remark, request_.messages);
    }
  }

  /// Whether the model is to be derived without series.
  bool leaves_series_out(const gaussgen::PipelineResult& compiled) {
    const bool may = request_.leaves_large_series_out && !result_.scene.error && chooses_method(result_.scene);
    if (!may || operations_of(compiled, "taylor") <= k_most_series_operations) return false;
    auto& welcome = options_.where_possible;
    welcome.erase(std::remove(welcome.begin(), welcome.end(), "taylor"), welcome.end());
    return true;
  }

  /// Of the model as its own file has it: what else the user has to mend.
  void check_outputs_of_bad_scene() {
    options_.adjust = nullptr;
    Diagnostics of_other_values;
    const auto result = compiled(of_other_values);
    if (result) choose_outputs({result->tree, result->unit});
  }

  /// Of a model with regimes, from which others are derived on the way.
  void take_regimes() {
    if (!switches_.any()) return;
    const auto adjust = [scene = result_.scene, sets = sets_](model::Model& read) {
      Diagnostics ignored;
      give_values(scene, read, ignored);
      cli::apply_overrides(sets, read);
    };
    result_.regimes = std::make_shared<RegimeSource>(model_text(), options_, adjust, switches_);
  }

  void choose_outputs(const Described& model) {
    const auto everything = [&] {
      auto all = with_all_outputs(model_text(), options_);
      return all ? Described{std::move(all->tree), std::move(all->unit)} : model;
    };
    const auto& outputs = result_.scene.outputs;
    Diagnostics found;
    result_.columns = result_.regimes ? columns_of_regimes(model, outputs, *result_.regimes, found, everything)
                                      : choose_columns(model, outputs, found, everything);
    const bool are_options = !outputs.empty() && is_of_option(outputs.front().span);
    std::string wrong;
    for (const auto& one : found.all())
      wrong += fmt::format("{}--outputs: {}; {}", wrong.empty() ? "" : "\n", one.message, one.hint);
    if (found.has_errors() && are_options) throw cli::UsageError(wrong);
    for (const auto& one : found.all()) in_scene_.add(one);
    if (result_.regimes) {
      for (Column& column : result_.columns.columns) column.is_conserved = false;
    }
    check_exact(result_.scene, result_.columns, parameters_, in_scene_);
  }

  bool take(gaussgen::PipelineResult compiled) {
    if (find_function(compiled.tree, "rhs") == nullptr) {
      exit_code_ = cli::fail(
          fmt::format("nothing moves in '{}' by itself: there is no motion to be found", compiled.unit.model_name),
          cli::k_motion_stopped, request_.messages);
      return false;
    }
    result_.operations = operations_of(compiled, "rhs");
    result_.series_operations = operations_of(compiled, "taylor");
    result_.model_text = model_text().text();
    result_.model = {std::move(compiled.tree), std::move(compiled.unit), start_};
    if (request_.among != nullptr) result_.plugins = request_.among->plugins;
    take_regimes();
    choose_outputs(result_.model);
    if (report_mistakes()) return false;
    warn();
    take_exact_of_model(closed_forms_, result_.columns, result_.span, parameters_, result_.scene);
    return true;
  }

  const Request& request_;
  Source scene_text_;                 ///< or that of the model, where no scene names one
  std::optional<Source> model_text_;  ///< that the scene names
  bool is_scene_ = false;
  Diagnostics in_scene_;
  gaussgen::PipelineOptions options_;
  model::Values parameters_;
  std::vector<std::string> remarks_;  ///< said once, however often the model is derived
  std::vector<std::string> unused_;   ///< of what options say
  std::vector<std::string> sets_;     ///< of those of the options, what this motion takes
  gaussgen::support::Span own_;       ///< of an instance: what it says itself
  std::string key_;                   ///< of its code
  bool looks_for_code_ = false;       ///< that another instance was derived with
  std::shared_ptr<const Described> start_;
  std::vector<model::ClosedForm> closed_forms_;
  Switches switches_;
  PreparedModel result_;
  int exit_code_ = cli::k_ok;
};

}  // namespace

void refuse_regimes(const PreparedModel& prepared, const char* what) {
  if (!prepared.regimes) return;
  throw cli::UsageError(fmt::format(
      "'{}' has contacts, dry friction or links that break, which {} does not follow: simulate it by 'run', "
      "with a method and a tolerance",
      prepared.name(), what));
}

std::optional<PreparedModel> prepare(const Request& request, const std::function<void(Scene&)>& change,
                                     int& exit_code) {
  Preparation preparation(request);
  try {
    auto result = preparation.run(change);
    exit_code = preparation.exit_code();
    return result;
  } catch (...) {
    // The command line is wrong, or a file cannot be read, and the scene may be wrong, too: both are said.
    preparation.report_mistakes();
    throw;
  }
}

}  // namespace gausssim
