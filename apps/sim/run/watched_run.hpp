#pragma once
// One run with all that is asked about it: how it is made, its rows, and what its errors are known to be.

#include <functional>
#include <optional>
#include <string>

#include "sim/run/found_setting.hpp"
#include "sim/run/known_errors.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/resume.hpp"
#include "sim/run/run.hpp"

namespace gausssim {

void warn_of_tolerance(const Setting& setting, const gaussgen::cli::MessageOptions& messages);

class WatchedRun {
 public:
  /// `options` and `prepared` outlive this.
  WatchedRun(const RunOptions& options, const PreparedModel& prepared);

  /// As the scene says, what it does not say as defaults are. Another code than success: why has been said.
  int choose();
  /// Another setting, in its number type; likewise.
  int take(const Setting& setting);
  /// One that was looked for.
  int take(FoundSetting found);

  const PreparedModel& prepared() const { return prepared_; }
  const Setting& setting() const { return setting_; }
  const Engine& engine() const { return *engine_; }
  Engines& engines() { return engines_; }
  const std::optional<FoundSetting>& found() const { return found_; }

  /// Rows of the table as they come; `earlier`: of a run that this one goes on from, or null.
  Simulated run(const std::function<void(const std::string& row)>& on_row, const EarlierRun* earlier);

  /// Of all rows; so nothing of a run that went on, which has the last ones alone.
  KnownErrors errors_of(const Simulated& run, bool went_on);

 private:
  int take_engine(const std::string& number);

  const RunOptions& options_;
  const PreparedModel& prepared_;
  Engines engines_;
  Setting setting_;
  const Engine* engine_ = nullptr;
  std::optional<FoundSetting> found_;  ///< nothing: no error was asked for, or it goes on as it was found then
  Rows rows_{0, 0};
  std::optional<RoundingCheck> rounding_;  ///< of a run that begins now, and whose setting nobody has looked for
};

}  // namespace gausssim
