// Steps by power series behind plain functions: a part of plugins, compiled with the model, whose sizes are known there.
// SPDX-License-Identifier: MIT
#include "gauss/integrate/bound_model.hpp"
#include "gauss/simulate/taylor_simulation.hpp"

namespace gauss_sim_glue {

/// As apps/sim/drive/series.hpp reads it.
struct Told {
  long outcome, status, steps, rejected, calls, fewer, order, moved_component;
};

/// `Type` is made by GAUSS_MODEL.
template <class Type, class S, class Series>
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
            *static_cast<const State*>(start), t, settings_of(numbers, ends), static_cast<int>(numbers[3])) {}

  /// `state`: where it is until the next call.
  int advance_to(const S& end, const S*& state) {
    const bool arrives = simulation_.advance_to(end);
    state = simulation_.state().values;
    return arrives ? 1 : 0;
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

  gauss::simulate::TaylorSimulation<Model, Series> simulation_;
};

template <class Type, class S, class Series>
int call(int what, void* const* a) {
  using This = Run<Type, S, Series>;
  switch (what) {
    case 0:
      *static_cast<void**>(a[0]) = new This(a[1], a[2], a[3], *static_cast<const S*>(a[4]), static_cast<const S*>(a[5]),
                                            *static_cast<bool (**)()>(a[6]));
      return 0;
    case 1: return static_cast<This*>(a[0])->advance_to(*static_cast<const S*>(a[1]), *static_cast<const S**>(a[2]));
    case 2:
      static_cast<const This*>(a[0])->tell(*static_cast<Told*>(a[1]), *static_cast<S*>(a[2]), *static_cast<S*>(a[3]));
      return 0;
    default: delete static_cast<This*>(a[0]); return 0;
  }
}

}  // namespace gauss_sim_glue
