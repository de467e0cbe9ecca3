#include "sim/ensemble/lane_groups.hpp"

#include <algorithm>

#include "gauss/integrate/step_result.hpp"

namespace gausssim {

using gauss::integrate::is_motion_known;

LaneGroups::LaneGroups(const PreparedModel& prepared, const LanesKernel& kernel, const Setting& setting,
                       Trajectories<double>& alone)
    : kernel_(kernel), alone_(alone) {
  const Functions<double>& functions = alone_.functions();
  const std::size_t width = lanes(), size = prepared.model.size();
  prepared_.assign(functions.prepared.size() * width, 0);
  inputs_.assign(functions.inputs.size() * width, 0);
  start_.assign(size * width, 0);
  steps_.assign(width, 0);
  arrived_.assign(width, 0);
  const Grid<double>& grid = alone_.grid();
  for (long k = 0; k < grid.samples; ++k) times_.push_back(grid.at(k));
  states_.assign(size * width * times_.size(), 0);
  const bool projects = setting.projection != Projection::off && functions.projection;
  projects_samples_ = projects && times_.size() > 1;
  job_ = {prepared_.data(),
          inputs_.data(),
          start_.data(),
          times_.data(),
          static_cast<long>(times_.size()),
          grid.start,
          setting.tolerance,
          projects ? 1 : 0,
          MethodSettings<double>().most_steps,
          states_.data(),
          steps_.data(),
          arrived_.data()};
}

void LaneGroups::put(std::size_t lane, const Numbers<double>& state) {
  const auto spread = [&](const auto& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i * lanes() + lane] = from[i];
  };
  spread(alone_.functions().prepared, prepared_);
  spread(alone_.functions().inputs, inputs_);
  spread(state, start_);
}

/// Outputs read the values of the trajectory that they are of.
void LaneGroups::give_back(std::size_t lane) {
  const auto gather = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i * lanes() + lane];
  };
  gather(prepared_, alone_.functions().prepared);
  gather(inputs_, alone_.functions().inputs);
}

/// Lanes of trajectories without a start, and those behind the last one, do what another lane does.
void LaneGroups::load(long first, long last, std::vector<Track<double>>& tracks) {
  Numbers<double> state;
  std::vector<std::size_t> idle;
  for (std::size_t lane = 0; lane < lanes(); ++lane) {
    const long trajectory = first + static_cast<long>(lane);
    if (trajectory >= last) {
      idle.push_back(lane);
      continue;
    }
    Ended& ended = tracks[lane].ended;
    ended.status = alone_.begin(trajectory, state);
    ended.reached = alone_.grid().start;
    if (is_motion_known(ended.status)) {
      put(lane, state);
    } else {
      ended.how = Ended::How::without_start;
      idle.push_back(lane);
    }
  }
  for (std::size_t like = 0; like < lanes() && !idle.empty(); ++like) {
    if (std::find(idle.begin(), idle.end(), like) != idle.end()) continue;
    for (std::vector<double>* const all : {&prepared_, &inputs_, &start_}) {
      for (const std::size_t lane : idle) {
        for (std::size_t i = 0; i < all->size(); i += lanes()) (*all)[i + lane] = (*all)[i + like];
      }
    }
    return;
  }
}

void LaneGroups::take(std::size_t lane, Track<double>& track) {
  track.ended.how = Ended::How::finished;
  track.ended.reached = times_.back();
  track.ended.steps = static_cast<long>(steps_[lane]);
  const std::size_t size = start_.size() / lanes();
  Numbers<double> state(size), found;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    for (std::size_t i = 0; i < size; ++i) state[i] = states_[(k * size + i) * lanes() + lane];
    found = state;
    // The end is on the constraints already.
    if (projects_samples_ && k + 1 < times_.size() &&
        !is_motion_known(alone_.functions().projection(times_[k], state.data(), found.data())))
      found = state;
    alone_.add_row(times_[k], found.data(), track);
  }
}

void LaneGroups::run(long first, long last, std::vector<Track<double>>& tracks) {
  tracks.resize(static_cast<std::size_t>(last - first));
  for (Track<double>& track : tracks) track.clear();
  load(first, last, tracks);
  const bool is_any = std::any_of(tracks.begin(), tracks.end(),
                                  [](const Track<double>& track) { return track.ended.how == Ended::How::not_run; });
  if (!is_any) return;
  kernel_.run(job_);
  for (std::size_t lane = 0; lane < tracks.size(); ++lane) {
    if (tracks[lane].ended.how != Ended::How::not_run) continue;
    const long trajectory = first + static_cast<long>(lane);
    if (arrived_[lane] == 0) {
      alone_.run(trajectory, tracks[lane]);
      tracks[lane].ended.left_lane = true;
      continue;
    }
    give_back(lane);
    take(lane, tracks[lane]);
  }
}

}  // namespace gausssim
