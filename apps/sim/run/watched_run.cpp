#include "sim/run/watched_run.hpp"

#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "sim/run/settings.hpp"
#include "sim/run/standstill.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;

void warn_of_tolerance(const Setting& setting, const cli::MessageOptions& messages) {
  const double least = least_tolerance(setting.number);
  if (setting.tolerance > 0 && setting.tolerance < least)
    cli::warn(fmt::format("in {}, rounding is more than tolerances below {:.0e}: {} brings nothing", setting.number,
                          least, setting.tolerance),
              messages);
}

WatchedRun::WatchedRun(const RunOptions& options, const PreparedModel& prepared)
    : options_(options), prepared_(prepared), engines_(prepared, engine_choice(prepared.scene)) {}

int WatchedRun::take_engine(const std::string& number) {
  engine_ = engines_.of(number);
  return engine_ != nullptr ? cli::k_ok : cli::fail(engines_.why(), cli::k_file_error, options_.messages);
}

int WatchedRun::choose() {
  if (const int code = take_engine(number_name(prepared_.scene)); code != cli::k_ok) return code;
  setting_ = setting_of(prepared_, *engine_);
  return cli::k_ok;
}

int WatchedRun::take(const Setting& setting) {
  setting_ = setting;
  return take_engine(setting_.number);
}

int WatchedRun::take(FoundSetting found) {
  found_ = std::move(found);
  return take(found_->chosen.setting);
}

Simulated WatchedRun::run(const std::function<void(const std::string& row)>& on_row, const EarlierRun* earlier) {
  setting_.most_steps = options_.max_steps.value_or(0);
  if (earlier == nullptr && !found_ && !prepared_.regimes) rounding_.emplace(prepared_, *engine_, setting_);
  rows_ = Rows(prepared_.columns.columns.size(), prepared_.span.samples);
  ProgressBar bar(!options_.quiet);
  StandstillWatch standstill(prepared_, options_.messages, bar);
  Listeners listeners;
  listeners.on_row = [&](const std::string& row, double share) {
    on_row(row);
    bar.show(share, prepared_.name());
    return true;
  };
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) {
    rows_.set(k, row);
    if (setting_.step <= 0) standstill.look(k);
  };
  if (rounding_) {
    listeners.on_state = [&](long k, long double t, const std::vector<long double>& state) {
      rounding_->note(k, t, state);
    };
  }
  return simulate(prepared_, *engine_, setting_, listeners, earlier == nullptr ? nullptr : &earlier->run);
}

KnownErrors WatchedRun::errors_of(const Simulated& run, bool went_on) {
  KnownErrors errors;
  if (went_on) {
    errors.why_none.text = "the run went on from an earlier one";
    return errors;
  }
  errors.estimate = found_ ? estimate_by(found_->reference, rows_, prepared_, setting_)
                           : estimated(prepared_, *engine_, engines_, setting_, run, rows_,
                                       rounding_ ? &*rounding_ : nullptr, errors.why_none);
  if (!errors.estimate && rounding_ && rows_.samples() > 1) errors.lost = rounding_->lost_in(rows_);
  if (const ClosedForms forms(prepared_); forms.are_there())
    errors.from_closed_forms = from_closed_forms(forms, prepared_, setting_, rows_);
  return errors;
}

}  // namespace gausssim
