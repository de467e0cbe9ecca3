// Steps by power series behind plain functions: a part of plugins, compiled with the model, whose sizes are known there.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/simulate/taylor_simulation.hpp"

namespace gauss_sim_glue {

/// As apps/sim/drive/series.hpp reads it.
struct Told {
  long outcome, status, steps, rejected, calls, fewer, order, moved_component;
};

/// Where samples are found one by one.
struct NoSamples {
  NoSamples(const void*, const void*) {}
  static constexpr std::size_t most = 1;
};

/// `Type` is made by GAUSS_MODEL. `Samples`: as samples_glue.hpp has it, or none.
template <class Type, class S, class Series, class Samples = NoSamples>
class Run {
  using Model =
      decltype(gauss::integrate::bind_model<Type, S>(*static_cast<const typename Type::template Prepared<S>*>(nullptr),
                                                     *static_cast<const typename Type::template Inputs<S>*>(nullptr)));
  using State = typename Model::State;
  using Settings = gauss::simulate::Settings<S>;

 public:
  /// Numbers: tolerance, 1 to project, most steps, order or 0, longest step or 0.
  Run(const void* prepared, const void* inputs, const void* start, const S& t, const S* numbers, bool (*ends)())
      : simulation_(
            gauss::integrate::bind_model<Type, S>(*static_cast<const typename Type::template Prepared<S>*>(prepared),
                                                  *static_cast<const typename Type::template Inputs<S>*>(inputs)),
            *static_cast<const State*>(start), t, settings_of(numbers, ends), static_cast<int>(numbers[3])),
        samples_(prepared, inputs),
        are_found_together_(Samples::most > 1 && numbers[1] > S(0)) {}

  /// `state`: where it is until the next call.
  int advance_to(const S& end, const S*& state) {
    const bool arrives = simulation_.advance_to(end);
    state = simulation_.state().values;
    return arrives ? 1 : 0;
  }

  /// To the first of `count` times, and to those after it that its step has, too: `count` is how many these are then. One is found as advance_to has it, with no results;
  /// several are in `states` and `results`, one after another.
  int advance_to_several(const S* times, long& count, const S*& state, S* states, S* results) {
    long found = 1;
    if (are_found_together_ && simulation_.time() < times[0]) {
      if (!simulation_.step_to(times[0])) {
        count = 1;
        return advance_to(times[0], state);
      }
      const S end = simulation_.begin_of_step() + simulation_.span();
      while (found < count && times[found] <= end) ++found;
    }
    count = found > 1 && look(times, found, states, results) ? found : 1;
    if (count == 1) return advance_to(times[0], state);
    state = states;
    return 1;
  }

  void tell(Told& told, S& t, S& moved) const {
    const auto& report = simulation_.report();
    told = {static_cast<long>(report.outcome),
            static_cast<long>(report.status),
            report.steps,
            report.rejected,
            report.calls,
            report.with_fewer_constraints,
            simulation_.order(),
            static_cast<long>(report.start_component)};
    t = simulation_.time();
    moved = report.start_moved;
  }

 private:
  static Settings settings_of(const S* numbers, bool (*ends)()) {
    Settings settings;
    settings.tolerance = numbers[0];
    settings.project = numbers[1] > S(0);
    settings.most_steps = static_cast<long>(numbers[2]);
    settings.longest_step = numbers[4];
    settings.ends = ends;
    return settings;
  }

  /// Lanes without a time of their own have the last one.
  bool look(const S* times, long count, S* states, S* results) {
    if constexpr (Samples::most > 1) {
      S all[Samples::most];
      for (long i = 0; i < static_cast<long>(Samples::most); ++i) all[i] = times[std::min(i, count - 1)];
      are_found_together_ = samples_.look(simulation_, all, states, results);
    }
    return are_found_together_;
  }

  gauss::simulate::TaylorSimulation<Model, Series> simulation_;
  Samples samples_;
  bool are_found_together_;  ///< where there is projection, and until one of them was not ok
};

template <class Type, class S, class Series, class Samples = NoSamples>
int call(int what, void* const* a) {
  using This = Run<Type, S, Series, Samples>;
  switch (what) {
    case 0:
      *static_cast<void**>(a[0]) = new This(a[1], a[2], a[3], *static_cast<const S*>(a[4]), static_cast<const S*>(a[5]),
                                            *static_cast<bool (**)()>(a[6]));
      return 0;
    case 1: return static_cast<This*>(a[0])->advance_to(*static_cast<const S*>(a[1]), *static_cast<const S**>(a[2]));
    case 2:
      static_cast<const This*>(a[0])->tell(*static_cast<Told*>(a[1]), *static_cast<S*>(a[2]), *static_cast<S*>(a[3]));
      return 0;
    case 4:
      return static_cast<This*>(a[0])->advance_to_several(static_cast<const S*>(a[1]), *static_cast<long*>(a[2]),
                                                          *static_cast<const S**>(a[3]), static_cast<S*>(a[4]),
                                                          static_cast<S*>(a[5]));
    default: delete static_cast<This*>(a[0]); return 0;
  }
}

}  // namespace gauss_sim_glue
