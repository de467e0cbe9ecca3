#pragma once
// The multistep methods of CVODE (SUNDIALS), by gauss::simulate::CvodeSimulation.

#include "gauss/simulate/cvode.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

class Cvode final : public Integrator<double> {
 public:
  using Model = MotionModel<double>;

  Cvode(const Model& model, const Array& start, double t, const gauss::simulate::Settings<double>& settings,
        gauss::simulate::Multistep method)
      : simulation_(model, Model::State{start}, t, settings, method) {}

  bool advance_to(const double& end) override { return simulation_.advance_to(end); }
  double time() const override { return simulation_.time(); }
  const Array& state() const override { return shown_ = simulation_.state().values; }
  Progress<double> progress() const override { return progress_of<double>(simulation_.report()); }

 private:
  mutable Array shown_;
  gauss::simulate::CvodeSimulation<Model, gauss::integrate::OwnJacobian> simulation_;
};

}  // namespace gausssim
