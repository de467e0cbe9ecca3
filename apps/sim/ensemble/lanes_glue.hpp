// As many trajectories as a register has lanes, behind a plain function: a part of plugins, compiled with the model.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <memory>

#include "gauss/batch/taylor_lanes.hpp"
#include "gauss/integrate/bound_model.hpp"

namespace gauss_sim_glue {

/// As apps/sim/ensemble/lanes.hpp writes it. Arrays have the lanes of one number next to each other.
struct LanesJob {
  const double *prepared, *inputs, *start;
  const double* times;  ///< of samples; the last one is the end
  long samples;
  double start_time, tolerance;
  long projects, most_steps;
  double* states;  ///< sample by sample
  double* steps;
  long* arrived;  ///< whether a lane is at the end
};

/// A struct of emitted code holds scalars only, so it is an array of them.
template <class Struct, class Batch>
Struct struct_of_lanes(const double* from) {
  Struct result{};
  constexpr std::size_t count = std::is_empty_v<Struct> ? 0 : sizeof(Struct) / sizeof(Batch);
  static_assert(std::is_empty_v<Struct> || sizeof(Struct) % sizeof(Batch) == 0, "a struct holds scalars only");
  auto* const numbers = reinterpret_cast<Batch*>(&result);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = Batch::load_unaligned(from + i * Batch::size);
  return result;
}

/// What samples see of a motion: values of the series within each step.
template <class Lanes, std::size_t size>
class LaneSamples {
 public:
  explicit LaneSamples(const LanesJob& job) : job_(job) {}

  void look(const Lanes& lanes, int order) {
    double begin[L], reached[L];
    lanes.begin_of_step().store_unaligned(begin);
    lanes.times().store_unaligned(reached);
    for (std::size_t lane = 0; lane < L; ++lane) {
      long& k = next_[lane];
      // What was taken from a step that did not hold is taken again.
      while (k > 0 && job_.times[k - 1] > begin[lane]) --k;
      for (; k + 1 < job_.samples && job_.times[k] <= reached[lane]; ++k)
        take(lanes, lane, order, k, job_.times[k] - begin[lane]);
    }
  }

 private:
  static constexpr std::size_t L = Lanes::lanes;

  void take(const Lanes& lanes, std::size_t lane, int order, long k, double h) {
    double* const to = job_.states + static_cast<std::size_t>(k) * size * L + lane;
    for (std::size_t i = 0; i < size; ++i) {
      double x = 0;
      for (int p = order; p >= 0; --p) x = x * h + lanes.series().values[p][i].get(lane);
      to[i * L] = x;
    }
  }

  const LanesJob& job_;
  long next_[L] = {};
};

template <class Type, class Batch, class Series>
int run_lanes(LanesJob& job) {
  using Prepared = typename Type::template Prepared<Batch>;
  using Inputs = typename Type::template Inputs<Batch>;
  using Model = decltype(gauss::integrate::bind_model<Type, Batch>(std::declval<const Prepared&>(),
                                                                   std::declval<const Inputs&>()));
  using State = typename Model::State;
  using Lanes = gauss::batch::TaylorLanes<Model, Series>;
  gauss::simulate::Settings<double> settings;
  settings.tolerance = job.tolerance;
  settings.project = job.projects != 0;
  settings.most_steps = job.most_steps;
  const auto lanes =
      std::make_unique<Lanes>(gauss::integrate::bind_model<Type, Batch>(struct_of_lanes<Prepared, Batch>(job.prepared),
                                                                        struct_of_lanes<Inputs, Batch>(job.inputs)),
                              struct_of_lanes<State, Batch>(job.start), Batch(job.start_time), settings);
  const double end = job.times[job.samples - 1];
  LaneSamples<Lanes, Model::size> samples(job);
  for (long taken = 0; lanes->are_under_way(end) && taken < job.most_steps; ++taken) {
    lanes->step_towards(end);
    if (job.samples > 1) samples.look(*lanes, lanes->series().order);
  }
  double* const last = job.states + static_cast<std::size_t>(job.samples - 1) * Model::size * Batch::size;
  for (std::size_t i = 0; i < Model::size; ++i) lanes->states().values[i].store_unaligned(last + i * Batch::size);
  lanes->steps_of_lanes().store_unaligned(job.steps);
  for (std::size_t lane = 0; lane < Batch::size; ++lane)
    job.arrived[lane] = lanes->times().get(lane) >= end && !lanes->lost().get(lane) ? 1 : 0;
  return 0;
}

}  // namespace gauss_sim_glue
