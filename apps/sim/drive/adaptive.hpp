#pragma once
// Methods of Odeint with an estimate of their error, by gauss::simulate::Simulation.

#include "gauss/simulate/simulation.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

template <class S, class Method>
class Adaptive final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  using Model = MotionModel<S>;

  Adaptive(const Model& model, const Array& start, const S& t, const gauss::simulate::Settings<S>& settings)
      : simulation_(model, typename Model::State{start}, t, settings) {}

  bool advance_to(const S& end) override { return simulation_.advance_to(end); }
  S time() const override { return simulation_.time(); }
  Array state() const override { return simulation_.state().values; }
  Progress<S> progress() const override {
    const auto& report = simulation_.report();
    Progress<S> progress;
    progress.outcome = report.outcome;
    progress.status = report.status;
    progress.steps = report.steps;
    progress.rejected = report.rejected;
    progress.calls = report.calls;
    progress.with_fewer_constraints = report.with_fewer_constraints;
    progress.crossings = report.crossings;
    progress.start_moved = report.start_moved;
    progress.start_component = report.start_component;
    return progress;
  }

 private:
  gauss::simulate::Simulation<Model, Method> simulation_;
};

}  // namespace gausssim
