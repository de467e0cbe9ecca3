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

  /// Trajectories `first` to `last` - 1, no more than there are lanes: one track for each.
  void run(long first, long last, std::vector<Track<double>>& tracks);

 private:
  std::size_t lanes() const { return static_cast<std::size_t>(kernel_.lanes()); }
  void load(long first, long last, std::vector<Track<double>>& tracks);
  void put(std::size_t lane, const Numbers<double>& state);
  void give_back(std::size_t lane);
  void take(std::size_t lane, Track<double>& track);

  const LanesKernel& kernel_;
  Trajectories<double>& alone_;
  std::vector<double> prepared_, inputs_, start_, times_, states_, steps_;
  std::vector<long> arrived_;
  LanesJob job_{};
  bool projects_samples_;
};

}  // namespace gausssim
