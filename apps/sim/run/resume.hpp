#pragma once
// What an interrupted run has left, for one that goes on from it.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "sim/run/simulate.hpp"

namespace gausssim {

struct EarlierRun {
  std::string table;  ///< the CSV
  Simulated run;
  bool is_finished = false;
  std::string asked_for;  ///< JSON, of a run whose setting was looked for; empty: none was
};

/// How the run of the summary at `path` was made. Throws cli::FileError.
Setting setting_of_earlier_run(const std::string& path);

/// What the summary of a run says for one that goes on from it.
nlohmann::ordered_json resume_json(const PreparedModel& prepared, const Simulated& run);

/// Reads table and summary. Throws cli::FileError where they cannot be read or do not belong to each other, and cli::UsageError where they are of another run.
EarlierRun read_earlier_run(const std::string& csv, const std::string& summary, const PreparedModel& prepared,
                            const Setting& setting);

}  // namespace gausssim
