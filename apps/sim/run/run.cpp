#include "sim/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/output/csv.hpp"
#include "sim/output/files.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/closed_form.hpp"
#include "sim/run/error_estimate.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/jumps.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/resume.hpp"
#include "sim/run/settings.hpp"
#include "sim/run/standstill.hpp"
#include "sim/run/tighter_runs.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using gauss::simulate::Outcome;

constexpr double k_long_run = 5;  ///< seconds; not made again unless somebody asks

std::string csv_path(const RunOptions& options, const PreparedModel& prepared) {
  if (!options.output.empty()) return options.output;
  return prepared.name() + ".csv";
}

EarlierRun earlier_run(const std::string& csv, const PreparedModel& prepared, const Setting& setting) {
  if (csv == "-") throw cli::UsageError("--resume: standard output cannot be gone on with");
  return read_earlier_run(csv, summary_path(csv), prepared, setting);
}

/// How far a run may be off.
struct Estimate : DeliveredError {
  std::vector<std::string> constants = {};  ///< outputs that have no range that this is a part of
  std::optional<DeliveredError> agreement =
      std::nullopt;  ///< of the tighter runs that say so; nothing where there is one of them
};

/// What is known of errors; nothing where it is not.
struct KnownErrors {
  std::optional<Estimate> estimate;
  std::string why_none;  ///< of the estimate
  std::optional<DeliveredError> from_closed_forms;
};

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

nlohmann::ordered_json asked_json(const FoundSetting& found, double error) {
  return {{"error", error},
          {"reference", found.reference_in_words},
          {"agreement", found.agreement},
          {"settings_tried", found.trials.size()},
          // Of the processor, for a run that writes nothing: what settings are compared by.
          {"seconds", found.chosen.seconds}};
}

nlohmann::ordered_json estimate_json(const Estimate& estimate) {
  nlohmann::ordered_json json{
      {"relative", estimate.value}, {"output", estimate.output}, {"constant", estimate.constants}};
  if (estimate.agreement) json["agreement"] = estimate.agreement->value;
  return json;
}

nlohmann::ordered_json summary(const PreparedModel& prepared, const Setting& setting, const Engine& engine,
                               const Simulated& run, const Times& times, const KnownErrors& errors,
                               const std::optional<FoundSetting>& found, const std::string& asked_before) {
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
  if (setting.longest_step > 0) json["longest_step"] = setting.longest_step;
  json["projection"] = name_of(setting.projection);
  if (setting.projection == Projection::gains) json["gain"] = setting.gain;
  json["steps"] = run.steps;
  json["rejected"] = run.rejected;
  json["calls"] = run.calls;
  json["jacobians"] = run.jacobians;
  if (const auto& error = errors.estimate) json["error_estimate"] = estimate_json(*error);
  if (const auto& error = errors.from_closed_forms)
    json["from_closed_forms"] = {{"relative", error->value}, {"output", error->output}};
  if (found) json["asked_for"] = asked_json(*found, *prepared.scene.error);
  if (!asked_before.empty()) json["asked_for"] = nlohmann::ordered_json::parse(asked_before);
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

/// In parts of ranges.
std::string in_words(const DeliveredError& error) {
  return said(error.value) + " of the range" + (error.output.empty() ? "" : ", largest in " + error.output);
}

/// Whether it is to be relied on is said where it is not.
std::string in_words(const Estimate& estimate, bool is_found) {
  const std::string text = in_words(static_cast<const DeliveredError&>(estimate));
  if (is_found) return text;
  if (!estimate.agreement) return text + "; by one tighter run, which no other one confirms";
  return estimate.agreement->value <= k_agree * estimate.value
             ? text
             : fmt::format("{} at most; two tighter runs agree to {} only", text, said(estimate.agreement->value));
}

void tell(const RunOptions& options, const PreparedModel& prepared, const Setting& setting, const Engine& engine,
          const Simulated& run, const Times& times, const KnownErrors& errors, const std::optional<FoundSetting>& found,
          const std::string& csv) {
  if (options.quiet || csv == "-") return;
  const std::string how = setting.step > 0 ? "step " + said(setting.step) : "tolerance " + said(setting.tolerance);
  const char* const projection =
      run.drift.has_constraints && setting.projection == Projection::off ? ", no projection" : "";
  std::string text =
      fmt::format("{}: {:.6g} s by {} ({}, {}, {}{})\n", prepared.name(), run.reached - prepared.span.start,
                  setting.method, how, setting.number, engine.name(), projection);
  text += fmt::format("  steps   {} ({} refused), {} calls, {} s", run.steps, run.rejected, run.calls,
                      said(run.wall_seconds));
  text += times.engine.was_cached || times.engine.compile == 0
              ? "\n"
              : fmt::format("; compiled in {} s\n", said(times.engine.compile));
  if (found)
    text += fmt::format("  asked   for {} of the range; found by trying, against {}\n", said(*prepared.scene.error),
                        found->reference_in_words);
  text += fmt::format("  error   {}\n", errors.estimate ? in_words(*errors.estimate, found.has_value())
                                                        : "not estimated: " + errors.why_none);
  if (errors.from_closed_forms) text += fmt::format("  exact   off by {}\n", in_words(*errors.from_closed_forms));
  if (run.drift.has_energy)
    text += fmt::format("  energy  changes by {} J of {} J\n", said(run.drift.energy), said(run.drift.energy_scale));
  if (run.drift.has_constraints)
    text += fmt::format("  drift   {} in positions, {} in velocities\n", said(run.drift.positions),
                        said(run.drift.velocities));
  text += fmt::format("  wrote   {} ({} rows of {} columns) and {}\n", csv, run.samples,
                      prepared.columns.columns.size() + 1, summary_path(csv));
  cli::write_standard_output(text);
}

int code_of(const Simulated& run, const PreparedModel& prepared, const std::string& csv, bool is_further,
            const cli::MessageOptions& messages) {
  if (run.untrusted_samples > 0)
    cli::warn(fmt::format("outputs of {} samples are not to be trusted: {}", run.untrusted_samples,
                          gauss::name(run.sample_status)),
              messages);
  if (run.was_interrupted) {
    cli::remark(fmt::format("interrupted at t = {:.10g}; the table ends there{}", run.reached,
                            csv == "-" ? "" : ", and --resume goes on from it"),
                messages);
    return cli::k_interrupted;
  }
  if (run.outcome == Outcome::running) return cli::k_ok;
  const std::string why = run.why.empty() ? gauss::simulate::name(run.outcome) : run.why;
  const bool is_by_steps = run.outcome == Outcome::too_many_steps || run.outcome == Outcome::step_too_small;
  std::string hint;
  if (is_by_steps && !prepared.edge.empty())
    hint = hint_for_edge(prepared.edge);
  else if (run.outcome == Outcome::too_many_steps && csv != "-" && is_further)
    hint = "--resume goes on from the last row, for as many steps again";
  return cli::fail(
      fmt::format("the motion of '{}' stops at t = {:.10g}: {}{}", prepared.model.unit.model_name, run.reached, why,
                  run.status == gauss::Status::ok ? "" : std::string(" (status: ") + gauss::name(run.status) + ")"),
      cli::k_motion_stopped, messages, hint);
}

/// Of motions that nobody can follow, or not with this tolerance.
void warn_of_error(const DeliveredError& error, const cli::MessageOptions& messages) {
  constexpr double k_useless = 0.1;
  if (error.value < k_useless) return;
  cli::warn(
      fmt::format("the table is off by {:.2g} of the range of '{}': it is not this motion; --error 1e-3 looks for a "
                  "setting that is, or says that there is none",
                  error.value, error.output),
      messages);
}

/// Who wrote the closed form had another motion in mind.
void warn_of_closed_forms(const KnownErrors& errors, const cli::MessageOptions& messages) {
  constexpr double k_apart = 1e-3, k_clear = 100;
  if (!errors.estimate || !errors.from_closed_forms) return;
  const auto& [apart, output] = *errors.from_closed_forms;
  if (apart < k_apart || apart < k_clear * errors.estimate->value) return;
  cli::warn(fmt::format("the closed form of '{}' is another motion: it is {:.2g} of its range off, where the error is "
                        "about {:.2g}",
                        output, apart, errors.estimate->value),
            messages);
}

void warn_of_tolerance(const Setting& setting, const cli::MessageOptions& messages) {
  const double least = least_tolerance(setting.number);
  if (setting.tolerance > 0 && setting.tolerance < least)
    cli::warn(fmt::format("in {}, rounding is more than tolerances below {:.0e}: {} brings nothing", setting.number,
                          least, setting.tolerance),
              messages);
}

/// Why no tighter run is made; empty: one is.
std::string why_not_estimated(const Simulated& run, bool goes_on) {
  if (goes_on) return "the run went on from an earlier one";
  if (run.was_interrupted) return "the run was interrupted";
  if (run.samples <= 1) return "the motion stopped before the second row";
  if (run.wall_seconds >= k_long_run) return fmt::format("runs of more than {} s are not made again", k_long_run);
  return "";
}

/// Also that of times, which are rounded, whatever two runs have in common.
DeliveredError error_of(const Rows& rows, const Yardstick& yardstick, const PreparedModel& prepared,
                        const Setting& setting) {
  const Span& span = prepared.span;
  const double between = span.duration / static_cast<double>(span.samples - 1);
  const double latest = std::max(std::abs(span.start), std::abs(span.start + span.duration));
  const DeliveredError by_steps = yardstick.error_of(rows);
  const DeliveredError by_times = yardstick.change_within(rounding_unit(setting.number) / 2 * latest / between);
  return by_times.value > by_steps.value ? by_times : by_steps;
}

Estimate estimate_by(const Yardstick& yardstick, const Rows& rows, const PreparedModel& prepared,
                     const Setting& setting) {
  return {error_of(rows, yardstick, prepared, setting), yardstick.constants()};
}

/// What tighter runs make of errors, no less than what these differ by. Nothing: `why`.
std::optional<Estimate> estimated(const PreparedModel& prepared, const Engine& engine, Engines& engines,
                                  const Setting& setting, const Simulated& run, const Rows& rows, std::string& why) {
  const auto tight = tighter_runs(prepared, engine, engines, setting, run, rows, why);
  if (!tight) return std::nullopt;
  Estimate result = estimate_by(tight->yardstick, rows, prepared, setting);
  result.agreement = tight->agreement;
  if (tight->agreement && tight->agreement->value > result.value)
    static_cast<DeliveredError&>(result) = *tight->agreement;
  return result;
}

DeliveredError from_closed_forms(const ClosedForms& forms, const PreparedModel& prepared, const Setting& setting,
                                 const Rows& rows) {
  const Rows exact = forms.instead_of(rows, prepared);
  const double rounding = least_tolerance(setting.number);
  return Yardstick(exact, exact, prepared.columns.columns, rounding, rounding).error_of(rows);
}

}  // namespace

int run(const RunOptions& options, const FindSetting& find) {
  const Interruption interruption;
  int code = cli::k_ok;
  const auto prepared = prepare_run(options, code);
  if (!prepared) return code;
  // What a search compiles first is a part of it.
  std::optional<TimeLimit> limit;
  if (prepared->scene.error && !options.resume) limit.emplace(options.budget);
  Engines engines(*prepared, engine_choice(prepared->scene));
  const Engine* engine = engines.of(number_name(prepared->scene));
  if (engine == nullptr) return cli::fail(engines.why(), cli::k_file_error, options.messages);
  warn_of_interpreting(engines.times(), options.messages);
  Setting setting = setting_of(*prepared, *engine);
  std::optional<FoundSetting> found;
  const std::string csv = csv_path(options, *prepared);
  check_outputs(csv, {options.file, prepared->model_file});
  // What was found then goes on; what would be found now may be another setting.
  if (prepared->scene.error && options.resume) {
    setting = setting_of_earlier_run(summary_path(csv));
    engine = engines.of(setting.number);
    if (engine == nullptr) return cli::fail(engines.why(), cli::k_file_error, options.messages);
  } else if (prepared->scene.error) {
    std::string why;
    try {
      found = find(*prepared, engines, {*prepared->scene.error, options.budget, !options.quiet}, why);
    } catch (const Interrupted&) {
      cli::remark("interrupted while a setting was looked for; nothing is written", options.messages);
      return cli::k_interrupted;
    }
    if (!found) return cli::fail(why, cli::k_not_delivered, options.messages);
    setting = found->chosen.setting;
    engine = engines.of(setting.number);
  }
  limit.reset();
  setting.most_steps = options.max_steps.value_or(0);
  const Times times{prepared->generate_seconds, engines.times()};
  warn_of_tolerance(setting, options.messages);

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
    ProgressBar bar(!options.quiet);
    StandstillWatch standstill(*prepared, options.messages, bar);
    Listeners listeners;
    listeners.on_row = [&](const std::string& row, double share) {
      file.write(row);
      bar.show(share, prepared->name());
      return true;
    };
    listeners.on_numbers = [&](long k, const std::vector<long double>& row) {
      rows.set(k, row);
      standstill.look(k);
    };
    simulated = simulate(*prepared, *engine, setting, listeners, earlier ? &earlier->run : nullptr);
  }
  // There was no motion at all, so there is no table of one.
  if (!simulated.why.empty() && simulated.samples == 0) {
    const bool is_setting = simulated.outcome == Outcome::bad_settings;
    return cli::fail(simulated.why, is_setting ? cli::k_usage_error : cli::k_motion_stopped, options.messages);
  }
  KnownErrors errors;
  if (found && !earlier) {
    errors.estimate = estimate_by(found->reference, rows, *prepared, setting);
  } else {
    errors.why_none = why_not_estimated(simulated, earlier.has_value());
    if (errors.why_none.empty())
      errors.estimate = estimated(*prepared, *engine, engines, setting, simulated, rows, errors.why_none);
  }
  if (const ClosedForms forms(*prepared); forms.are_there() && !earlier)
    errors.from_closed_forms = from_closed_forms(forms, *prepared, setting, rows);
  const std::string asked_before = earlier ? earlier->asked_for : "";
  const std::string text =
      summary(*prepared, setting, *engine, simulated, times, errors, found, asked_before).dump(2) + "\n";
  file.finish();
  if (csv != "-") cli::Replacement(summary_path(csv), text).commit();
  tell(options, *prepared, setting, *engine, simulated, times, errors, found, csv);
  const auto& error = errors.estimate;
  if (error && !found) warn_of_error(*error, options.messages);
  warn_of_closed_forms(errors, options.messages);
  if (found && error && simulated.outcome == Outcome::running && !(error->value <= *prepared->scene.error))
    return cli::fail(fmt::format("the run is off by {:.2e}, in {}", error->value, error->output), cli::k_not_delivered,
                     options.messages);
  const bool is_further = simulated.samples > (earlier ? earlier->run.samples : 1);
  return code_of(simulated, *prepared, csv, is_further, options.messages);
}

}  // namespace gausssim
