#pragma once
// What a run was: for who waits at the terminal, and for its summary.

#include <optional>
#include <string>

#include "sim/run/build_engine.hpp"
#include "sim/run/found_setting.hpp"
#include "sim/run/known_errors.hpp"

namespace gausssim {

struct FinishedRun {
  const PreparedModel& prepared;
  const Setting& setting;
  std::string engine;
  const Simulated& run;
  EngineTimes times;
  KnownErrors errors;
  const std::optional<FoundSetting>& found;  ///< nothing: no error was asked for
  std::string asked_before;  ///< JSON, of a run that this one went on from and whose setting was looked for; else empty
  std::string csv;           ///< the table; "-": standard output
};

/// How often each of its events was; those that were most often first.
std::string events_in_words(const Simulated& run);

/// Some lines on standard output.
void tell(const FinishedRun& finished);

/// Of what is not as it should be, on standard error; returns the exit code. `has_new_rows`: more than what it went on from.
int report_end(const FinishedRun& finished, bool has_new_rows, const gaussgen::cli::MessageOptions& messages);

}  // namespace gausssim
