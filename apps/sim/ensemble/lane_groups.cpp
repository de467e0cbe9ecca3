#include "sim/ensemble/lane_groups.hpp"

#include <algorithm>

#include "gauss/integrate/step_result.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

using gauss::integrate::is_motion_known;

LaneGroups::LaneGroups(const PreparedModel& prepared, const LanesKernel& kernel, const Setting& setting,
                       Trajectories<double>& alone)
    : kernel_(kernel), alone_(alone), size_(prepared.model.size()) {
  const Grid<double>& grid = alone_.grid();
  for (long k = 0; k < grid.samples; ++k) times_.push_back(grid.at(k));
  const bool projects = setting.projection != Projection::off && alone_.functions().projection;
  projects_samples_ = projects && times_.size() > 1;
  job_.times = times_.data();
  job_.samples = static_cast<long>(times_.size());
  job_.start_time = grid.start;
  job_.tolerance = setting.tolerance;
  job_.longest_step = setting.longest_step;
  job_.projects = projects ? 1 : 0;
  job_.most_steps = MethodSettings<double>().most_steps;
  job_.ends = Interruption::is_asked_for;
}

/// Those that have a start, without gaps.
void LaneGroups::load(long first, std::vector<Track<double>>& tracks) {
  for (std::vector<double>* const all : {&prepared_, &inputs_, &start_}) all->clear();
  loaded_.clear();
  Numbers<double> state;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    Ended& ended = tracks[i].ended;
    ended.status = alone_.begin(first + static_cast<long>(i), state);
    ended.reached = alone_.grid().start;
    if (!is_motion_known(ended.status)) {
      ended.how = Ended::How::without_start;
      continue;
    }
    const Functions<double>& functions = alone_.functions();
    prepared_.insert(prepared_.end(), functions.prepared.begin(), functions.prepared.end());
    inputs_.insert(inputs_.end(), functions.inputs.begin(), functions.inputs.end());
    start_.insert(start_.end(), state.begin(), state.end());
    loaded_.push_back(i);
  }
}

/// Outputs read the values of the trajectory that they are of.
void LaneGroups::give_back(std::size_t place) {
  const auto gather = [&](const std::vector<double>& from, std::vector<double>& to) {
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(place * to.size()), to.size(), to.begin());
  };
  gather(prepared_, alone_.functions().prepared);
  gather(inputs_, alone_.functions().inputs);
}

void LaneGroups::take(std::size_t place, Track<double>& track) {
  track.ended.how = Ended::How::finished;
  track.ended.reached = times_.back();
  track.ended.steps = static_cast<long>(steps_[place]);
  Numbers<double> found(size_);
  for (std::size_t k = 0; k < times_.size(); ++k) {
    const double* const state = states_.data() + (place * times_.size() + k) * size_;
    // The end is on the constraints already.
    const bool projects = projects_samples_ && k + 1 < times_.size();
    const bool is_moved = projects && is_motion_known(alone_.functions().projection(times_[k], state, found.data()));
    alone_.add_row(times_[k], is_moved ? found.data() : state, track);
  }
}

void LaneGroups::run(long first, long last, std::vector<Track<double>>& tracks) {
  tracks.resize(static_cast<std::size_t>(last - first));
  for (Track<double>& track : tracks) track.clear();
  load(first, tracks);
  if (loaded_.empty()) return;
  constexpr long k_not_done = -1;
  states_.assign(loaded_.size() * times_.size() * size_, 0);
  steps_.assign(loaded_.size(), 0);
  arrived_.assign(loaded_.size(), k_not_done);
  job_.prepared = prepared_.data();
  job_.inputs = inputs_.data();
  job_.start = start_.data();
  job_.count = static_cast<long>(loaded_.size());
  job_.states = states_.data();
  job_.steps = steps_.data();
  job_.arrived = arrived_.data();
  kernel_.run(job_);
  for (std::size_t place = 0; place < loaded_.size(); ++place) {
    Track<double>& track = tracks[loaded_[place]];
    if (arrived_[place] == 1) {
      give_back(place);
      take(place, track);
    } else if (arrived_[place] != k_not_done) {
      alone_.run(first + static_cast<long>(loaded_[place]), track);
      track.ended.left_lane = true;
    }
  }
}

}  // namespace gausssim
