#include "sim/run/run.hpp"

#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/output/csv.hpp"
#include "sim/output/files.hpp"
#include "sim/regimes/impulse_units.hpp"
#include "sim/run/finished_run.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/resume.hpp"
#include "sim/run/run_instances.hpp"
#include "sim/run/settings.hpp"
#include "sim/run/summary.hpp"
#include "sim/run/watched_run.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

std::string csv_path(const RunOptions& options, const PreparedModel& prepared) {
  if (!options.output.empty()) return options.output;
  return prepared.name() + ".csv";
}

std::string events_csv(const std::vector<Event>& events, const Switches& switches) {
  std::string text = fmt::format("t [s],event,{}\n", head_of_impulses(switches));
  for (const Event& event : events)
    text += fmt::format("{},{},{}\n", event.t, event.what, cell_of_impulse(event, switches));
  return text;
}

class Run {
 public:
  Run(const RunOptions& options, const PreparedModel& prepared)
      : options_(options), prepared_(prepared), csv_(csv_path(options, prepared)), watched_(options, prepared) {}

  int make(const FindSetting& find) {
    if (const int code = choose(find); code != cli::k_ok) return code;
    const EngineTimes times = watched_.engines().times();
    warn_of_tolerance(watched_.setting(), options_.messages);
    std::optional<EarlierRun> earlier;
    if (options_.resume) earlier = read_earlier_run(csv_, summary_path(csv_), prepared_, watched_.setting());
    if (earlier && earlier->is_finished) {
      if (!options_.quiet) cli::remark(fmt::format("the run in '{}' has finished already", csv_), options_.messages);
      return cli::k_ok;
    }
    CsvFile file(csv_);
    file.write(earlier ? earlier->table : csv_header(prepared_.columns.columns));
    const Simulated run = watched_.run([&](const std::string& row) { file.write(row); }, earlier ? &*earlier : nullptr);
    // There was no motion at all, so there is no table of one.
    if (!run.why.empty() && run.samples == 0) {
      const bool is_setting = run.outcome == gauss::simulate::Outcome::bad_settings;
      return cli::fail(run.why, is_setting ? cli::k_usage_error : cli::k_motion_stopped, options_.messages);
    }
    const FinishedRun finished{prepared_,
                               watched_.setting(),
                               watched_.engine().name(),
                               run,
                               times,
                               watched_.errors_of(run, earlier.has_value()),
                               watched_.found(),
                               earlier ? earlier->asked_for : "",
                               csv_};
    const std::string text = summary_of(finished);
    file.finish();
    if (csv_ != "-") cli::Replacement(summary_path(csv_), text).commit();
    if (csv_ != "-" && prepared_.regimes)
      cli::Replacement(events_path(csv_), events_csv(run.events, prepared_.regimes->switches())).commit();
    if (!options_.quiet && csv_ != "-") tell(finished);
    return report_end(finished, run.samples > (earlier ? earlier->run.samples : 1), options_.messages);
  }

 private:
  /// Engine and setting, or another code than that of success.
  int choose(const FindSetting& find) {
    // What a search compiles first is a part of it.
    std::optional<TimeLimit> limit;
    if (prepared_.scene.error && !options_.resume) limit.emplace(budget());
    if (options_.budget && !prepared_.scene.error)
      cli::warn("--budget is time of a search for a setting: without an error to look for there is none",
                options_.messages);
    if (const int code = watched_.choose(); code != cli::k_ok) return code;
    warn_of_interpreting(watched_.engines().times(), options_.messages);
    check_outputs(csv_, {options_.file, prepared_.model_file});
    if (options_.resume && csv_ == "-") throw cli::UsageError("--resume: standard output cannot be gone on with");
    if (!prepared_.scene.error) return cli::k_ok;
    if (!options_.resume) return search(find);
    // What was found then goes on; what would be found now may be another setting.
    return watched_.take(setting_of_earlier_run(summary_path(csv_)));
  }

  double budget() const { return options_.budget.value_or(Wanted().budget); }

  int search(const FindSetting& find) {
    std::string why;
    std::optional<FoundSetting> found;
    try {
      found = find(prepared_, watched_.engines(), {*prepared_.scene.error, budget(), !options_.quiet}, why);
    } catch (const Interrupted&) {
      cli::remark("interrupted while a setting was looked for; nothing is written", options_.messages);
      return cli::k_interrupted;
    }
    if (!found) return cli::fail(why, cli::k_not_delivered, options_.messages);
    return watched_.take(std::move(*found));
  }

  const RunOptions& options_;
  const PreparedModel& prepared_;
  std::string csv_;
  WatchedRun watched_;
};

/// It may be a pipe, and somebody who has to be waited for.
gaussgen::support::Source read_once(const RunOptions& options) {
  const EndsAtOnce while_it_waits(options.messages);
  return cli::read_source(options.file);
}

}  // namespace

int run(const RunOptions& options, const FindSetting& find) {
  const Interruption interruption;
  const gaussgen::support::Source text = read_once(options);
  if (options.instance.empty() && has_instances(text)) return run_instances(options, text);
  int code = cli::k_ok;
  const auto prepared = prepare_run(options, code, text);
  if (!prepared) return code;
  return Run(options, *prepared).make(find);
}

}  // namespace gausssim
