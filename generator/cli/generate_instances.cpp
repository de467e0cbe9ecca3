// Several bodies of one model: the functions of each set of effects are derived and written once.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/generated.hpp"
#include "cli/guard.hpp"
#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "emit/instances.hpp"
#include "model/evaluate.hpp"
#include "read_model.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::cli {

namespace {

namespace code = support::code;

/// A set of effects, and what else functions depend on.
struct Set {
  std::string first;  ///< the first body that has it
  model::GivenEffects words;
  std::string key;
  std::vector<SceneValue> values;  ///< the scene's own, and what no value of a parameter at run time says
  std::vector<std::string> effects;
};

class Bodies {
 public:
  explicit Bodies(Input& input) : input_(input) {}

  /// Nothing is derived yet. Another code than success: why has been said.
  int read() {
    for (const InstanceOfScene& one : input_.choice.instances) {
      const int code = read(one);
      if (code != k_ok) return code;
    }
    return report(found_, *input_.scene, input_.options.messages);
  }

  const std::vector<Set>& sets() const { return sets_; }
  const std::vector<emit::InstanceRow>& rows() const { return rows_; }

 private:
  int read(const InstanceOfScene& one) {
    const SceneChoice choice = as_instance(input_.choice, one);
    model::Choices choices = input_.options.pipeline.choices;
    const bool are_of_scene = !input_.are_effects_of_options;
    if (are_of_scene) {
      choices.effects.clear();
      for (const PlacedWord& word : choice.effects) choices.effects.push_back(word.text);
    }
    support::Diagnostics of_model;
    std::optional<model::Model> read;
    try {
      read = read_model(input_.source, of_model, choices);
    } catch (const model::WrongEffects& wrong) {
      if (!are_of_scene) throw;
      for (const model::EffectMistake& mistake : wrong.mistakes())
        refuse(code::k_effect_choice, choice.effects[mistake.word].span, mistake.message, mistake.hint);
      return k_ok;
    }
    if (!read) return report(of_model, input_.source, input_.options.messages);
    add(one, choice, choices.effects, *read);
    return k_ok;
  }

  void add(const InstanceOfScene& one, const SceneChoice& choice, const model::GivenEffects& words,
           model::Model& read) {
    Set set{one.name, words, "", input_.choice.values, {}};
    for (const model::Effect& effect : read.effects) {
      if (effect.acts) set.effects.push_back(effect.name.text);
    }
    set.key = fmt::format("{}", fmt::join(set.effects, " "));
    for (const SceneValue& value : one.values) {
      if (!stands_in_code(value, read)) continue;
      set.key += fmt::format("\n{} {}", value.name, value.is_of_start ? value.text : "");
      set.values.erase(std::remove_if(set.values.begin(), set.values.end(),
                                      [&](const SceneValue& other) { return other.name == value.name; }),
                       set.values.end());
      set.values.push_back(value);
    }
    try {
      give_values(choice.values, read);
    } catch (const WrongScene& wrong) {
      for (const auto& finding : wrong.found().all()) refuse(finding.code, finding.span, finding.message, finding.hint);
      return;
    }
    rows_.push_back(row_of(one, read));
    rows_.back().variant = index_of(set);
  }

  /// A number in place of a formula, which is no parameter else; and a start that constraints have to agree with, which is found by functions of its own.
  static bool stands_in_code(const SceneValue& value, const model::Model& read) {
    if (absent_effect_of(value.name, read) != nullptr) return false;
    if (value.is_of_start) return !read.constraints.empty();
    const auto is_formula = [&](const model::Parameter& one) { return one.name.text == value.name && one.is_formula; };
    return std::any_of(read.parameters.begin(), read.parameters.end(), is_formula);
  }

  static emit::InstanceRow row_of(const InstanceOfScene& one, const model::Model& read) {
    emit::InstanceRow row{one.name, 0, {}, {}};
    const model::Values values = model::parameter_values(read);
    for (const SceneValue& value : one.values) {
      if (absent_effect_of(value.name, read) != nullptr) continue;
      const auto number = model::value_of(parse_value(value.name, value.text), values);
      if (!number || (value.is_of_start && !read.constraints.empty())) continue;
      (value.is_of_start ? row.start : row.values).emplace_back(as_component(value.name), *number);
    }
    return row;
  }

  /// Of `dot(x)`, which is called x_dot in states.
  static std::string as_component(const std::string& name) {
    const bool is_dot = name.rfind("dot(", 0) == 0 && name.back() == ')';
    return is_dot ? name.substr(4, name.size() - 5) + "_dot" : name;
  }

  std::size_t index_of(const Set& set) {
    const auto same = std::find_if(sets_.begin(), sets_.end(), [&](const Set& one) { return one.key == set.key; });
    const auto index = static_cast<std::size_t>(same - sets_.begin());
    if (same == sets_.end()) sets_.push_back(set);
    return index;
  }

  /// What the scene says for all of them is wrong once.
  void refuse(const std::string& id, support::Span span, const std::string& message, const std::string& hint) {
    if (said_.insert(fmt::format("{} {} {}", id, span.begin, message)).second) found_.error(id, span, message, hint);
  }

  Input& input_;
  std::vector<Set> sets_;
  std::vector<emit::InstanceRow> rows_;
  support::Diagnostics found_;
  std::set<std::string> said_;
};

Options options_of(const Set& set, const Input& input) {
  Options own = input.options;
  PipelineOptions& pipeline = own.pipeline;
  pipeline.choices.effects = set.words;
  // Not the name that --instance has: there, defaults are those of the instance.
  pipeline.name = input.choice.name + "_variants_" + set.first;
  if (!pipeline.name_space.empty()) pipeline.name_space += "::" + set.first;
  pipeline.adjust = [values = set.values](model::Model& model) { give_values(values, model); };
  return own;
}

void refuse_what_does_not_go(const Options& options) {
  if (!options.split.empty() || !options.dumps.empty())
    throw UsageError(
        "the scene is of several bodies, whose header goes with none of --split and --dump; --instance NAME takes one "
        "of them");
}

}  // namespace

bool is_of_instances(const Input& input) { return !input.choice.instances.empty() && input.options.variants.empty(); }

int generate_instances(Input& input) {
  const Options& options = input.options;
  refuse_what_does_not_go(options);
  Bodies bodies(input);
  if (const int code = bodies.read(); code != k_ok) return code;
  std::vector<emit::Variant> variants;
  std::vector<std::string> headers;
  for (const Set& set : bodies.sets()) {
    const Options own = options_of(set, input);
    std::string dumped;
    int code = k_ok;
    const auto result = compiled(own, input.source, dumped, code);
    if (!result) return code;
    if (options.check) say_checked(*result, input.source);
    // As it is emitted: names of macros and keywords have a '_' there.
    variants.push_back(
        {set.first, result->model_name, result->tree.name_space, set.effects, {}, guards_of(result->unit)});
    headers.push_back(result->header);
  }
  if (options.check) return k_ok;
  const std::string outer = options.pipeline.name_space.empty() ? "gauss" : options.pipeline.name_space;
  const std::string text = emit::instances_header(input.choice.name, outer, "gauss-gen " + options.pipeline.chosen_by,
                                                  variants, headers, bodies.rows());
  if (options.output == "-")
    write_standard_output(text);
  else
    write_files(input, {{header_path(options, input.choice.name + "_variants"), text}});
  return k_ok;
}

}  // namespace gaussgen::cli
