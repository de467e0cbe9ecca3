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

std::string command_of_variants(const Options& options) {
  std::string text = "gauss-gen " + std::filesystem::path(options.model).filename().string();
  for (const auto& [name, words] : options.variants)
    text += fmt::format(" --variant {}={}", name, fmt::join(words, ","));
  return text;
}

}  // namespace

int generate_variants(Input& input) {
  const Options& options = input.options;
  const std::string file = std::filesystem::path(options.model).filename().string();
  Files files;
  std::vector<emit::Variant> variants;
  std::string name;
  for (const auto& [variant, words] : options.variants) {
    Options own = options;
    own.pipeline.choices.effects = words;
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
      throw UsageError(fmt::format("--variant {}: {}", variant, wrong_effects(wrong, words)));
    }
    if (!result) return code;
    if (options.check) say_checked(*result, input.source);
    const auto same = std::find_if(variants.begin(), variants.end(),
                                   [&](const emit::Variant& one) { return one.effects == result->effects; });
    if (same != variants.end()) {
      const std::string alias = options.pipeline.name_space.empty() ? result->model_name : variant;
      files.emplace_back(header_path(options, result->model_name),
                         emit::alias_header(result->model_name, command_of_variants(options), *same, alias));
      variants.push_back({variant, same->model_name, same->name_space, result->effects});
      continue;
    }
    // As it is emitted: names of macros and keywords have a '_' there.
    variants.push_back({variant, result->model_name, result->tree.name_space, result->effects});
    files.emplace_back(header_path(options, result->model_name), result->header);
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
