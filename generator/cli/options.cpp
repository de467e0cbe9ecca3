#include "cli/options.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "artefacts.hpp"
#include "cli/exit_codes.hpp"
#include "version.hpp"

namespace gaussgen::cli {

namespace {

const char* const k_about =
    "gauss-gen: equations of motion and constraint reactions as C++, by Gauss's principle.\n"
    "\n"
    "  gauss-gen model.yaml               write <name>.hpp into this folder\n"
    "  gauss-gen evaluate model.yaml      accelerations, reactions, energy at the initial state, as numbers\n"
    "  gauss-gen derivation model.yaml    Z, the metric, c, b and the final equations as formulas\n";

const char* const k_exit_codes =
    "Exit codes: 0 ok, 1 error in the model, 2 usage, 3 input or output, 4 too large, 70 internal error";

std::vector<std::string> output_names() {
  std::vector<std::string> names;
  for (const OutputKind& kind : output_kinds()) names.push_back(kind.name);
  return names;
}

void add_model(CLI::App& app, Options& options) {
  app.add_option("model", options.model, "Model file; - for standard input")->type_name("FILE");
}

void add_generate(CLI::App& app, Options& options) {
  add_model(app, options);
  app.add_option("-o,--output", options.output, "Folder for <name>.hpp, or - for standard output")->type_name("DIR");
  app.add_flag("--check", options.check, "Only say whether the model is right");
  app.add_flag("--list-outputs", options.list_outputs, "Say which files would be written, one per line");
  app.add_option("--depfile", options.depfile, "Also write dependencies for make and Ninja")->type_name("FILE");
  app.add_option("--namespace", options.pipeline.name_space, "C++ namespace instead of gauss::<name>")->type_name("NAME");
  app.add_option("--outputs", options.pipeline.outputs, "Functions to emit, separated by commas; default: all")
      ->delimiter(',')
      ->type_name("LIST")
      ->check(CLI::IsMember(output_names()));
  app.add_flag("--fold", options.pipeline.fold, "Put the parameters in as numbers");
  const std::map<std::string, Route> routes{{"emitted", Route::emitted}, {"paper", Route::paper}};
  app.add_option("--route", options.pipeline.route, "emitted, or paper: Z, Gamma and (3.7)-(3.8) term by term")
      ->transform(CLI::CheckedTransformer(routes, CLI::ignore_case).description(""))
      ->type_name("ROUTE");
  app.add_option("--dump", options.dumps, "Print a stage instead of writing: " + CLI::detail::join(stage_names(), ", "))
      ->delimiter(',')
      ->type_name("STAGE")
      ->check(CLI::IsMember(stage_names()).description(""));
  app.add_flag("--timings", options.timings, "Say what each stage took, on standard error");
}

void add_evaluate(CLI::App& app, Options& options) {
  add_model(app, options);
  app.add_option("--set", options.overrides, "Change a parameter, coordinate or rate: m=2, chi=0.1, 'dot(chi)=2'")
      ->type_name("NAME=VALUE")
      ->take_all();
  app.add_option("--time", options.time, "Time, default 0")->type_name("T");
  app.add_option("--digits", options.digits, "Significant digits, default 17")->check(CLI::Range(1, 10000))->type_name("N");
  const std::map<std::string, Format> formats{{"table", Format::table}, {"json", Format::json}};
  app.add_option("--format", options.format, "table or json")
      ->transform(CLI::CheckedTransformer(formats, CLI::ignore_case).description(""))
      ->type_name("FORMAT");
}

void add_derivation(CLI::App& app, Options& options) {
  add_model(app, options);
  app.add_option("-o,--output", options.output, "File instead of standard output")->type_name("FILE");
  const std::map<std::string, Format> formats{{"markdown", Format::markdown}, {"latex", Format::latex}};
  app.add_option("--format", options.format, "markdown or latex")
      ->transform(CLI::CheckedTransformer(formats, CLI::ignore_case).description(""))
      ->type_name("FORMAT");
}

/// CLI11 has exit codes of its own; ours are documented.
int finish(const CLI::App& app, const CLI::ParseError& error) {
  return app.exit(error) == 0 ? k_ok : k_usage_error;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code) {
  Options options;
  CLI::App app(k_about, "gauss-gen");
  app.footer(k_exit_codes);
  app.set_version_flag("--version", std::string("gauss-gen ") + k_version);
  app.option_defaults()->always_capture_default(false);
  add_generate(app, options);
  CLI::App* evaluate = app.add_subcommand("evaluate", "Numbers at the initial state, with as many digits as wanted");
  add_evaluate(*evaluate, options);
  CLI::App* derivation = app.add_subcommand("derivation", "The paper's objects and the final equations as formulas");
  add_derivation(*derivation, options);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
    if (*evaluate) options.command = Command::evaluate;
    if (*derivation) options.command = Command::derivation;
    if (options.model.empty()) throw CLI::RequiredError("a model file");
  } catch (const CLI::ParseError& error) {
    exit_code = finish(app, error);
    return std::nullopt;
  }
  if (options.command == Command::derivation && options.format == Format::table) options.format = Format::markdown;
  return options;
}

}  // namespace gaussgen::cli
