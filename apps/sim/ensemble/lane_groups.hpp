#pragma once
// As many trajectories at a time as a register has lanes.

#include <vector>

#include "sim/ensemble/lanes.hpp"
#include "sim/ensemble/trajectory.hpp"

namespace gausssim {

/// One thread's groups. What stops in a lane is run again by itself: that says why it stops, and goes on where lanes cannot.
class LaneGroups {
 public:
  LaneGroups(const PreparedModel& prepared, const LanesKernel& kernel, const Setting& setting,
             Trajectories<double>& alone);

  /// Trajectories `first` to `last` - 1: one track for each.
  void run(long first, long last, std::vector<Track<double>>& tracks);

 private:
  void load(long first, std::vector<Track<double>>& tracks);
  void give_back(std::size_t place);
  void take(std::size_t place, Track<double>& track);

  const LanesKernel& kernel_;
  Trajectories<double>& alone_;
  std::size_t size_;                 ///< of a state
  std::vector<std::size_t> loaded_;  ///< which tracks
  std::vector<double> prepared_, inputs_, start_, times_, states_, steps_;
  std::vector<long> arrived_;
  LanesJob job_{};
  bool projects_samples_ = false;
};

}  // namespace gausssim
