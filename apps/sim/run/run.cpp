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
#include "sim/run/progress_bar.hpp"
#include "sim/run/resume.hpp"
#include "sim/run/settings.hpp"
#include "sim/run/standstill.hpp"
#include "sim/run/summary.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

std::string csv_path(const RunOptions& options, const PreparedModel& prepared) {
  if (!options.output.empty()) return options.output;
  return prepared.name() + ".csv";
}

void warn_of_tolerance(const Setting& setting, const cli::MessageOptions& messages) {
  const double least = least_tolerance(setting.number);
  if (setting.tolerance > 0 && setting.tolerance < least)
    cli::warn(fmt::format("in {}, rounding is more than tolerances below {:.0e}: {} brings nothing", setting.number,
                          least, setting.tolerance),
              messages);
}

std::string events_csv(const std::vector<Event>& events, const Switches& switches) {
  std::string text = fmt::format("t [s],event,{}\n", head_of_impulses(switches));
  for (const Event& event : events)
    text += fmt::format("{},{},{}\n", event.t, event.what, cell_of_impulse(event, switches));
  return text;
}

/// How a run is made.
struct Choice {
  Setting setting;
  const Engine* engine = nullptr;
  std::optional<FoundSetting> found;  ///< nothing: no error was asked for, or it goes on as it was found then
};

class Run {
 public:
  Run(const RunOptions& options, const PreparedModel& prepared)
      : options_(options),
        prepared_(prepared),
        csv_(csv_path(options, prepared)),
        engines_(prepared, engine_choice(prepared.scene)) {}

  int make(const FindSetting& find) {
    if (const int code = choose(find); code != cli::k_ok) return code;
    choice_.setting.most_steps = options_.max_steps.value_or(0);
    const EngineTimes times = engines_.times();
    warn_of_tolerance(choice_.setting, options_.messages);
    if (options_.resume) earlier_ = read_earlier_run(csv_, summary_path(csv_), prepared_, choice_.setting);
    if (earlier_ && earlier_->is_finished) {
      if (!options_.quiet) cli::remark(fmt::format("the run in '{}' has finished already", csv_), options_.messages);
      return cli::k_ok;
    }
    CsvFile file(csv_);
    if (!earlier_ && !choice_.found && !prepared_.regimes)
      rounding_.emplace(prepared_, *choice_.engine, choice_.setting);
    const Simulated run = write_rows(file);
    // There was no motion at all, so there is no table of one.
    if (!run.why.empty() && run.samples == 0) {
      const bool is_setting = run.outcome == gauss::simulate::Outcome::bad_settings;
      return cli::fail(run.why, is_setting ? cli::k_usage_error : cli::k_motion_stopped, options_.messages);
    }
    const FinishedRun finished{prepared_, choice_.setting, choice_.engine->name(), run,
                               times,     errors_of(run),  choice_.found,          earlier_ ? earlier_->asked_for : "",
                               csv_};
    const std::string text = summary_of(finished);
    file.finish();
    if (csv_ != "-") cli::Replacement(summary_path(csv_), text).commit();
    if (csv_ != "-" && prepared_.regimes)
      cli::Replacement(events_path(csv_), events_csv(run.events, prepared_.regimes->switches())).commit();
    if (!options_.quiet && csv_ != "-") tell(finished);
    return report_end(finished, run.samples > (earlier_ ? earlier_->run.samples : 1), options_.messages);
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
    if (const int code = take_engine(number_name(prepared_.scene)); code != cli::k_ok) return code;
    warn_of_interpreting(engines_.times(), options_.messages);
    choice_.setting = setting_of(prepared_, *choice_.engine);
    check_outputs(csv_, {options_.file, prepared_.model_file});
    if (options_.resume && csv_ == "-") throw cli::UsageError("--resume: standard output cannot be gone on with");
    if (!prepared_.scene.error) return cli::k_ok;
    if (!options_.resume) return search(find);
    // What was found then goes on; what would be found now may be another setting.
    choice_.setting = setting_of_earlier_run(summary_path(csv_));
    return take_engine(choice_.setting.number);
  }

  double budget() const { return options_.budget.value_or(Wanted().budget); }

  int take_engine(const std::string& number) {
    choice_.engine = engines_.of(number);
    return choice_.engine != nullptr ? cli::k_ok : cli::fail(engines_.why(), cli::k_file_error, options_.messages);
  }

  int search(const FindSetting& find) {
    std::string why;
    try {
      choice_.found = find(prepared_, engines_, {*prepared_.scene.error, budget(), !options_.quiet}, why);
    } catch (const Interrupted&) {
      cli::remark("interrupted while a setting was looked for; nothing is written", options_.messages);
      return cli::k_interrupted;
    }
    if (!choice_.found) return cli::fail(why, cli::k_not_delivered, options_.messages);
    choice_.setting = choice_.found->chosen.setting;
    return take_engine(choice_.setting.number);
  }

  Simulated write_rows(CsvFile& file) {
    file.write(earlier_ ? earlier_->table : csv_header(prepared_.columns.columns));
    rows_ = Rows(prepared_.columns.columns.size(), prepared_.span.samples);
    ProgressBar bar(!options_.quiet);
    StandstillWatch standstill(prepared_, options_.messages, bar);
    Listeners listeners;
    listeners.on_row = [&](const std::string& row, double share) {
      file.write(row);
      bar.show(share, prepared_.name());
      return true;
    };
    listeners.on_numbers = [&](long k, const std::vector<long double>& row) {
      rows_.set(k, row);
      if (choice_.setting.step <= 0) standstill.look(k);
    };
    if (rounding_) {
      listeners.on_state = [&](long k, long double t, const std::vector<long double>& state) {
        rounding_->note(k, t, state);
      };
    }
    return simulate(prepared_, *choice_.engine, choice_.setting, listeners, earlier_ ? &earlier_->run : nullptr);
  }

  /// Of all rows; so nothing of a run that goes on, which has the last ones alone.
  KnownErrors errors_of(const Simulated& run) {
    KnownErrors errors;
    if (earlier_) {
      errors.why_none.text = "the run went on from an earlier one";
      return errors;
    }
    const auto& [setting, engine, found] = choice_;
    errors.estimate = found ? estimate_by(found->reference, rows_, prepared_, setting)
                            : estimated(prepared_, *engine, engines_, setting, run, rows_,
                                        rounding_ ? &*rounding_ : nullptr, errors.why_none);
    if (!errors.estimate && rounding_ && rows_.samples() > 1) errors.lost = rounding_->lost_in(rows_);
    if (const ClosedForms forms(prepared_); forms.are_there())
      errors.from_closed_forms = from_closed_forms(forms, prepared_, setting, rows_);
    return errors;
  }

  const RunOptions& options_;
  const PreparedModel& prepared_;
  std::string csv_;
  Engines engines_;
  Choice choice_;
  std::optional<EarlierRun> earlier_;
  Rows rows_{0, 0};
  std::optional<RoundingCheck> rounding_;  ///< of a run that begins now, and whose setting nobody has looked for
};

}  // namespace

int run(const RunOptions& options, const FindSetting& find) {
  const Interruption interruption;
  int code = cli::k_ok;
  const auto prepared = prepare_run(options, code);
  if (!prepared) return code;
  return Run(options, *prepared).make(find);
}

}  // namespace gausssim
