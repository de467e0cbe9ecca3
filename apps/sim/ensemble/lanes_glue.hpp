// As many trajectories at a time as a register has lanes, behind a plain function: a part of plugins, compiled with the model.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <memory>

#include "gauss/batch/taylor_lanes.hpp"
#include "gauss/integrate/bound_model.hpp"

namespace gauss_sim_glue {

/// As apps/sim/ensemble/lanes.hpp writes it.
struct LanesJob {
  const double *prepared, *inputs, *start;
  long count;
  const double* times;
  long samples;
  double start_time, tolerance, longest_step;
  long projects, most_steps;
  bool (*ends)();
  double* states;
  double* steps;
  long* arrived;
};

/// A struct of emitted code holds scalars only, so it is an array of them.
template <class Struct, class Batch>
class StructOfLanes {
 public:
  const Struct& all() const { return all_; }

  /// What one lane has of it, number by number.
  void put(std::size_t lane, const double* from) {
    auto* const numbers = reinterpret_cast<double*>(&all_);
    for (std::size_t i = 0; i < count; ++i) numbers[i * Batch::size + lane] = from[i];
  }

  static constexpr std::size_t count = std::is_empty_v<Struct> ? 0 : sizeof(Struct) / sizeof(Batch);

 private:
  static_assert(std::is_empty_v<Struct> || sizeof(Struct) % sizeof(Batch) == 0, "a struct holds scalars only");
  Struct all_{};
};

/// Trajectories one after another in each lane, in their order: what is in one lane does not wait for what is in others.
template <class Type, class Batch, class Series>
class LanesRun {
  using Prepared = typename Type::template Prepared<Batch>;
  using Inputs = typename Type::template Inputs<Batch>;
  using Model = decltype(gauss::integrate::bind_model<Type, Batch>(std::declval<const Prepared&>(),
                                                                   std::declval<const Inputs&>()));
  using State = typename Model::State;
  using Lanes = gauss::batch::TaylorLanes<Model, Series>;
  using Mask = typename Batch::batch_bool_type;
  static constexpr std::size_t L = Batch::size;

 public:
  explicit LanesRun(LanesJob& job) : job_(job), end_(job.times[job.samples - 1]) {
    for (std::size_t lane = 0; lane < L; ++lane) {
      // A lane without a trajectory has numbers with which nothing goes wrong.
      load(lane, next_ < job_.count ? next_ : 0);
      of_lane_[lane] = next_ < job_.count ? next_++ : k_none;
    }
    lanes_ = std::make_unique<Lanes>(model(), start_.all(), Batch(job.start_time), settings());
    lanes_->stop(lanes_where([&](std::size_t lane) { return of_lane_[lane] == k_none; }));
  }

  void run() {
    while (is_busy() && !job_.ends()) {
      lanes_->step_towards(end_);
      for (std::size_t lane = 0; lane < L && job_.samples > 1; ++lane) look(lane);
      const Mask done = lanes_->are_done(end_);
      for (std::size_t lane = 0; lane < L; ++lane)
        is_done_[lane] = of_lane_[lane] != k_none && (done.get(lane) || ++tried_[lane] >= job_.most_steps);
      if (any(is_done_)) go_on();
    }
  }

 private:
  static constexpr long k_none = -1;

  gauss::simulate::Settings<double> settings() const {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = job_.tolerance;
    settings.longest_step = job_.longest_step;
    settings.project = job_.projects != 0;
    settings.most_steps = job_.most_steps;
    return settings;
  }

  Model model() const { return gauss::integrate::bind_model<Type, Batch>(prepared_.all(), inputs_.all()); }

  template <class Is>
  static Mask lanes_where(const Is& is) {
    double marks[L];
    for (std::size_t lane = 0; lane < L; ++lane) marks[lane] = is(lane) ? 1 : 0;
    return Batch::load_unaligned(marks) > Batch(0.5);
  }

  static bool any(const bool (&of)[L]) { return std::find(of, of + L, true) != of + L; }
  bool is_busy() const {
    return std::any_of(of_lane_, of_lane_ + L, [](long trajectory) { return trajectory != k_none; });
  }

  void load(std::size_t lane, long trajectory) {
    prepared_.put(lane, job_.prepared + trajectory * prepared_.count);
    inputs_.put(lane, job_.inputs + trajectory * inputs_.count);
    start_.put(lane, job_.start + trajectory * start_.count);
    tried_[lane] = next_sample_[lane] = 0;
  }

  /// Lanes that are done give back what they have, and take what comes next.
  void go_on() {
    bool begins[L] = {};
    for (std::size_t lane = 0; lane < L; ++lane) {
      if (!is_done_[lane]) continue;
      give_back(lane, of_lane_[lane]);
      begins[lane] = next_ < job_.count;
      of_lane_[lane] = begins[lane] ? next_++ : k_none;
      if (begins[lane]) load(lane, of_lane_[lane]);
    }
    lanes_->stop(lanes_where([&](std::size_t lane) { return of_lane_[lane] == k_none; }));
    if (any(begins))
      lanes_->begin(lanes_where([&](std::size_t lane) { return begins[lane]; }), model(), start_.all(),
                    Batch(job_.start_time));
  }

  double* states(long trajectory, long sample) const {
    return job_.states + static_cast<std::size_t>(trajectory * job_.samples + sample) * Model::size;
  }

  void give_back(std::size_t lane, long trajectory) {
    double* const last = states(trajectory, job_.samples - 1);
    for (std::size_t i = 0; i < Model::size; ++i) last[i] = lanes_->states().values[i].get(lane);
    job_.steps[trajectory] = lanes_->steps_of_lanes().get(lane);
    job_.arrived[trajectory] = lanes_->times().get(lane) >= end_ && !lanes_->lost().get(lane) ? 1 : 0;
  }

  /// What samples see of a motion: values of the series within each step.
  void look(std::size_t lane) {
    if (of_lane_[lane] == k_none) return;
    const double begin = lanes_->begin_of_step().get(lane), reached = lanes_->times().get(lane);
    long& k = next_sample_[lane];
    // What was taken from a step that did not hold is taken again.
    while (k > 0 && job_.times[k - 1] > begin) --k;
    for (; k + 1 < job_.samples && job_.times[k] <= reached; ++k)
      take(lane, job_.times[k] - begin, states(of_lane_[lane], k));
  }

  void take(std::size_t lane, double h, double* to) const {
    const Series& series = lanes_->series();
    for (std::size_t i = 0; i < Model::size; ++i) {
      double x = 0;
      for (int p = series.order; p >= 0; --p) x = x * h + series.values[p][i].get(lane);
      to[i] = x;
    }
  }

  LanesJob& job_;
  double end_;
  StructOfLanes<Prepared, Batch> prepared_;
  StructOfLanes<Inputs, Batch> inputs_;
  StructOfLanes<State, Batch> start_;
  std::unique_ptr<Lanes> lanes_;
  long of_lane_[L] = {}, tried_[L] = {}, next_sample_[L] = {};
  bool is_done_[L] = {};
  long next_ = 0;
};

template <class Type, class Batch, class Series>
int run_lanes(LanesJob& job) {
  std::make_unique<LanesRun<Type, Batch, Series>>(job)->run();
  return 0;
}

}  // namespace gauss_sim_glue
