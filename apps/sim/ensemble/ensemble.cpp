#include "sim/ensemble/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/ensemble/check_draws.hpp"
#include "sim/ensemble/choose_lanes.hpp"
#include "sim/ensemble/summary.hpp"
#include "sim/ensemble/table.hpp"
#include "sim/output/csv.hpp"
#include "sim/output/files.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/settings.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// What options say of the ensemble itself.
void apply(const EnsembleOptions& options, Ensemble& ensemble) {
  if (options.seed) ensemble.seed = static_cast<std::uint64_t>(*options.seed);
  ensemble.records_samples = ensemble.records_samples || options.records_samples;
  const auto& varied = ensemble.varied;
  for (const std::string& set : options.sets) {
    const std::string name = set.substr(0, set.find('='));
    if (std::any_of(varied.begin(), varied.end(), [&](const Varied& one) { return one.name == name; }))
      throw cli::UsageError(fmt::format("--set {}: the ensemble varies it", name));
  }
  if (!options.trajectories) return;
  if (std::none_of(varied.begin(), varied.end(), [](const Varied& one) { return one.distribution.is_random(); }))
    throw cli::UsageError("--trajectories: nothing is drawn, so sweeps alone say how many there are");
  ensemble.trajectories = *options.trajectories;
  if (points_of(ensemble) * static_cast<double>(ensemble.trajectories) > static_cast<double>(k_most_trajectories))
    throw cli::UsageError(fmt::format("--trajectories: there may be {} in all", k_most_trajectories));
}

int threads_of(const EnsembleOptions& options) {
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  return options.threads > 0 ? options.threads : std::max(1, all);
}

std::string csv_path(const EnsembleOptions& options, const PreparedModel& prepared) {
  if (!options.output.empty()) return options.output;
  return prepared.name() + ".ensemble.csv";
}

int code_of(const EnsembleTold& told, const cli::MessageOptions& messages) {
  const Outcomes& outcomes = told.outcomes;
  const long run = outcomes.run();
  const long finished = std::count_if(outcomes.ended.begin(), outcomes.ended.end(),
                                      [](const Ended& one) { return one.how == Ended::How::finished; });
  if (outcomes.untrusted() > 0)
    cli::warn(fmt::format("outputs of {} rows are not to be trusted", outcomes.untrusted()), messages);
  if (told.was_interrupted) {
    cli::remark(fmt::format("interrupted: the table has the first {} of {} trajectories", run, outcomes.ended.size()),
                messages);
    return cli::k_interrupted;
  }
  if (finished == run) return cli::k_ok;
  const std::string text = fmt::format("{} of {} trajectories did not arrive; the table says why", run - finished, run);
  if (finished == 0) return cli::fail(text, cli::k_motion_stopped, messages);
  cli::warn(text, messages);
  return cli::k_ok;
}

std::optional<PreparedModel> prepare_varied(const EnsembleOptions& options, std::vector<Placed>& places, int& code) {
  Request request{options.file, options.sets, {}, options.messages};
  request.instance = options.instance;
  request.adjust = [&](const Scene& scene, gaussgen::model::Model& model, gaussgen::support::Diagnostics& diagnostics) {
    places = vary(scene, model, diagnostics);
    if (!diagnostics.has_errors()) check_draws(*scene.ensemble, places, model, diagnostics);
  };
  const auto change = [&](Scene& scene) {
    if (!scene.ensemble)
      throw cli::UsageError("the file says nothing of an ensemble: add the key 'ensemble' to a scene");
    apply(options, scene, request);
    apply(options, *scene.ensemble);
  };
  const EndsAtOnce while_it_checks(options.messages);
  return prepare(request, change, code);
}

}  // namespace

int ensemble(const EnsembleOptions& options) {
  const Interruption interruption;
  std::vector<Placed> places;
  int code = cli::k_ok;
  const auto prepared = prepare_varied(options, places, code);
  if (!prepared) return code;
  refuse_regimes(*prepared, "an ensemble");
  const Plan plan(*prepared->scene.ensemble);
  EngineTimes times;
  std::string why;
  const auto engine =
      build_engine(*prepared, engine_choice(prepared->scene), {scalar_of(number_name(prepared->scene))}, times, why);
  if (!engine) return cli::fail(why, cli::k_file_error, options.messages);
  warn_of_interpreting(times, options.messages);
  if (prepared->scene.error)
    cli::warn("an error is for 'run', which looks for a setting: the ensemble takes the tolerance", options.messages);
  const std::string csv = csv_path(options, *prepared);
  check_outputs(csv, {options.file, prepared->model_file});
  EnsembleSetting setting;
  setting.setting = setting_of(*prepared, *engine);
  const BuiltLanes lanes = choose_lanes(options.lanes, *prepared, *engine, setting.setting, options.messages);
  setting.threads = threads_of(options);
  setting.lanes = lanes.kernel.get();
  setting.records_samples = prepared->scene.ensemble->records_samples;

  CsvFile file(csv);
  file.write(ensemble_header(*prepared, plan.varied()));
  Outcomes outcomes;
  bool was_interrupted = false;
  {
    ProgressBar bar(!options.quiet);
    EnsembleListeners listeners;
    listeners.on_rows = [&](const std::string& rows) { file.write(rows); };
    listeners.on_wait = [&](double share) { bar.show(share, prepared->name()); };
    outcomes = run_all(*prepared, *engine, setting, {&plan, &places}, listeners);
    was_interrupted = Interruption::is_asked_for() && outcomes.run() < plan.count();
  }
  EnsembleTold told{*prepared, setting, outcomes, engine->name(), times, lanes.compile_seconds, was_interrupted};
  told.statistics = statistics_of_outputs(outcomes);
  file.finish();
  if (csv != "-") {
    const std::string path = summary_path(csv);
    cli::Replacement(path, ensemble_json(told).dump(2) + "\n").commit();
    if (!options.quiet) cli::write_standard_output(ensemble_text(told) + fmt::format("  wrote {} and {}\n", csv, path));
  }
  return code_of(told, options.messages);
}

}  // namespace gausssim
