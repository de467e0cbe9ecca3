#include "cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "cli/arguments.hpp"
#include "cli/command_line.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/usage_error.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

/// What other programs call what is here an option or a command.
std::string in_our_words(const std::string& word) {
  if (word == "check" || word == "validate" || word == "lint") return "did you mean '--check'?";
  if (word == "eval" || word == "run" || word == "solve") return "did you mean 'evaluate'?";
  if (word == "linearise" || word == "linear" || word == "eigenvalues" || word == "modes")
    return "did you mean 'linearize'?";
  if (word == "derive") return "did you mean 'derivation'?";
  if (word == "new" || word == "create") return "did you mean 'init'?";
  if (word == "generate" || word == "gen" || word == "compile" || word == "build")
    return "a header is written without a command: gauss-gen MODEL";
  return "";
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The parser takes a word that is no command for the model.
void refuse_misspelt_command(const CLI::App& app, const std::string& model) {
  std::error_code error;
  if (std::filesystem::exists(model, error)) return;
  std::string near = support::did_you_mean(model, command_names(app));
  if (near.empty()) near = in_our_words(model);
  if (!near.empty()) throw UsageError("there is no command or file '" + model + "'; " + near);
}

/// A word before the model that is no file and looks like none.
void refuse_unknown_command(const CLI::App& app, const std::string& model) {
  std::error_code error;
  const std::vector<std::string> rest = app.remaining();
  const bool are_words = !rest.empty() && rest.front().rfind("-", 0) != 0;
  if (!are_words || model.find_first_of("./\\") != std::string::npos || std::filesystem::exists(model, error)) return;
  throw UsageError(
      fmt::format("there is no command or file '{}'; the commands are {}", model, support::joined(command_names(app))));
}

// What stands before the name of a command belongs to generation, and would be forgotten.
void refuse_mixture(const CLI::App& app, const CLI::App& command) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    if (!option->nonpositional()) throw UsageError("the model goes after '" + command.get_name() + "'");
    refuse(option->get_name(), "does not go before '" + command.get_name() + "', which has options of its own");
  }
}

/// A variable of a shell script that is not set, as in -o "$FOLDER": it is not the same as nothing at all.
void refuse_empty_words(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& words = option->results();
    if (std::find(words.begin(), words.end(), "") == words.end()) continue;
    refuse(option->nonpositional() ? option->get_name() : app.get_name(), "what is given for it is empty");
  }
}

void check_output(const Options& options) {
  const std::string refusal = options.command == Command::generate ? refusal_of_folder(options.output) : "";
  if (!refusal.empty()) refuse("-o", refusal);
}

bool reads_model(const Options& options) {
  const Command command = options.command;
  return (command == Command::generate && !options.man) || command == Command::evaluate ||
         command == Command::linearize || command == Command::derivation;
}

void check(const CLI::App& app, const Options& options) {
  if (!reads_model(options)) return;
  check_output(options);
  if (options.model.empty()) throw UsageError("a model file is needed; - stands for standard input");
  const CLI::Option* name_space = app.get_option("--namespace");
  const std::string refusal = name_space->count() == 0 ? "" : refusal_of_namespace(options.pipeline.name_space);
  if (!refusal.empty()) refuse("--namespace", refusal);
  if (options.pipeline.fold && !options.pipeline.sensitivities.empty())
    refuse("--sensitivities", "with --fold parameters are numbers; leave one of the two out");
  if (options.pipeline.route == Route::paper && options.pipeline.strategy != Strategy::automatic)
    refuse("--strategy", "the paper's route has one way, (3.7)-(3.8); leave one of the two out");
  if (!options.split.empty() && options.output == "-") refuse("--split", "it writes two files; name a folder by -o");
  if (!options.variants.empty() && !options.pipeline.choices.effects.empty())
    refuse("--variant", "each has its own effects; leave --effects out");
  if (!options.variants.empty() && (options.output == "-" || !options.split.empty() || !options.dumps.empty()))
    refuse("--variant", "it writes headers, and goes with none of -o -, --split and --dump");
  if (app.count("--depfile") != 0 && options.depfile.empty()) refuse("--depfile", "a file name is needed");
  if (app.count("--depfile-target") != 0 && (options.depfile.empty() || options.depfile_target.empty()))
    refuse("--depfile-target", "it is a word in the file of --depfile");
  if (app.count("--depfile") != 0 && options.output == "-")
    refuse("--depfile", "there is no file to depend on with -o -");
}

bool has(const std::string& message, const char* part) { return message.find(part) != std::string::npos; }

/// In place of the words of the parser: `--check=no`, `-o a -o b`, and -o at the end.
void refuse_mismatch(const std::string& message) {
  if (has(message, "flag override"))
    refuse("--" + message.substr(0, message.find(' ')), "it takes no value; leave it out to say no");
  const std::string option = message.substr(0, message.find(':'));
  if (has(message, "At Most 1")) refuse(option, "it is given more than once");
  if (has(message, "missing")) refuse(option, "a value is missing behind it");
}

const CLI::App& chosen(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

bool has_option(const CLI::App& app, const std::string& word) {
  return app.get_option_no_throw(word) != nullptr && !app.get_option_no_throw(word)->get_positional();
}

void refuse_unknown_option(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  for (const CLI::App* command : app.get_subcommands({})) {
    if (has_option(*command, name))
      throw UsageError(fmt::format("'{}' is an option of {}, and goes after that word", name, command->get_name()));
  }
  if (has_option(app, name)) throw UsageError(fmt::format("'{}' is no option of this command", name));
  std::vector<std::string> known;
  for (const CLI::Option* option : chosen(app).get_options()) {
    if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
  }
  const std::string near = support::did_you_mean(name, known);
  throw UsageError(fmt::format("there is no option '{}'{}{}", name, near.empty() ? "" : "; ", near));
}

/// The parser keeps the words that it does not take in another order.
[[noreturn]] void refuse_rest(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<std::string> rest = app.remaining(true);
  std::vector<std::string> in_order;
  for (int i = 1; i < argc; ++i) {
    const auto found = std::find(rest.begin(), rest.end(), argv[i]);
    if (found == rest.end()) continue;
    in_order.push_back("'" + *found + "'");
    if (found->size() > 1 && found->front() == '-' && *found != "--") refuse_unknown_option(app, *found);
    rest.erase(found);
  }
  throw UsageError("not expected here: " + support::joined(in_order));
}

std::optional<Options> parse(int argc, const char* const* argv, int& exit_code) {
  Options options;
  CommandLine line(options);
  CLI::App& app = line.app;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    std::ostringstream page;
    exit_code = app.exit(request, page);
    write_standard_output(page.str());
    return std::nullopt;
  } catch (const CLI::ArgumentMismatch& error) {
    refuse_mismatch(error.what());
    throw;
  } catch (const CLI::ExtrasError&) {
    refuse_misspelt_command(app, options.model);
    refuse_unknown_command(app, options.model);
    refuse_rest(app, argc, argv);
  }
  if (app.get_subcommands().empty()) refuse_misspelt_command(app, options.model);
  for (const auto& [name, command] : line.commands) {
    const CLI::App* const parsed = app.get_subcommand(name);
    if (!parsed->parsed()) continue;
    refuse_mixture(app, *parsed);
    options.command = command;
  }
  if (options.command == Command::derivation && options.format == Format::table) options.format = Format::markdown;
  check(app, options);
  options.pipeline.compiled_for = options.split;
  for (std::string& type : options.pipeline.compiled_for) std::replace(type.begin(), type.end(), '-', ' ');
  refuse_empty_words(app);
  for (const CLI::App* command : app.get_subcommands()) refuse_empty_words(*command);
  return options;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code) {
  std::string refusal;
  try {
    return parse(argc, argv, exit_code);
  } catch (const FileError& error) {
    exit_code = fail(error.what(), k_file_error, messages_of(argc, argv));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    refusal = error.what();
  } catch (const UsageError& error) {
    refusal = error.what();
  }
  exit_code = fail(refusal, k_usage_error, messages_of(argc, argv), "Run gauss-gen --help for the options.");
  return std::nullopt;
}

}  // namespace gaussgen::cli
