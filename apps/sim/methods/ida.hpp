#pragma once
// Backward differentiation by IDA (SUNDIALS), of the equation F(t, y, y') = y' - f(t, y) = 0.
//
// This form, of index 0, and not M v' - Q - B^T lambda = 0 with B v = ... and multipliers as further unknowns: what a header emits are the accelerations f, for which multipliers are
// solved already, whatever the rank of the constraints; no header emits M and B with derivatives by the state, which Newton's method would ask for. Multipliers as unknowns would
// also have errors tested that do not integrate. IDA has no projection: constraints drift with the tolerance.

#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <memory>

#include "gauss/integrate/sundials.hpp"
#include "gauss/simulate/sundials_scales.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

class Ida final : public Integrator<double> {
 public:
  using Model = MotionModel<double>;
  using State = Model::State;

  Ida(const Model& model, const Array& start, double t, const gauss::simulate::Settings<double>& settings);
  Ida(const Ida&) = delete;
  Ida& operator=(const Ida&) = delete;

  bool advance_to(const double& end) override;
  double time() const override { return t_; }
  const Array& state() const override { return shown_ = Base::state_of(work_.state.get()).values; }
  Progress<double> progress() const override;

 private:
  using Base = gauss::integrate::sundials::Problem<Model, gauss::integrate::OwnJacobian>;
  using Outcome = gauss::simulate::Outcome;
  struct Problem : Base {
    Ida* integrator = nullptr;
  };
  struct Free {
    void operator()(void* ida) const { IDAFree(&ida); }
  };

  bool is_running() const { return progress_.outcome == Outcome::running; }
  void set_up();
  void step_once(double end);
  static int residual(sunrealtype t, N_Vector y, N_Vector rates, N_Vector result, void* user_data);
  static int jacobian(sunrealtype t, sunrealtype by_rates, N_Vector y, N_Vector rates, N_Vector residual,
                      SUNMatrix result, void* user_data, N_Vector, N_Vector, N_Vector);
  static int weights(N_Vector y, N_Vector result, void* user_data);

  mutable Array shown_;
  Model model_;
  gauss::simulate::Settings<double> settings_;
  double t_, end_;
  double planned_ = 0;   ///< the next step; 0: none is yet
  int without_way_ = 0;  ///< steps in a row that did not move the time
  gauss::simulate::SundialsScales<Model> scales_{model_};
  gauss::simulate::DemandOnPlaces places_;
  Progress<double> progress_;
  Problem problem_;
  gauss::integrate::sundials::Workspace work_{static_cast<sunindextype>(model_.size())};
  gauss::integrate::sundials::Owner<N_Vector> rates_;
  std::unique_ptr<void, Free> ida_;
};

}  // namespace gausssim
