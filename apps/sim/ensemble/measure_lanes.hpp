#pragma once
// What lanes and threads are worth for a model: a part of studies.

#include <string>
#include <vector>

#include "sim/run/prepare.hpp"

namespace gausssim {

/// Some trajectories, integrated in one of the ways that there are. docs/study-format.md, lanes.
struct LanesRow {
  std::string number = "double";
  int lanes = 1, threads = 1;
  long trajectories = 0;
  double trajectories_per_s = 0;
  double ratio = 1;  ///< to one after the other on one thread
};

struct LanesEffort {
  double tolerance = 1e-9;
  double seconds = 1;  ///< about as long does one trajectory after the other take
  int repeats = 3;     ///< the fastest counts
  int threads = 0;     ///< the most; 0: as many as there are processors
};

/// The motion of the model, its start changed a little from one trajectory to the next, to its end: first one after the other on one thread, then in lanes, then both with all threads.
/// By power series, else by `prince87` and without lanes. Nothing, with the reason in `why`, where the model cannot be run so.
std::vector<LanesRow> measure_lanes(const PreparedModel& prepared, const LanesEffort& effort, std::string& why);

}  // namespace gausssim
