#pragma once
// What the runs of the instances of a scene were: for people, and for programs.

#include <string>
#include <vector>

#include "sim/run/among_instances.hpp"
#include "sim/run/finished_run.hpp"

namespace gausssim {

struct InstancesReport {
  const std::vector<FinishedRun>& runs;  ///< at least one, in the order of the scene
  const AmongInstances& among;
  std::string csv;
  long rows = 0;

  bool has_regimes() const;
};

/// Of one instance, whose outputs have its name in front.
FinishedRun with_full_names(const FinishedRun& run);

/// Some lines.
std::string in_words(const InstancesReport& report);

/// The summary, as docs/scenes.md describes it.
std::string in_json(const InstancesReport& report);

/// What happened to all of them, by its time.
std::string events_csv(const InstancesReport& report);

}  // namespace gausssim
