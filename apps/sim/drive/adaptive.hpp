#pragma once
// Methods of Odeint with an estimate of their error, by gauss::simulate::Simulation.

#include <algorithm>

#include "gauss/simulate/simulation.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

/// `Inner`: arrays with room for the state.
template <class S, class Method, class Inner>
class Adaptive final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  using Model = MotionModel<S, Inner>;

  Adaptive(const MotionModel<S>& model, const Array& start, const S& t, const gauss::simulate::Settings<S>& settings)
      : size_(start.size()), simulation_(Model(model), inside(start), t, settings) {}

  bool advance_to(const S& end) override { return simulation_.advance_to(end); }
  bool step_towards(const S& end) override { return simulation_.step_towards(end); }
  void know_sizes(const Array& sizes) override { simulation_.know_sizes(inside(sizes).values); }
  void know_rounding(const Array& of_rates) override { simulation_.know_rounding(inside(of_rates).values); }
  S time() const override { return simulation_.time(); }
  const Array& state() const override {
    const typename Model::State inner = simulation_.state();
    shown_.assign(inner.values.begin(), inner.values.begin() + static_cast<std::ptrdiff_t>(size_));
    return shown_;
  }
  Progress<S> progress() const override { return progress_of<S>(simulation_.report()); }

 private:
  static typename Model::State inside(const Array& start) {
    typename Model::State state{Inner(start.size(), S(0))};
    std::copy(start.begin(), start.end(), state.values.begin());
    return state;
  }

  std::size_t size_;
  mutable Array shown_;
  gauss::simulate::Simulation<Model, Method> simulation_;
};

}  // namespace gausssim
