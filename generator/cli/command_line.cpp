#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "artefacts.hpp"
#include "cli/arguments.hpp"
#include "cli/assignments.hpp"
#include "cli/explanations.hpp"
#include "cli/help.hpp"
#include "cli/usage_error.hpp"
#include "support/suggest.hpp"
#include "version.hpp"

namespace gaussgen::cli {

namespace {

constexpr int k_most_digits = 10000;
constexpr int k_most_linear_digits = 17;  // of what eigenvalues are computed with
constexpr long long k_most_seconds = 1'000'000;
constexpr long long k_most_operations = 1'000'000'000;
constexpr long long k_most_nodes = 1'000'000'000;  // beyond that, no machine has the memory

/// Adds options to one command.
class Adder {
 public:
  Adder(CommandLine& line, CLI::App& app, Options& options) : line_(line), app_(app), options_(options) {}

  void generate() {
    add_model();
    add_choices();
    const auto take_variants = [&options = options_](const std::vector<std::string>& assignments) {
      options.variants = parse_variants(assignments);
    };
    one_each(
        app_.add_option_function<std::vector<std::string>>(
            "--variant", take_variants,
            wrapped(
                "a set of effects by a name, such as far=gravity,air, or a regime, such as resting=floor=closed, or "
                "both; may be repeated for others: a header for each, and <name>_variants.hpp with a table from "
                "which a program chooses while it runs")),
        "NAME=LIST");
    app_.add_option("--instance", options_.instance,
                    wrapped("one of a scene's instances, as if the scene were that one; else <name>_variants.hpp has "
                            "all of them, with one set of functions for each set of effects"))
        ->type_name("NAME");
    add_path("-o,--output", options_.output, "folder for <name>.hpp, or - for standard output", "DIR",
             Argument::folder);
    add_flag("--check", options_.check, "write nothing, only say whether the model is right");
    add_flag("--list-outputs", options_.list_outputs, "write nothing, only say which header would be written");
    add_path("--depfile", options_.depfile, "also write what the header depends on, for make and Ninja", "FILE",
             Argument::file);
    app_.add_option("--depfile-target", options_.depfile_target,
                    wrapped("what depends on them there, instead of the header: a stamp, as a build tool may want"))
        ->type_name("NAME");
    app_.add_option("--namespace", options_.pipeline.name_space, "C++ namespace instead of gauss::<name>")
        ->type_name("NAME");
    add_list(
        "--outputs", options_.pipeline.outputs, output_names(), "LIST",
        "functions to emit instead of all but poses, inverse_dynamics, jacobian, sensitivities and taylor, with commas "
        "between: ");
    add_names("--sensitivities", options_.pipeline.sensitivities,
              "parameters by which derivatives of rhs and of reactions are emitted, with commas between");
    add_flag("--fold", options_.pipeline.fold, "put the parameters in as numbers");
    add_flag("--no-optimise", options_.pipeline.plain,
             wrapped("emit values as they were derived, in more operations: to see what rewriting them is worth"));
    add_list("--as-written", options_.pipeline.as_written, rules_for_digits(), "LIST",
             "sums and products that are emitted as they are written, though they may lose digits then, with commas "
             "between: ");
    add_assemble();
    add_choice<Route>("--route", options_.pipeline.route, {{"emitted", Route::emitted}, {"paper", Route::paper}},
                      "ROUTE", "emitted (default), or paper: its Z, Gamma and (3.7)-(3.8), term by term");
    std::vector<std::pair<std::string, Strategy>> strategies;
    for (const Strategy one : {Strategy::automatic, Strategy::tree, Strategy::metric, Strategy::multipliers}) {
      strategies.emplace_back(name_of(one), one);
    }
    add_choice<Strategy>("--strategy", options_.pipeline.strategy, strategies, "STRATEGY",
                         "how Z is minimised: auto (default) takes the fewest operations that keep their digits; tree: "
                         "body by body; metric: "
                         "over all speeds at once, "
                         "eliminating dependent ones where that is safe; multipliers: likewise, but by (3.4)");
    const auto take_parts = [&options = options_](const std::string& operations) {
      options.pipeline.part_operations = static_cast<int>(number_of("--parts", operations, k_most_operations));
    };
    app_.add_option_function<std::string>(
            "--parts", take_parts,
            wrapped(fmt::format(
                "operations in each part of a function that has more than twice as many, and takes compilers "
                "long in one piece; default {}",
                emit::k_part_operations)))
        ->type_name("N");
    add_list(
        "--split", options_.split, {"float", "double", "long-double"}, "LIST",
        "also write <name>.cpp, which compiles the functions for these types, so that what includes the header does "
        "not: ");
    const auto take_nodes = [&options = options_](const std::string& nodes) {
      options.pipeline.most_nodes = static_cast<std::size_t>(number_of("--max-nodes", nodes, k_most_nodes));
    };
    app_.add_option_function<std::string>(
            "--max-nodes", take_nodes,
            wrapped(fmt::format("stop, with exit code 4, when the derivation has more nodes; default {}",
                                ir::k_most_nodes)))
        ->type_name("N");
    add_max_seconds();
    add_list("--dump", options_.dumps, stages_with_dump(), "STAGE", "write nothing, print what comes out of a stage: ");
    add_flag("--timings", options_.timings,
             wrapped("say on standard error what each stage took, and what each pass saved"));
    add_messages();
  }

  void evaluate() {
    add_model();
    add_choices();
    add_set();
    add_assemble();
    add_flag("--equilibrium", options_.at_equilibrium,
             wrapped("go from the initial position to one at which the model stays at rest, and evaluate there"));
    one_each(app_.add_option("--accelerate", options_.accelerations,
                             wrapped("show the forces and inputs that make this acceleration, such as theta=2; may be "
                                     "repeated for others, and those not named are 0")),
             "NAME=A");
    add_time();
    const auto take_digits = [&options = options_](const std::string& digits) {
      options.digits = static_cast<int>(number_of("--digits", digits, k_most_digits));
    };
    app_.add_option_function<std::string>("--digits", take_digits, "significant digits, default 17")->type_name("N");
    add_format_of_numbers();
    add_max_seconds();
    add_messages();
  }

  void linearize() {
    add_model();
    add_choices();
    add_choice<LinearisedAt>("--at", options_.linearised_at,
                             {{"initial", LinearisedAt::initial},
                              {"equilibrium", LinearisedAt::equilibrium},
                              {"steady", LinearisedAt::steady}},
                             "MOTION",
                             "near the initial state as it is (default), an equilibrium found from there, or a steady "
                             "motion: speeds are constant, and only coordinates move on which nothing depends; what "
                             "--set gives stays as it is then");
    add_set();
    add_assemble();
    add_time();
    const auto take_digits = [&options = options_](const std::string& digits) {
      options.linear_digits = static_cast<int>(number_of("--digits", digits, k_most_linear_digits));
    };
    app_.add_option_function<std::string>("--digits", take_digits, "significant digits, default 6, in JSON 17")
        ->type_name("N");
    add_format_of_numbers();
    add_max_seconds();
    add_messages();
  }

  void derivation() {
    add_model();
    add_choices();
    add_path("-o,--output", options_.output, "file instead of standard output", "FILE", Argument::file);
    add_choice<Format>("--format", options_.format, {{"markdown", Format::markdown}, {"latex", Format::latex}},
                       "FORMAT", "markdown (default) or latex");
    add_max_seconds();
    add_messages();
  }

  void explain() {
    CLI::Option* const code = app_.add_option("code", options_.word, "code of a diagnostic")->type_name("[CODE]");
    for (const support::ErrorCode& known : all_codes()) line_.choices[code].emplace_back(known.id);
    add_choice<Format>("--format", options_.format, {{"text", Format::text}, {"markdown", Format::markdown}}, "FORMAT",
                       "text (default) or markdown; without a code, markdown is all pages");
  }

  void init() { app_.add_option("name", options_.word, "name of the model")->type_name("[NAME]"); }

  void completion() {
    CLI::Option* const shell = app_.add_option("shell", options_.word, "shell")->type_name("SHELL");
    line_.choices[shell] = shells();
  }

 private:
  void add_model() { line_.arguments[app_.add_option("model", options_.model)->type_name("MODEL")] = Argument::model; }

  /// What is chosen beside the file.
  void add_choices() {
    add_regime();
    const auto take = [&options = options_](const std::vector<std::string>& assignments) {
      options.pipeline.choices.counts = parse_counts(assignments);
    };
    one_each(app_.add_option_function<std::vector<std::string>>(
                 "--count", take,
                 wrapped("another size than that of the file: changes what stands under its 'counts', such as n=50; "
                         "may be repeated for others")),
             "NAME=N");
    add_names("--effects", options_.pipeline.choices.effects,
              "which effects of the model act: all, none or default (without the option), or names; with + and - in "
              "front, beside the default, as in --effects=-drag, or beside the first word, as in all,-drag");
  }

  void add_regime() {
    const auto take = [&options = options_](const std::vector<std::string>& assignments) {
      std::vector<std::string> modes;
      for (const std::string& one : assignments) {
        if (one == "ground")
          options.pipeline.choices.is_ground = true;
        else
          modes.push_back(one);
      }
      options.pipeline.choices.regime = parse_regime(modes);
    };
    one_each(
        app_.add_option_function<std::vector<std::string>>(
            "--regime", take,
            wrapped(
                "the mode of a contact (open, closed), of dry friction (sticks, slides; forwards, backwards along "
                "one direction) or of a constraint that may break (holds, broken), such as floor=closed; may be "
                "repeated for others, which are open, stick and hold without it. The word ground: contacts are open, "
                "and friction is left out; with impact_system")),
        "NAME=MODE");
  }

  void add_set() {
    one_each(app_.add_option("--set", options_.overrides,
                             wrapped("change a parameter, an input, a coordinate or a rate, such as "
                                     "m=2, chi=pi/4 or 'dot(chi)=2'; may be repeated")),
             "NAME=VALUE");
  }

  void add_time() { app_.add_option("--time", options_.time, "time, default 0")->type_name("T"); }

  void add_format_of_numbers() {
    add_choice<Format>("--format", options_.format, {{"table", Format::table}, {"json", Format::json}}, "FORMAT",
                       "table (default) or json");
  }

  void add_assemble() {
    add_flag("--assemble", options_.pipeline.assemble,
             wrapped("let the constraints move the initial values that the model gives, and say how far"));
  }

  void add_max_seconds() {
    const auto take_seconds = [&options = options_](const std::string& seconds) {
      options.most_seconds = static_cast<int>(number_of("--max-seconds", seconds, k_most_seconds));
    };
    app_.add_option_function<std::string>(
            "--max-seconds", take_seconds,
            wrapped("stop, with exit code 4, when the derivation takes more seconds of the processor; default: it may "
                    "take any"))
        ->type_name("N");
  }

  static long long number_of(const std::string& option, const std::string& text, long long most) {
    const auto number = whole_number(text, 1, most);
    if (!number) refuse(option, fmt::format("a number from 1 to {} is needed, not '{}'", most, text));
    return *number;
  }

  /// `--check=no` is refused, not taken for `--check`.
  CLI::Option* add_flag(const std::string& name, bool& target, const std::string& about) {
    return app_.add_flag(name, target, about)->disable_flag_override();
  }

  /// How messages look, in every command that reads a model.
  void add_messages() {
    add_choice<MessageFormat>("--diagnostics", options_.messages.format,
                              {{"text", MessageFormat::text}, {"json", MessageFormat::json}}, "FORMAT",
                              "messages on standard error: text (default), or json, an object in each line");
    add_choice<UseOfColour>(
        "--color", options_.messages.colour,
        {{"auto", UseOfColour::on_terminals}, {"always", UseOfColour::always}, {"never", UseOfColour::never}}, "WHEN",
        "auto (default: on a terminal, unless NO_COLOR is set), always or never");
  }

  void add_path(const std::string& names, std::string& target, const std::string& about, const std::string& text,
                Argument argument) {
    line_.arguments[app_.add_option(names, target, about)->type_name(text)] = argument;
  }

  /// One argument per flag, so that a list never takes the model for one of its words.
  static CLI::Option* one_each(CLI::Option* option, const std::string& text) {
    return option->option_text(text)->type_name(text)->allow_extra_args(false)->take_all();
  }

  void add_list(const std::string& name, std::vector<std::string>& target, const std::vector<std::string>& choices,
                const std::string& text, const std::string& about) {
    const auto take = [&target, choices, name](const std::vector<std::string>& lists) {
      for (const std::string& list : lists) {
        for (const std::string& word : words_of(list)) {
          const std::string refusal = refusal_of_word(word, list, choices);
          if (!refusal.empty()) refuse(name, refusal);
          target.push_back(word);
        }
      }
    };
    const std::string page = wrapped(about + support::joined(choices));
    CLI::Option* const option = app_.add_option_function<std::vector<std::string>>(name, take, page);
    one_each(option, text);
    line_.choices[option] = choices;
    line_.lists.insert(option);
  }

  void add_names(const std::string& name, std::vector<std::string>& target, const std::string& about) {
    const auto take = [&target, name](const std::vector<std::string>& lists) {
      for (const std::string& list : lists) {
        for (const std::string& word : words_of(list)) {
          if (word.empty()) refuse(name, fmt::format("a name is missing in '{}'", list));
          if (std::find(target.begin(), target.end(), word) != target.end())
            refuse(name, fmt::format("'{}' is given twice", word));
          target.push_back(word);
        }
      }
    };
    one_each(app_.add_option_function<std::vector<std::string>>(name, take, wrapped(about)), "LIST");
  }

  /// Empty ones too, which the parser would leave out; a list of them alone would take the model for its words.
  static std::vector<std::string> words_of(const std::string& list) {
    std::vector<std::string> words(1);
    for (const char c : list) {
      if (c == ',') {
        words.emplace_back();
      } else {
        words.back() += c;
      }
    }
    return words;
  }

  static std::string refusal_of_word(const std::string& word, const std::string& list,
                                     const std::vector<std::string>& choices) {
    if (list.empty()) return "what is given for it is empty";
    if (word.empty()) return fmt::format("a word is missing beside a ',' in '{}'", list);
    return refusal_of_choice(word, choices);
  }

  template <class Choice>
  void add_choice(const std::string& name, Choice& target, const std::vector<std::pair<std::string, Choice>>& choices,
                  const std::string& text, const std::string& about) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back(choice.first);
    const auto take = [&target, choices, words, name](const std::string& word) {
      for (const auto& [choice, value] : choices) {
        if (choice == word) target = value;
      }
      const std::string refusal = refusal_of_choice(word, words);
      if (!refusal.empty()) refuse(name, refusal);
    };
    CLI::Option* const option = app_.add_option_function<std::string>(name, take, wrapped(about));
    option->type_name(text);
    line_.choices[option] = words;
  }

  static std::vector<std::string> output_names() {
    std::vector<std::string> names;
    for (const OutputKind& kind : output_kinds()) names.push_back(kind.name);
    return names;
  }

  CommandLine& line_;
  CLI::App& app_;
  Options& options_;
};

}  // namespace

void refuse(const std::string& option, const std::string& why) { throw UsageError(option + ": " + why); }

const std::vector<std::string>& shells() {
  static const std::vector<std::string> k_shells{"bash", "zsh", "fish"};
  return k_shells;
}

CommandLine::CommandLine(Options& options) : app(k_about, "gauss-gen") {
  app.set_version_flag("--version", std::string("gauss-gen ") + k_version, "print the version");
  app.set_help_flag("-h,--help", "print this page");
  write_help_by(app);
  Adder(*this, app, options).generate();
  app.add_flag("--man", options.man, "print the manual page, for man -l -")->disable_flag_override();
  // Added after the help flag and the formatter, which they inherit; the footer of the page is for the program as a whole.
  const auto add = [&](const char* name, Command command, const char* about, const char* footer) {
    commands[name] = command;
    return Adder(*this, *app.add_subcommand(name, about)->footer(footer), options);
  };
  add("evaluate", Command::evaluate, k_about_evaluate, k_about_status).evaluate();
  add("linearize", Command::linearize, k_about_linearize, k_about_status).linearize();
  add("derivation", Command::derivation, k_about_derivation, "").derivation();
  add("explain", Command::explain, k_about_explain, "").explain();
  add("init", Command::init, k_about_init, "").init();
  add("schema", Command::schema, k_about_schema, "");
  add("completion", Command::completion, k_about_completion, "").completion();
  app.require_subcommand(0, 1);
}

}  // namespace gaussgen::cli
