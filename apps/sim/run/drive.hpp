#pragma once
// A run: states at the times that are asked for, and what became of what should not change.

#include <vector>

#include "sim/drive/integrator.hpp"
#include "sim/output/sampler.hpp"
#include "sim/run/times.hpp"

namespace gausssim {

/// How far a motion is from what holds for it, over the samples of a run.
struct Drift {
  bool has_energy = false;  ///< it is the same in every motion of this model
  double energy = 0;        ///< largest change since the start [J]
  double energy_scale = 0;  ///< largest kinetic energy [J]
  bool has_constraints = false;
  double positions = 0;   ///< largest residual of an equation of positions, in its unit
  double velocities = 0;  ///< of a constraint of velocities, or a rate of such an equation
};

template <class S>
Grid<S> grid_of(const Span& span) {
  return {S(span.start), S(span.start) + S(span.duration), span.samples, S(span.every)};
}

/// A state at a time that was asked for, the k-th. `results`: of the functions that were expected; null: they are still to be called.
template <class S>
struct Sample {
  long k;
  S t;
  const S *state, *results;
};

/// How many samples there are in the end, those of an earlier run before `expected` too. `on_sample(sample)`: returning false ends it.
template <class S, class OnSample>
long drive(Integrator<S>& integrator, const Samples<S>& expected, const OnSample& on_sample) {
  const Grid<S>& grid = expected.grid;
  integrator.expect(expected);
  for (long k = expected.next; k < grid.samples;) {
    const S end = grid.at(k);
    if (!integrator.advance_to(end)) return k;
    const Found<S> found = integrator.found();
    const S *state = found.states, *results = found.results;
    for (long i = 0; i < found.count; ++i, ++k, state += found.size, results += found.result_size) {
      const S t = found.times == nullptr ? end : found.times[i];
      if (!on_sample(Sample<S>{k, t, state, results})) return k + 1;
    }
  }
  return grid.samples;
}

/// Looks at states as they come.
template <class S>
class DriftMeter {
 public:
  DriftMeter(const Functions<S>& functions, const Described& model);

  void look(const S& t, const S* state);
  const Drift& drift() const { return drift_; }
  /// As if it had looked at the states of an earlier run, too.
  void go_on_from(const Drift& earlier, const S& start_energy);
  const S& start_energy() const { return start_energy_; }
  /// At the state that was looked at last.
  double energy() const { return drift_.energy_scale > 0 ? last_energy_ / drift_.energy_scale : last_energy_; }
  double constraints() const { return last_constraints_; }

 private:
  void look_at_energy(const S& t, const S* state);
  void look_at_constraints(const S& t, const S* state);

  const Functions<S>& functions_;
  std::size_t kinetic_ = 0, total_ = 0;  ///< slots
  std::vector<std::size_t> positions_, velocities_;
  std::vector<S> energy_, residuals_, rates_;
  bool has_start_ = false;
  S start_energy_ = 0;
  double last_energy_ = 0, last_constraints_ = 0;
  Drift drift_;
};

}  // namespace gausssim
