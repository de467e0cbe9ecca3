#pragma once
// One trajectory after the other, by any method.

#include <string>
#include <vector>

#include "sim/ensemble/starts.hpp"
#include "sim/output/sampler.hpp"
#include "sim/run/drive.hpp"
#include "sim/run/simulate.hpp"

namespace gausssim {

/// What became of a trajectory.
struct Ended {
  enum class How : unsigned char { not_run, finished, without_start, stopped };
  How how = How::not_run;
  gauss::simulate::Outcome outcome = gauss::simulate::Outcome::running;  ///< why it stopped
  gauss::Status status = gauss::Status::ok;
  double reached = 0;  ///< time
  long steps = 0, rejected = 0;
  bool left_lane = false;  ///< and was run by itself
  long untrusted = 0;      ///< rows in which an output had a status that is not ok
};

/// In a word or three, for tables.
std::string status_text(const Ended& ended);

/// Rows of one trajectory: at its samples, or at its end alone.
template <class S>
struct Track {
  Ended ended;
  std::vector<S> times;
  std::vector<S> rows;  ///< all columns of the first time, of the second, …

  void clear() { ended = {}, times.clear(), rows.clear(); }
};

/// One thread's simulations of one model.
template <class S>
class Trajectories {
 public:
  Trajectories(const PreparedModel& prepared, const Engine& engine, const Setting& setting, const Starts<S>& starts,
               bool records_samples);

  /// Throws cli::UsageError where the method does not take the model.
  void run(long trajectory, Track<S>& track);

  /// Parts of a run, for those who integrate elsewhere.
  gauss::Status begin(long trajectory, Numbers<S>& state) { return starts_.begin(trajectory, bound_, state); }
  /// `found`: of the functions of the columns, where that is known.
  void add_row(const S& t, const S* state, Track<S>& track, const S* found = nullptr);
  Functions<S>& functions() { return *bound_.functions; }
  const Grid<S>& grid() const { return grid_; }

 private:
  void integrate(const Numbers<S>& start, const Grid<S>& grid, bool keeps_all, Track<S>& track);

  const Setting& setting_;
  const Starts<S>& starts_;
  Bound<S> bound_;
  MotionModel<S> model_;
  Grid<S> samples_, grid_;
  bool records_samples_;
  Sampler<S> sampler_;
  MethodSettings<S> settings_;
};

}  // namespace gausssim
