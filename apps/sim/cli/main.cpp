#include <CLI/CLI.hpp>
#include <clocale>
#include <csignal>
#include <locale>
#include <new>

#include "cli/assignments.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "cli/overrides.hpp"
#include "ir/graph.hpp"
#include "sim/advise/advise.hpp"
#include "sim/advise/search.hpp"
#include "sim/cli/list_methods.hpp"
#include "sim/cli/message_options.hpp"
#include "sim/cli/shell.hpp"
#include "sim/cli/validators.hpp"
#include "sim/effects/effects.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/plot/plot.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/run.hpp"
#include "sim/scene/choices.hpp"
#include "sim/scene/ensemble.hpp"
#include "sim/study/study.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

CLI::Option* add_instance(CLI::App* command, std::string& instance) {
  return command->add_option("--instance", instance, "one of the scene's instances, as if the scene were that one")
      ->type_name("NAME");
}

/// Of what is simulated and how, whatever is made of it.
void add_setting(CLI::App* command, RunOptions& options) {
  add_instance(command, options.instance);
  command->add_option("--set", options.sets, "another value for a parameter, an input or the start, such as m=2")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--count", options.counts, "another size than that of the file, such as n=50")
      ->type_name("NAME=N")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--effects", options.effects,
                   "which effects of the model act: all, none, default or names, with commas between; with + and - in "
                   "front beside the default, as in --effects=-drag")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  command->add_option("--outputs", options.outputs, "columns of the table, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  command->add_option("--method", options.method, "how to integrate")->check(one_of(method_names()))->type_name("NAME");
  command->add_option("--number", options.number, "number type")->check(one_of(number_names()))->type_name("TYPE");
  command->add_option("--projection", options.projection, "onto the constraints after each step")
      ->check(one_of(projection_names()))
      ->type_name("WHAT");
  command->add_option("--strategy", options.strategy, "how Z is minimised, as in gauss-gen")
      ->check(one_of(strategy_names()))
      ->type_name("NAME");
  command->add_option("--code", options.code, "how equations are written out")
      ->check(one_of(code_names()))
      ->type_name("HOW");
  command->add_option("--engine", options.engine, "how functions are executed")
      ->check(one_of(engine_names()))
      ->type_name("NAME");
  command->add_option("--start", options.start, "time of the initial state, default 0")->type_name("T");
  command->add_option("--duration", options.duration, "default 10")->type_name("T");
  command->add_option("--samples", options.samples, "rows of the table, default 501")
      ->type_name("N")
      ->check(CLI::Range(2L, 100'000'000L));
  command->add_option("--every", options.every, "time between rows, instead of their number")
      ->type_name("T")
      ->excludes("--samples");
  command
      ->add_option("--tolerance", options.tolerance,
                   "error of a step, relative to the size of each component; default 1e-9")
      ->type_name("E")
      ->check(positive());
  command
      ->add_option("--step", options.step,
                   "length of steps, of methods that take one; default: a 10000th of the duration")
      ->type_name("T")
      ->check(positive());
  command
      ->add_option("--longest-step", options.longest_step,
                   "no step is longer: for what acts for a time that steps would pass over")
      ->type_name("T")
      ->check(positive());
  command->add_flag("-q,--quiet", options.quiet, "say nothing but errors and warnings");
}

/// What a search for a setting finds.
constexpr const char* k_found_by_search[] = {"--tolerance", "--step"};

CLI::Option* add_error(CLI::App* command, RunOptions& options, const char* text) {
  command
      ->add_option("--budget", options.budget,
                   "seconds of the search for a setting that delivers an error, with what it compiles; equations "
                   "before it, and the run after it, come on top; default 600")
      ->type_name("S")
      ->check(positive());
  CLI::Option* const error = command->add_option("--error", options.error, text)->type_name("E")->check(share());
  for (const char* const found : k_found_by_search) {
    if (CLI::Option* const given = command->get_option_no_throw(found)) error->excludes(given);
  }
  return error;
}

void add_run(CLI::App& app, RunOptions& options) {
  CLI::App* const run =
      app.add_subcommand("run", "Simulate a scene, or a model from its initial state, and write a table");
  run->add_option("FILE", options.file, "scene or model")->required();
  run->add_option("-o,--output", options.output, "table to write, or - for standard output; default <name>.csv")
      ->type_name("CSV");
  add_setting(run, options);
  add_error(run, options,
            "largest error of all columns, relative to their ranges: finds a method and a tolerance that deliver it");
  run->add_option("--max-steps", options.max_steps, "no more steps than this, default 100000000; the table ends there")
      ->type_name("N")
      ->check(CLI::Range(1L, 1'000'000'000'000L));
  run->add_flag("--resume", options.resume, "go on from the table and the summary that an interrupted run has left");
  add_messages(*run, options.messages);
}

void add_ensemble(CLI::App& app, EnsembleOptions& options) {
  CLI::App* const command = app.add_subcommand(
      "ensemble",
      "Simulate a scene for many values of parameters and of the start, and write a table with a row for each");
  command->add_option("FILE", options.file, "scene with the key 'ensemble'")->required();
  command
      ->add_option("-o,--output", options.output,
                   "table to write, or - for standard output; default <name>.ensemble.csv")
      ->type_name("CSV");
  command->add_option("--trajectories", options.trajectories, "how many, for each point of the sweeps")
      ->type_name("N")
      ->check(CLI::Range(1L, k_most_trajectories));
  command->add_option("--seed", options.seed, "of what is drawn, default 0")
      ->type_name("N")
      ->check(CLI::Range(0L, k_largest_seed));
  command->add_option("--threads", options.threads, "default: one for each processor; they change no result")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--lanes", options.lanes,
                   "trajectories that a thread integrates together: auto, 1, or what the processor has; results "
                   "change within the tolerance")
      ->type_name("N")
      ->check([](const std::string& text) {
        const bool is_word =
            text == "auto" || (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos);
        return is_word && text.front() != '0' ? std::string() : "expected auto or a number above 0, not '" + text + "'";
      });
  command->add_flag("--every-sample", options.records_samples, "a row for each trajectory and sample");
  add_setting(command, options);
  add_messages(*command, options.messages);
}

void add_study(CLI::App& app, StudyOptions& options) {
  CLI::App* const study =
      app.add_subcommand("study", "Try all settings, and show what accuracy costs in time: tables and a page");
  study->add_option("FILE", options.files, "scenes or models, a problem each")->required();
  study
      ->add_option("-o,--output", options.output,
                   "path of what is written, to which .json, .csv and .html are added; default study")
      ->type_name("PATH");
  study
      ->add_option("--methods", options.methods,
                   "these methods alone, of the scene as it is, in double, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of({method_names().begin() + 1, method_names().end()}))
      ->type_name("LIST");
  study
      ->add_option(
          "--budget", options.budget,
          "seconds of the runs that are compared, for each problem; equations, compiling, the reference and what is "
          "shown beside them come on top; default 60")
      ->type_name("S")
      ->check(positive());
  add_instance(study, options.instance);
  study->add_option("--loosest", options.loosest, "first tolerance, default 1e-3")->type_name("E")->check(positive());
  study
      ->add_option("--tightest", options.tightest,
                   "last tolerance, default 1e-13, and that of rounding for default methods")
      ->type_name("E")
      ->check(positive());
  add_messages(*study, options.messages);
  study->add_flag("-q,--quiet", options.quiet, "say nothing but errors and warnings");
}

void add_advise(CLI::App& app, AdviseOptions& options) {
  CLI::App* const advise =
      app.add_subcommand("advise", "Find the cheapest setting that delivers an error, for pasting into a scene");
  advise->add_option("FILE", options.file, "scene or model")->required();
  add_setting(advise, options);
  for (const char* const found : k_found_by_search) advise->remove_option(advise->get_option(found));
  add_error(advise, options, "largest error of all outputs, relative to their ranges")->required();
  advise->add_option("--study", options.study, "take it from this study (JSON) instead of trying now")
      ->type_name("FILE");
  advise->add_option("--format", options.format, "default text")->check(one_of({"text", "json"}))->type_name("FORMAT");
  add_messages(*advise, options.messages);
}

void add_effects(CLI::App& app, EffectsOptions& options) {
  CLI::App* const command = app.add_subcommand(
      "effects", "Show what each effect of a scene costs and changes, and which a wanted accuracy needs");
  command->add_option("FILE", options.file, "scene or model")->required();
  command
      ->add_option("-o,--output", options.output,
                   "path of what is written, to which .json and .svg are added; default <name>.effects")
      ->type_name("PATH");
  command->add_flag("--html", options.writes_page, "write a page, too, as that of a study");
  add_setting(command, options);
  command
      ->add_option(
          "--need", options.need,
          "largest change of all outputs, relative to their ranges: names the effects that it needs, and writes "
          "a scene with these alone, FILE.lean.yaml")
      ->type_name("E")
      ->check(share());
  add_messages(*command, options.messages);
}

void add_plot(CLI::App& app, PlotOptions& options) {
  CLI::App* const plot = app.add_subcommand("plot", "Draw the columns of a table as a picture: a panel for each unit");
  plot->add_option("CSV", options.file, "table that a run has written, or - for standard input")->required();
  plot->add_option("-o,--output", options.output, "SVG to write, or - for standard output; default beside the table")
      ->type_name("SVG");
  plot->add_option("--columns", options.columns, "what to draw, with commas between; default all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  plot->add_option("--against", options.against, "column along the lower edge; default the first one, which is time")
      ->type_name("NAME");
  add_messages(*plot, options.messages);
}

struct ListOptions {
  CLI::App* command = nullptr;
  std::string format = "text";
};

void add_methods(CLI::App& app, ListOptions& options) {
  options.command = app.add_subcommand("methods", "List the methods of integration: order, library, what they need");
  options.command->add_option("--format", options.format, "default text")
      ->check(one_of({"text", "json"}))
      ->type_name("FORMAT");
}

int run_for_errors(const RunOptions& options) { return run(options, find_setting); }

struct ShellOptions {
  CLI::App* command = nullptr;
  std::string shell;
  bool man = false;
};

void add_shell(CLI::App& app, ShellOptions& options) {
  app.add_flag("--man", options.man, "print the manual page, for 'man -l -'");
  options.command = app.add_subcommand("completion", "Write a script with which a shell completes command lines");
  options.command->add_option("SHELL", options.shell, "bash, zsh or fish")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
}

struct Printed {
  std::string text;
  cli::MessageOptions messages;
};

int print(const Printed& what) {
  cli::write_standard_output(what.text);
  return cli::k_ok;
}

template <class Options>
int guarded(int (*command)(const Options&), const Options& options) {
  try {
    return command(options);
  } catch (const cli::FileError& error) {
    return cli::fail(error.what(), cli::k_file_error, options.messages);
  } catch (const cli::UsageError& error) {
    return cli::fail(error, options.messages);
  } catch (const Interrupted&) {
    cli::remark("interrupted; nothing is written", options.messages);
    return cli::k_interrupted;
  } catch (const OutOfTime&) {
    return cli::fail("the model was not compiled in the time that there is; --budget gives it more",
                     cli::k_not_delivered, options.messages);
  } catch (const gaussgen::model::UnknownCount& unknown) {
    return cli::fail(cli::unknown_count(unknown), cli::k_usage_error, options.messages);
  } catch (const gaussgen::ir::TooManyNodes& error) {
    return cli::fail(std::string("the model is too large: ") + error.what(), cli::k_too_large, options.messages);
  } catch (const std::bad_alloc&) {
    return cli::fail("the model is too large for the memory of this machine", cli::k_too_large, options.messages);
  } catch (const std::exception& error) {
    return cli::fail(std::string("internal error, please report it with the model: ") + error.what(),
                     cli::k_internal_error, options.messages);
  }
}

}  // namespace

}  // namespace gausssim

int main(int argc, char** argv) {
  std::setlocale(LC_ALL, "C");
  std::locale::global(std::locale::classic());
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Simulates mechanical models: motions, reactions, and what accuracy costs in time", "gauss-sim");
  app.set_version_flag("--version", std::string("gauss-sim ") + gaussgen::k_version);
  app.require_subcommand(0, 1);
  gausssim::RunOptions options;
  options.messages.program = "gauss-sim";
  gausssim::StudyOptions study;
  study.messages.program = options.messages.program;
  gausssim::AdviseOptions advice;
  advice.messages.program = options.messages.program;
  gausssim::add_run(app, options);
  gausssim::add_advise(app, advice);
  gausssim::add_study(app, study);
  gausssim::EnsembleOptions ensemble;
  ensemble.messages.program = options.messages.program;
  gausssim::add_ensemble(app, ensemble);
  gausssim::EffectsOptions effects;
  effects.messages.program = options.messages.program;
  gausssim::add_effects(app, effects);
  gausssim::PlotOptions plot;
  plot.messages.program = options.messages.program;
  gausssim::add_plot(app, plot);
  gausssim::ListOptions listing;
  gausssim::add_methods(app, listing);
  gausssim::ShellOptions shell;
  gausssim::add_shell(app, shell);
  try {
    app.parse(argc, argv);
    if (!shell.man && app.get_subcommands().size() != 1) throw CLI::RequiredError::Subcommand(1);
  } catch (const CLI::Success& request) {  // --help, --version
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    const auto messages = gaussgen::cli::messages_of(argc, argv, "gauss-sim");
    return gaussgen::cli::fail(error.what(), gaussgen::cli::k_usage_error, messages,
                               "Run gauss-sim --help for the options.");
  }
  if (shell.man)
    return gausssim::guarded<gausssim::Printed>(gausssim::print, {gausssim::manual_of(app), options.messages});
  if (*shell.command)
    return gausssim::guarded<gausssim::Printed>(gausssim::print,
                                                {gausssim::completion_of(app, shell.shell), options.messages});
  if (*listing.command)
    return gausssim::guarded<gausssim::Printed>(gausssim::print,
                                                {gausssim::listed_methods(listing.format == "json"), options.messages});
  if (app.got_subcommand("ensemble")) return gausssim::guarded(gausssim::ensemble, ensemble);
  if (app.got_subcommand("effects")) return gausssim::guarded(gausssim::effects, effects);
  if (app.got_subcommand("plot")) return gausssim::guarded(gausssim::draw_plot, plot);
  if (app.got_subcommand("study")) return gausssim::guarded(gausssim::study, study);
  if (app.got_subcommand("advise")) return gausssim::guarded(gausssim::advise, advice);
  return gausssim::guarded(gausssim::run_for_errors, options);
}
