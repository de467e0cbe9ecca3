#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/assignments.hpp"
#include "cli/exit_codes.hpp"
#include "cli/generated.hpp"
#include "cli/usage_error.hpp"
#include "emit/variants.hpp"

namespace gaussgen::cli {

namespace {

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

/// Outputs are those of all variants, and some are of one regime alone: impact_system, initial_state.
void leave_out_what_others_have(PipelineOptions& options) {
  if (options.outputs.empty()) return;
  options.where_possible = options.outputs;
  options.outputs = {"rhs"};
}

}  // namespace

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
    // As it is emitted: names of macros and keywords have a '_' there.
    emit::Variant found{variant,
                        result->model_name,
                        result->tree.name_space,
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

}  // namespace gaussgen::cli
