#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "cli/replacement.hpp"
#include "cli/timings.hpp"
#include "read_model.hpp"

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

std::string dependencies(const std::string& target, const Options& options, const support::Source& source) {
  std::string line = for_make(target) + ":";
  std::vector<std::string> files = source.names();
  if (options.model == "-") files.erase(files.begin());
  for (const std::string& file : files) line += " " + for_make(file);
  return line + "\n";
}

// All are written before the first is put in place: a full disk leaves everything as it was.
void write_files(const Options& options, const PipelineResult& result, const support::Source& source) {
  const std::string path = header_path(options, result.model_name);
  std::vector<std::pair<std::string, std::string>> files{{path, result.header}};
  if (!result.source.empty()) files.emplace_back(source_path(path), result.source);
  if (!options.depfile.empty()) {
    for (const auto& file : files) {
      if (are_same_file(options.depfile, file.first))
        fail_on(file.first, "it cannot be both the header and the depfile");
    }
    const std::string& target = options.depfile_target.empty() ? path : options.depfile_target;
    files.emplace_back(options.depfile, dependencies(target, options, source));
  }
  for (const auto& file : files) keep_what_was_read(file.first, source);
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
int check_or_list(const Options& options, support::Source& source) {
  support::Diagnostics diagnostics;
  const auto model = read_model(source, diagnostics, options.pipeline.choices);
  const int code = report(diagnostics, source, options.messages);
  if (!model || code != k_ok) return code;
  if (!options.list_outputs) return k_ok;
  const std::string header = header_path(options, model->name.text);
  write_standard_output(header + "\n" + (options.split.empty() ? "" : source_path(header) + "\n"));
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

int generate(const Options& options) {
  std::optional<ReadingGuard> guard(options.messages);
  support::Source source = read_source(options.model);
  if (options.list_outputs) return check_or_list(options, source);

  std::optional<DerivationGuard> derivation;
  std::string dumped;
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
  const auto result = compile(source, pipeline, diagnostics, observe);
  derivation.reset();  // before anything is written
  const int code = report(diagnostics, source, options.messages);
  if (!result || code != k_ok) {
    write_standard_output(dumped);
    return code;
  }
  if (options.timings) print_timings(*result, options.messages);
  for (const std::string& moved : result->assembled) remark("assembled " + moved, options.messages);
  if (!options.dumps.empty()) {
    write_standard_output(dumped);
    return k_ok;
  }
  if (options.check) {
    const char* const remark = result->has_units ? "" : " (it states no units, so none are checked)";
    const std::string mobility = result->mobility.empty() ? "" : ", " + result->mobility;
    write_standard_output(fmt::format("{}: ok{}{}\n", source.name(), mobility, remark));
    return k_ok;
  }
  if (options.output == "-") {
    write_standard_output(result->header);
    return k_ok;
  }
  write_files(options, *result, source);
  remark_on_size(*result, options.messages);
  return k_ok;
}

}  // namespace gaussgen::cli
