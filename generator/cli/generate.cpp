#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/generated.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "read_model.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::cli {

namespace {

/// Beside the header.
std::string source_path(const std::string& header) {
  return header.substr(0, header.size() - std::string_view(".hpp").size()) + ".cpp";
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
int list_outputs(const Options& options, support::Source& source, bool of_instances) {
  support::Diagnostics diagnostics;
  const auto model = read_model(source, diagnostics, options.pipeline.choices);
  const int code = report(diagnostics, source, options.messages);
  if (!model || code != k_ok) return code;
  const std::string name = options.pipeline.name.empty() ? model->name.text : options.pipeline.name;
  const std::string header = header_path(options, name);
  if (options.variants.empty() && !of_instances) {
    write_standard_output(header + "\n" + (options.split.empty() ? "" : source_path(header) + "\n"));
    return k_ok;
  }
  std::string list;
  for (const auto& variant : options.variants) list += header_path(options, name + "_" + variant.first) + "\n";
  write_standard_output(list + header_path(options, name + "_variants") + "\n");
  return k_ok;
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

/// What is wrong with a scene is said there; other words are those of an option.
template <class Generate>
int with_places(Input& input, Generate&& generate) {
  try {
    return generate(input);
  } catch (const WrongScene& wrong) {
    return report(wrong.found(), *input.scene, input.options.messages);
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
      return list_outputs(in.options, in.source, is_of_instances(in));
    }
    if (is_of_instances(in)) return generate_instances(in);
    return in.options.variants.empty() ? generate_header(in) : generate_variants(in);
  });
}

}  // namespace gaussgen::cli
