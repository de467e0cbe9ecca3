#include "sim/run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/overrides.hpp"
#include "cli/replacement.hpp"
#include "sim/model/layout.hpp"
#include "sim/output/csv.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/error_estimate.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/resume.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using gauss::simulate::Outcome;

constexpr double k_default_tolerance = 1e-9;
constexpr double k_default_steps = 10'000;  ///< of one length, in a run
constexpr double k_tighter = 1.0 / 30;      ///< tolerance of the run that tells errors
constexpr double k_long_run = 5;            ///< seconds; not made twice unless somebody asks

void apply(const RunOptions& options, Scene& scene) {
  const auto word = [](const std::string& text, std::optional<Word>& to) {
    if (!text.empty()) to = Word{text, {}};
  };
  word(options.method, scene.method);
  word(options.number, scene.number);
  word(options.projection, scene.projection);
  word(options.strategy, scene.strategy);
  word(options.engine, scene.engine);
  const auto value = [](const char* option, const std::string& text, std::optional<gaussgen::model::Ast>& to) {
    if (text.empty()) return;
    to = cli::parse_value(option, text);
    to->text = text;
  };
  value("--start", options.start, scene.start);
  value("--duration", options.duration, scene.duration);
  value("--every", options.every, scene.every);
  if (!options.every.empty()) scene.samples.reset();
  if (options.samples) scene.samples = options.samples, scene.every.reset();
  if (options.tolerance) scene.tolerance = options.tolerance, scene.error.reset();
  if (options.step) scene.step = options.step;
  if (!options.outputs.empty()) scene.outputs.clear();
  for (const std::string& name : options.outputs) scene.outputs.push_back({name, {}});
}

EngineChoice engine_choice(const Scene& scene) {
  if (!scene.engine || scene.engine->text == "auto") return EngineChoice::automatic;
  return scene.engine->text == "compiled" ? EngineChoice::compiled : EngineChoice::interpreted;
}

/// Series where the model has them.
std::string default_method(const Described& model, const Engine& engine, const std::string& scalar) {
  const bool has_series = static_cast<bool>(engine.find("series_begin", scalar));
  return find_function(model.tree, "taylor") != nullptr && has_series ? "taylor" : "prince87";
}

bool chooses_method(const Scene& scene) { return !scene.method || scene.method->text == "auto"; }

/// What no model can change: refused before one is read.
void check_method(const Scene& scene) {
  if (chooses_method(scene)) return;
  const MethodInfo& method = *find_method(scene.method->text);
  const auto refuse = [&](const std::string& why) {
    throw cli::UsageError(fmt::format("method '{}': {}", method.name, why));
  };
  if (!method.missing.empty()) refuse(method.missing);
  const std::string number = scene.number ? scene.number->text : "double";
  if (!method.has_long_double && number != "double") refuse("it computes in double, and no other number type");
  if (number == "float128" && method.name != "taylor") refuse("in float128 there is no method but taylor");
  if (!method.projects && scene.projection && scene.projection->text != "off")
    refuse("it does not project, so states drift off the constraints as its tolerance allows; take 'projection: off'");
}

Setting setting_of(const PreparedModel& prepared, const Engine& engine) {
  const Scene& scene = prepared.scene;
  Setting setting;
  if (scene.number) setting.number = scene.number->text;
  setting.method =
      chooses_method(scene) ? default_method(prepared.model, engine, scalar_of(setting.number)) : scene.method->text;
  const MethodInfo& method = *find_method(setting.method);
  setting.projection = scene.projection  ? projection_of(scene.projection->text)
                       : method.projects ? Projection::full
                                         : Projection::off;
  if (method.takes_step) {
    setting.step = scene.step.value_or(prepared.span.duration / k_default_steps);
  } else {
    setting.tolerance = scene.tolerance.value_or(k_default_tolerance);
  }
  return setting;
}

std::string csv_path(const RunOptions& options, const PreparedModel& prepared) {
  if (!options.output.empty()) return options.output;
  const std::string& name = prepared.scene.name.empty() ? prepared.model.unit.model_name : prepared.scene.name;
  return name + ".csv";
}

std::string summary_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".json").string();
}

EarlierRun earlier_run(const std::string& csv, const PreparedModel& prepared, const Setting& setting) {
  if (csv == "-") throw cli::UsageError("--resume: standard output cannot be gone on with");
  return read_earlier_run(csv, summary_path(csv), prepared, setting);
}

struct Times {
  double generate = 0;
  EngineTimes engine;
};

nlohmann::ordered_json drift_json(const Drift& drift) {
  nlohmann::ordered_json json;
  if (drift.has_energy)
    json["energy"] = {{"largest_change", drift.energy}, {"largest_kinetic", drift.energy_scale}, {"unit", "J"}};
  if (drift.has_constraints) json["constraints"] = {{"positions", drift.positions}, {"velocities", drift.velocities}};
  return json;
}

nlohmann::ordered_json summary(const PreparedModel& prepared, const Setting& setting, const Engine& engine,
                               const Simulated& run, const Times& times, const std::optional<DeliveredError>& error) {
  nlohmann::ordered_json json;
  json["tool"] = std::string("gauss-sim ") + gaussgen::k_version;
  json["model"] = prepared.model.unit.model_name;
  if (!prepared.scene.name.empty()) json["scene"] = prepared.scene.name;
  json["outcome"] = run.was_interrupted               ? "interrupted"
                    : run.outcome == Outcome::running ? "finished"
                                                      : gauss::simulate::name(run.outcome);
  json["status"] = gauss::name(run.status);
  json["start"] = prepared.span.start;
  json["reached"] = run.reached;
  json["duration"] = prepared.span.duration;
  json["samples"] = run.samples;
  json["engine"] = engine.name();
  json["method"] = setting.method;
  json["number"] = setting.number;
  if (setting.tolerance > 0) json["tolerance"] = setting.tolerance;
  if (setting.step > 0) json["step"] = setting.step;
  for (const auto& [name, how] : k_projections) {
    if (how == setting.projection) json["projection"] = name;
  }
  json["steps"] = run.steps;
  json["rejected"] = run.rejected;
  json["calls"] = run.calls;
  json["jacobians"] = run.jacobians;
  if (error) json["error_estimate"] = {{"relative", error->value}, {"output", error->output}};
  json["drift"] = drift_json(run.drift);
  if (run.start_moved > 0) json["start_moved"] = {{"by", run.start_moved}, {"component", run.start_component}};
  if (run.with_fewer_constraints > 0) json["steps_with_fewer_constraints"] = run.with_fewer_constraints;
  if (run.crossings > 0) json["crossings"] = run.crossings;
  if (run.untrusted_samples > 0)
    json["untrusted_samples"] = {{"count", run.untrusted_samples}, {"status", gauss::name(run.sample_status)}};
  json["seconds"] = {{"generate", times.generate},
                     {"compile", times.engine.compile},
                     {"cached", times.engine.was_cached},
                     {"run", run.wall_seconds},
                     {"run_cpu", run.cpu_seconds}};
  json["last_state"] = run.last_state;
  json["resume"] = resume_json(prepared, run);
  return json;
}

/// Numbers of a state for people.
std::string said(double value) { return fmt::format("{:.3g}", value); }

void tell(const RunOptions& options, const PreparedModel& prepared, const Setting& setting, const Engine& engine,
          const Simulated& run, const Times& times, const std::optional<DeliveredError>& error,
          const std::string& csv) {
  if (options.quiet || csv == "-") return;
  const std::string how = setting.step > 0 ? "step " + said(setting.step) : "tolerance " + said(setting.tolerance);
  std::string text =
      fmt::format("{}: {} s by {} ({}, {}, {})\n", prepared.model.unit.model_name,
                  said(run.reached - prepared.span.start), setting.method, how, setting.number, engine.name());
  text += fmt::format("  steps   {} ({} refused), {} calls, {} s", run.steps, run.rejected, run.calls,
                      said(run.wall_seconds));
  text += times.engine.was_cached || times.engine.compile == 0
              ? "\n"
              : fmt::format("; compiled in {} s\n", said(times.engine.compile));
  if (error)
    text += fmt::format("  error   {} of the range, largest in {}\n", said(error->value),
                        error->output.empty() ? "none" : error->output);
  if (run.drift.has_energy)
    text += fmt::format("  energy  changes by {} J of {} J\n", said(run.drift.energy), said(run.drift.energy_scale));
  if (run.drift.has_constraints)
    text += fmt::format("  drift   {} in positions, {} in velocities\n", said(run.drift.positions),
                        said(run.drift.velocities));
  text += fmt::format("  wrote   {} ({} rows of {} columns) and {}\n", csv, run.samples,
                      prepared.columns.columns.size() + 1, summary_path(csv));
  cli::write_standard_output(text);
}

int code_of(const Simulated& run, const PreparedModel& prepared, const cli::MessageOptions& messages) {
  constexpr int k_interrupted = 130;
  if (run.untrusted_samples > 0)
    cli::warn(fmt::format("outputs of {} samples are not to be trusted: {}", run.untrusted_samples,
                          gauss::name(run.sample_status)),
              messages);
  if (run.was_interrupted) {
    cli::remark(fmt::format("interrupted at t = {}; the table ends there, and --resume goes on from it", run.reached),
                messages);
    return k_interrupted;
  }
  if (run.outcome == Outcome::running) return cli::k_ok;
  const std::string why = run.why.empty() ? gauss::simulate::name(run.outcome) : run.why;
  return cli::fail(
      fmt::format("the motion of '{}' stops at t = {}: {}{}", prepared.model.unit.model_name, run.reached, why,
                  run.status == gauss::Status::ok ? "" : std::string(" (status: ") + gauss::name(run.status) + ")"),
      cli::k_motion_stopped, messages);
}

/// Of the same method, closer to the motion. Where samples are closer than steps would be, a tolerance alone changes nothing.
Setting tighter(Setting setting, const Simulated& run, const Span& span) {
  constexpr double k_shorter = 0.5;
  if (setting.tolerance > 0) setting.tolerance *= k_tighter;
  if (setting.step > 0) setting.step *= k_shorter;
  if (setting.tolerance > 0 && run.steps > 0)
    setting.longest_step = k_shorter * span.duration / static_cast<double>(run.steps);
  return setting;
}

}  // namespace

int run(const RunOptions& options) {
  Request request{options.file, options.sets, {}, options.messages};
  int code = cli::k_ok;
  const auto prepared = prepare(
      request,
      [&](Scene& scene) {
        apply(options, scene);
        check_method(scene);
        if (!chooses_method(scene)) request.also = find_method(scene.method->text)->takes;
      },
      code);
  if (!prepared) return code;
  const std::string number = prepared->scene.number ? prepared->scene.number->text : "double";
  Times times;
  times.generate = prepared->generate_seconds;
  std::string why;
  const auto engine = build_engine(*prepared, engine_choice(prepared->scene), {scalar_of(number)}, times.engine, why);
  if (!engine) return cli::fail(why, cli::k_file_error, options.messages);
  const Setting setting = setting_of(*prepared, *engine);

  const std::string csv = csv_path(options, *prepared);
  std::optional<EarlierRun> earlier;
  if (options.resume) earlier = earlier_run(csv, *prepared, setting);
  if (earlier && earlier->is_finished) {
    if (!options.quiet) cli::remark(fmt::format("the run in '{}' has finished already", csv), options.messages);
    return cli::k_ok;
  }
  CsvFile file(csv);
  file.write(earlier ? earlier->table : csv_header(prepared->columns.columns));
  const std::size_t width = prepared->columns.columns.size();
  Rows rows(width, prepared->span.samples);
  Simulated simulated;
  {
    const Interruption interruption;
    ProgressBar bar(!options.quiet);
    Listeners listeners;
    listeners.on_row = [&](const std::string& row, double share) {
      file.write(row);
      bar.show(share, prepared->model.unit.model_name);
      return true;
    };
    listeners.on_numbers = [&](long k, const std::vector<long double>& row) { rows.set(k, row); };
    simulated = simulate(*prepared, *engine, setting, listeners, earlier ? &earlier->run : nullptr);
  }
  // There was no motion at all, so there is no table of one.
  if (!simulated.why.empty() && simulated.samples == 0) {
    const bool is_setting = simulated.outcome == Outcome::bad_settings;
    return cli::fail(simulated.why, is_setting ? cli::k_usage_error : cli::k_motion_stopped, options.messages);
  }
  std::optional<DeliveredError> error;
  if (simulated.samples > 1 && simulated.wall_seconds < k_long_run && !simulated.was_interrupted && !earlier) {
    Rows reference(width, prepared->span.samples);
    Listeners listeners;
    listeners.on_numbers = [&](long k, const std::vector<long double>& row) { reference.set(k, row); };
    listeners.measures_drift = false;
    simulate(*prepared, *engine, tighter(setting, simulated, prepared->span), listeners);
    error = delivered_error(rows, reference, prepared->columns.columns);
  }
  const std::string text = summary(*prepared, setting, *engine, simulated, times, error).dump(2) + "\n";
  file.finish();
  if (csv != "-") cli::Replacement(summary_path(csv), text).commit();
  tell(options, *prepared, setting, *engine, simulated, times, error, csv);
  return code_of(simulated, *prepared, options.messages);
}

}  // namespace gausssim
