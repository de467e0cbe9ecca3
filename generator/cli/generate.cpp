#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <string_view>

#include "cli/assignments.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/input.hpp"
#include "cli/messages.hpp"
#include "cli/replacement.hpp"
#include "cli/timings.hpp"
#include "cli/usage_error.hpp"
#include "emit/variants.hpp"
#include "read_model.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::cli {

namespace {

std::string header_path(const Options& options, const std::string& model_name) {
  const std::string file = model_name + ".hpp";
  if (options.output.empty() || options.output == "-") return options.output == "-" ? "-" : file;
  return options.output.back() == '/' ? options.output + file : options.output + "/" + file;
}

/// Beside the header.
std::string source_path(const std::string& header) {
  return header.substr(0, header.size() - std::string_view(".hpp").size()) + ".cpp";
}

/// Make's syntax: blanks, # and $ in names are escaped. A ':' is not, as by compilers: CMake would look for a file with a '\'.
std::string for_make(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == '\n') refuse("--depfile", "make has no way to write a file name with a line break");
    if (std::string_view(" \t#\\").find(c) != std::string_view::npos) result += '\\';
    if (c == '$') result += '$';
    result += c;
  }
  return result;
}

std::string dependencies(const std::string& target, const Input& input) {
  std::string line = for_make(target) + ":";
  std::vector<std::string> files = input.source.names();
  if (input.options.model == "-") files.erase(files.begin());
  if (input.scene) files.push_back(input.scene->name());
  for (const std::string& file : files) line += " " + for_make(file);
  return line + "\n";
}

using Files = std::vector<std::pair<std::string, std::string>>;  ///< paths and texts

// All are written before the first is put in place: a full disk leaves everything as it was.
void write_files(const Input& input, Files files) {
  const Options& options = input.options;
  if (!options.depfile.empty()) {
    for (const auto& file : files) {
      if (are_same_file(options.depfile, file.first))
        fail_on(file.first, "it cannot be both the header and the depfile");
    }
    const std::string& target = options.depfile_target.empty() ? files.front().first : options.depfile_target;
    files.emplace_back(options.depfile, dependencies(target, input));
  }
  for (const auto& file : files) {
    keep_what_was_read(file.first, input.source);
    if (input.scene) keep_what_was_read(file.first, *input.scene);
  }
  std::list<Replacement> replacements;
  for (const auto& [name, text] : files) replacements.emplace_back(name, text);
  for (Replacement& replacement : replacements) replacement.commit();
}

/// Below, compilers take no time to speak of.
constexpr int k_large_header = 20'000;

/// Of outputs that nobody asked for by name: the one that is more than half of a large header, with what is left without it.
void remark_on_size(const PipelineResult& result, const MessageOptions& messages) {
  int sum = 0;
  for (const emit::OutputSize& one : result.outputs) sum += one.operations;
  if (result.chose_outputs || sum < k_large_header) return;
  const auto is_most = [&](const emit::OutputSize& one) { return one.operations > sum / 2 && one.output != "rhs"; };
  const auto most = std::find_if(result.outputs.begin(), result.outputs.end(), is_most);
  if (most == result.outputs.end()) return;
  std::vector<std::string> others;
  for (const emit::OutputSize& one : result.outputs) {
    if (&one != &*most) others.push_back(one.output);
  }
  remark(fmt::format("'{}' is {} of the {} operations in {}.hpp; without it: --outputs {} (or 'outputs' in the model)",
                     most->output, most->operations, sum, result.model_name, fmt::join(others, ",")),
         {{"output", most->output},
          {"operations", static_cast<long long>(most->operations)},
          {"of_operations", static_cast<long long>(sum)}},
         messages);
}

/// Only the model's own text is needed for these two, so no derivation is made.
int list_outputs(const Options& options, support::Source& source) {
  support::Diagnostics diagnostics;
  const auto model = read_model(source, diagnostics, options.pipeline.choices);
  const int code = report(diagnostics, source, options.messages);
  if (!model || code != k_ok) return code;
  const std::string name = options.pipeline.name.empty() ? model->name.text : options.pipeline.name;
  const std::string header = header_path(options, name);
  if (options.variants.empty()) {
    write_standard_output(header + "\n" + (options.split.empty() ? "" : source_path(header) + "\n"));
    return k_ok;
  }
  std::string list;
  for (const auto& variant : options.variants) list += header_path(options, name + "_" + variant.first) + "\n";
  write_standard_output(list + header_path(options, name + "_variants") + "\n");
  return k_ok;
}

}  // namespace

namespace {

/// Of those that are to be printed; none where the header is wanted.
std::string last_stage(const std::vector<std::string>& dumps) {
  std::string last;
  for (const std::string& stage : stage_names()) {
    if (std::find(dumps.begin(), dumps.end(), stage) != dumps.end()) last = stage;
  }
  return last;
}

}  // namespace

namespace {

/// Of one header. Nothing where the model has mistakes, which are reported: `code`.
std::optional<PipelineResult> compiled(const Options& options, support::Source& source, std::string& dumped,
                                       int& code) {
  std::optional<ReadingGuard> guard(options.messages);
  std::optional<DerivationGuard> derivation;
  const StageObserver observe = [&](const std::string& stage, const std::function<std::string()>& dump) {
    guard.reset();  // the first stage is that of the text
    if (!derivation) derivation.emplace(stage_names(), options.most_seconds, options.messages);
    derivation->finish_stage();
    if (std::find(options.dumps.begin(), options.dumps.end(), stage) == options.dumps.end()) return;
    if (options.dumps.size() > 1) dumped += "=== " + stage + "\n";
    dumped += dump();
  };
  support::Diagnostics diagnostics;
  PipelineOptions pipeline = options.pipeline;
  pipeline.last_stage = last_stage(options.dumps);
  pipeline.only_check = options.check && options.dumps.empty();
  auto result = compile(source, pipeline, diagnostics, observe);
  derivation.reset();  // before anything is written
  code = report(diagnostics, source, options.messages);
  if (!result || code != k_ok) return std::nullopt;
  if (options.timings) print_timings(*result, options.messages);
  for (const std::string& moved : result->assembled) remark("assembled " + moved, options.messages);
  return result;
}

void say_checked(const PipelineResult& result, const support::Source& source) {
  const char* const remark = result.has_units ? "" : " (it states no units, so none are checked)";
  const std::string mobility = result.mobility.empty() ? "" : ", " + result.mobility;
  write_standard_output(fmt::format("{}: ok{}{}\n", source.name(), mobility, remark));
}

int generate_header(Input& input) {
  const Options& options = input.options;
  std::string dumped;
  int code = k_ok;
  const auto result = compiled(options, input.source, dumped, code);
  if (!result || !options.dumps.empty()) {
    write_standard_output(dumped);
    return code;
  }
  if (options.check) {
    say_checked(*result, input.source);
  } else if (options.output == "-") {
    write_standard_output(result->header);
  } else {
    const std::string path = header_path(options, result->model_name);
    Files files{{path, result->header}};
    if (!result->source.empty()) files.emplace_back(source_path(path), result->source);
    write_files(input, std::move(files));
    remark_on_size(*result, options.messages);
  }
  return k_ok;
}

std::vector<std::string> modes_of(const model::GivenRegime& regime) {
  std::vector<std::string> modes;
  for (const auto& [name, mode] : regime) modes.push_back(name + "=" + mode);
  return modes;
}

std::string command_of_variants(const Options& options) {
  std::string text = "gauss-gen " + std::filesystem::path(options.model).filename().string();
  if (options.pipeline.choices.is_ground) text += " --regime ground";
  for (const std::string& mode : modes_of(options.pipeline.choices.regime)) text += " --regime " + mode;
  for (const auto& [name, words] : options.variants)
    text += fmt::format(" --variant {}={}", name, fmt::join(words, ","));
  return text;
}

std::vector<std::string> guards_of(const emit::Unit& unit) {
  std::vector<std::string> names;
  for (const emit::Artefact& one : unit.artefacts) {
    if (one.name != "guards") continue;
    for (const emit::Field& field : one.groups.front().fields) names.push_back(field.name);
  }
  return names;
}

/// Outputs are those of all variants, and some are of one regime alone: impact_system, initial_state.
void leave_out_what_others_have(PipelineOptions& options) {
  if (options.outputs.empty()) return;
  options.where_possible = options.outputs;
  options.outputs = {"rhs"};
}

/// A header for each set of effects or regime, and one with a table of them.
int generate_variants(Input& input) {
  const Options& options = input.options;
  const std::string file = std::filesystem::path(options.model).filename().string();
  Files files;
  std::vector<emit::Variant> variants;
  std::string name;
  for (const auto& [variant, words] : options.variants) {
    Options own = options;
    own.pipeline.choices = choices_of_variant(variant, words, options.pipeline.choices);
    if (!own.pipeline.choices.regime.empty()) leave_out_what_others_have(own.pipeline);
    own.pipeline.chosen_by = fmt::format("{} --variant {}={}", file, variant, fmt::join(words, ","));
    own.pipeline.adjust = [&, given = variant, adjust = options.pipeline.adjust](model::Model& model) {
      if (adjust) adjust(model);
      name = options.pipeline.name.empty() ? model.name.text : options.pipeline.name;
      model.name.text = name + "_" + given;
    };
    own.pipeline.name.clear();
    if (!options.pipeline.name_space.empty()) own.pipeline.name_space += "::" + variant;
    std::string dumped;
    int code = k_ok;
    std::optional<PipelineResult> result;
    try {
      result = compiled(own, input.source, dumped, code);
    } catch (const model::WrongEffects& wrong) {
      throw UsageError(fmt::format("--variant {}: {}", variant, wrong_effects(wrong, own.pipeline.choices.effects)));
    } catch (const model::WrongRegime& wrong) {
      throw UsageError(fmt::format("--variant {}: {}", variant, wrong.what()));
    }
    if (!result) return code;
    if (options.check) say_checked(*result, input.source);
    const std::string name_space =
        own.pipeline.name_space.empty() ? "gauss::" + result->model_name : own.pipeline.name_space;
    emit::Variant found{variant,
                        result->model_name,
                        name_space,
                        result->effects,
                        modes_of(own.pipeline.choices.regime),
                        guards_of(result->unit)};
    const auto same = std::find_if(variants.begin(), variants.end(),
                                   [&](const emit::Variant& one) { return one.has_code_of(found); });
    if (same == variants.end()) {
      files.emplace_back(header_path(options, result->model_name), result->header);
    } else {
      const std::string alias = options.pipeline.name_space.empty() ? result->model_name : variant;
      files.emplace_back(header_path(options, result->model_name),
                         emit::alias_header(result->model_name, command_of_variants(options), *same, alias));
      found.model_name = same->model_name;
      found.name_space = same->name_space;
    }
    variants.push_back(std::move(found));
  }
  if (options.check) return k_ok;
  const std::string table = name + "_variants";
  const std::string name_space = options.pipeline.name_space.empty() ? "gauss::" + table : options.pipeline.name_space;
  files.emplace_back(header_path(options, table),
                     emit::variants_header(table, name_space, command_of_variants(options), variants));
  write_files(input, std::move(files));
  return k_ok;
}

/// What is wrong with words of a scene is said there; others are those of an option.
template <class Generate>
int with_places(Input& input, Generate&& generate) {
  try {
    return generate(input);
  } catch (const model::WrongEffects& wrong) {
    if (input.places.empty()) throw;
    support::Diagnostics diagnostics;
    for (const model::EffectMistake& one : wrong.mistakes())
      diagnostics.error(support::code::k_effect_choice, input.places[one.word], one.message, one.hint);
    return report(diagnostics, *input.scene, input.options.messages);
  }
}

}  // namespace

int generate(const Options& options) {
  int code = k_ok;
  auto input = read_input(options, code);
  if (!input) return code;
  return with_places(*input, [&](Input& in) {
    if (options.list_outputs) {
      const ReadingGuard guard(options.messages);
      return list_outputs(in.options, in.source);
    }
    return in.options.variants.empty() ? generate_header(in) : generate_variants(in);
  });
}

}  // namespace gaussgen::cli
