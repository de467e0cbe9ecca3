#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "artefacts.hpp"
#include "cli/arguments.hpp"
#include "cli/exit_codes.hpp"
#include "cli/help.hpp"
#include "cli/usage_error.hpp"
#include "support/suggest.hpp"
#include "version.hpp"

namespace gaussgen::cli {

namespace {

constexpr int k_most_digits = 10000;
[[noreturn]] void refuse(const std::string& option, const std::string& why) { throw UsageError(option + ": " + why); }

/// One argument per flag, so that a list never takes the model for one of its words.
CLI::Option* one_each(CLI::Option* option, const std::string& text) {
  return option->option_text(text)->type_name(text)->allow_extra_args(false)->take_all();
}

void add_list(CLI::App& app, const std::string& name, std::vector<std::string>& target,
              const std::vector<std::string>& choices, const std::string& text, const std::string& about) {
  const auto take = [&target, choices, name](const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const std::string refusal = refusal_of_choice(word, choices);
      if (!refusal.empty()) refuse(name, refusal);
      target.push_back(word);
    }
  };
  one_each(app.add_option_function<std::vector<std::string>>(name, take, wrapped(about + support::joined(choices))),
           text)
      ->delimiter(',');
}

template <class Choice>
void add_choice(CLI::App& app, const std::string& name, Choice& target,
                const std::vector<std::pair<std::string, Choice>>& choices, const std::string& text,
                const std::string& about) {
  const auto take = [&target, choices, name](const std::string& word) {
    std::vector<std::string> words;
    for (const auto& [choice, value] : choices) {
      words.push_back(choice);
      if (choice == word) target = value;
    }
    const std::string refusal = refusal_of_choice(word, words);
    if (!refusal.empty()) refuse(name, refusal);
  };
  app.add_option_function<std::string>(name, take, about)->type_name(text);
}

void add_model(CLI::App& app, Options& options) { app.add_option("model", options.model); }

std::vector<std::string> output_names() {
  std::vector<std::string> names;
  for (const OutputKind& kind : output_kinds()) names.push_back(kind.name);
  return names;
}

void add_generate(CLI::App& app, Options& options) {
  add_model(app, options);
  app.add_option("-o,--output", options.output, "folder for <name>.hpp, or - for standard output")->type_name("DIR");
  app.add_flag("--check", options.check, "write nothing, only say whether the model is right");
  app.add_flag("--list-outputs", options.list_outputs, "write nothing, only say which header would be written");
  app.add_option("--depfile", options.depfile, "also write what the header depends on, for make and Ninja")
      ->type_name("FILE");
  app.add_option("--namespace", options.pipeline.name_space, "C++ namespace instead of gauss::<name>")
      ->type_name("NAME");
  add_list(app, "--outputs", options.pipeline.outputs, output_names(), "LIST",
           "functions to emit instead of all, with commas between: ");
  app.add_flag("--fold", options.pipeline.fold, "put the parameters in as numbers");
  app.add_flag("--assemble", options.pipeline.assemble,
               wrapped("let the constraints move the initial values that the model gives, and say how far"));
  add_choice<Route>(app, "--route", options.pipeline.route, {{"emitted", Route::emitted}, {"paper", Route::paper}},
                    "ROUTE", wrapped("emitted (default), or paper: its Z, Gamma and (3.7)-(3.8), term by term"));
  add_list(app, "--dump", options.dumps, stage_names(), "STAGE", "write nothing, print what comes out of a stage: ");
  app.add_flag("--timings", options.timings, "say on standard error what each stage took");
}

void add_evaluate(CLI::App& app, Options& options) {
  add_model(app, options);
  one_each(app.add_option("--set", options.overrides,
                          wrapped("change a parameter, an input, a coordinate or a rate, such as "
                                  "m=2, chi=pi/4 or 'dot(chi)=2'; may be repeated")),
           "NAME=VALUE");
  app.add_option("--time", options.time, "time, default 0")->type_name("T");
  app.add_option_function<int>(
         "--digits",
         [&options](int digits) {
           if (digits < 1 || digits > k_most_digits)
             refuse("--digits", fmt::format("a number from 1 to {} is needed", k_most_digits));
           options.digits = digits;
         },
         "significant digits, default 17")
      ->type_name("N");
  add_choice<Format>(app, "--format", options.format, {{"table", Format::table}, {"json", Format::json}}, "FORMAT",
                     "table (default) or json");
}

void add_derivation(CLI::App& app, Options& options) {
  add_model(app, options);
  app.add_option("-o,--output", options.output, "file instead of standard output")->type_name("FILE");
  add_choice<Format>(app, "--format", options.format, {{"markdown", Format::markdown}, {"latex", Format::latex}},
                     "FORMAT", "markdown (default) or latex");
}

/// The parser takes a word that is no command for the model.
void refuse_misspelt_command(const CLI::App& app, const std::string& model) {
  std::error_code error;
  if (std::filesystem::exists(model, error)) return;
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  const std::string near = support::did_you_mean(model, commands);
  if (!near.empty()) throw UsageError("there is no command or file '" + model + "'; " + near);
}

// What stands before the name of a command belongs to generation, and would be forgotten.
void refuse_mixture(const CLI::App& app, const CLI::App& command) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    if (!option->nonpositional()) throw UsageError("the model goes after '" + command.get_name() + "'");
    refuse(option->get_name(), "does not go before '" + command.get_name() + "', which has options of its own");
  }
}

void check_output(const Options& options) {
  const std::string refusal = options.command == Command::generate ? refusal_of_folder(options.output) : "";
  if (!refusal.empty()) refuse("-o", refusal);
}

void check(const CLI::App& app, const Options& options) {
  check_output(options);
  if (options.model.empty()) throw UsageError("a model file is needed; - stands for standard input");
  const CLI::Option* name_space = app.get_option("--namespace");
  const std::string refusal = name_space->count() == 0 ? "" : refusal_of_namespace(options.pipeline.name_space);
  if (!refusal.empty()) refuse("--namespace", refusal);
  if (app.count("--depfile") != 0 && options.depfile.empty()) refuse("--depfile", "a file name is needed");
  if (app.count("--depfile") != 0 && options.output == "-")
    refuse("--depfile", "there is no file to depend on with -o -");
}

std::optional<Options> parse(CLI::App& app, int argc, const char* const* argv, int& exit_code) {
  Options options;
  app.set_version_flag("--version", std::string("gauss-gen ") + k_version, "print the version");
  app.set_help_flag("-h,--help", "print this page");
  write_help_by(app);
  add_generate(app, options);
  // Added after the help flag and the formatter, which they inherit; the footer of the page is for the program as a whole.
  CLI::App* evaluate = app.add_subcommand("evaluate", k_about_evaluate)->footer(k_about_status);
  add_evaluate(*evaluate, options);
  CLI::App* derivation = app.add_subcommand("derivation", k_about_derivation)->footer("");
  add_derivation(*derivation, options);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    exit_code = app.exit(request);
    return std::nullopt;
  } catch (const CLI::ExtrasError&) {
    refuse_misspelt_command(app, options.model);
    throw;
  }
  if (app.get_subcommands().empty()) refuse_misspelt_command(app, options.model);
  for (const CLI::App* command : {evaluate, derivation}) {
    if (command->parsed()) refuse_mixture(app, *command);
  }
  if (evaluate->parsed()) options.command = Command::evaluate;
  if (derivation->parsed()) options.command = Command::derivation;
  if (derivation->parsed() && options.format == Format::table) options.format = Format::markdown;
  check(app, options);
  return options;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code) {
  CLI::App app(k_about, "gauss-gen");
  std::string refusal;
  try {
    return parse(app, argc, argv, exit_code);
  } catch (const CLI::ParseError& error) {
    refusal = error.what();
  } catch (const UsageError& error) {
    refusal = error.what();
  }
  std::cerr << "gauss-gen: " << refusal << "\nRun gauss-gen --help for the options.\n";
  exit_code = k_usage_error;
  return std::nullopt;
}

}  // namespace gaussgen::cli
