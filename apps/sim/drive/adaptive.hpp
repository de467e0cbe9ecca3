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
  Progress<S> progress() const override { return progress_of<S>(simulation_.report()); }

 private:
  gauss::simulate::Simulation<Model, Method> simulation_;
};

}  // namespace gausssim
