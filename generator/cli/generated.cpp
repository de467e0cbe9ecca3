#include "cli/generated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "cli/replacement.hpp"
#include "cli/timings.hpp"
#include "cli/usage_error.hpp"

namespace gaussgen::cli {

namespace {

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

/// Of those that are to be printed; none where the header is wanted.
std::string last_stage(const std::vector<std::string>& dumps) {
  std::string last;
  for (const std::string& stage : stage_names()) {
    if (std::find(dumps.begin(), dumps.end(), stage) != dumps.end()) last = stage;
  }
  return last;
}

}  // namespace

std::string header_path(const Options& options, const std::string& model_name) {
  const std::string file = model_name + ".hpp";
  if (options.output.empty() || options.output == "-") return options.output == "-" ? "-" : file;
  return options.output.back() == '/' ? options.output + file : options.output + "/" + file;
}

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

std::vector<std::string> guards_of(const emit::Unit& unit) {
  std::vector<std::string> names;
  for (const emit::Artefact& one : unit.artefacts) {
    if (one.name != "guards") continue;
    for (const emit::Field& field : one.groups.front().fields) names.push_back(field.name);
  }
  return names;
}

}  // namespace gaussgen::cli
