#pragma once
// All trajectories of an ensemble.

#include <functional>
#include <string>
#include <vector>

#include "sim/ensemble/lanes.hpp"
#include "sim/ensemble/trajectory.hpp"

namespace gausssim {

struct Outcomes {
  std::vector<Ended> ended;    ///< of each trajectory
  std::size_t width = 0;       ///< numbers in a row
  std::vector<double> finals;  ///< the last row of each; where it has none, no numbers
  double wall_seconds = 0, cpu_seconds = 0;

  long run() const;  ///< how many
  long steps() const;
  long untrusted() const;
  long left_lane() const;
};

struct EnsembleSetting {
  Setting setting;
  int threads = 1;
  const LanesKernel* lanes = nullptr;  ///< null: one trajectory after the other
  bool records_samples = false;
};

struct EnsembleListeners {
  std::function<void(const std::string& rows)> on_rows =
      nullptr;                                          ///< in the order of trajectories; empty: no rows are made
  std::function<void(double share)> on_wait = nullptr;  ///< may be empty
};

/// The same for any number of threads. Ends early where an interruption is asked for, with the first trajectories, however many have ended by then. Throws cli::UsageError where the method does not take the model.
Outcomes run_all(const PreparedModel& prepared, const Engine& engine, const EnsembleSetting& setting,
                 const Source& source, const EnsembleListeners& listeners);

}  // namespace gausssim
