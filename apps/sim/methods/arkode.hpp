#pragma once
// One-step methods of ARKODE (SUNDIALS): explicit, and diagonally implicit for stiff models.

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_ls.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "gauss/integrate/sundials.hpp"
#include "gauss/simulate/sundials_scales.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

/// One of the two is a table of ARKODE, the other is none.
struct ArkodeTable {
  ARKODE_DIRKTableID implicit = ARKODE_DIRK_NONE;
  ARKODE_ERKTableID explicit_one = ARKODE_ERK_NONE;

  bool is_implicit() const { return implicit != ARKODE_DIRK_NONE; }
};

class Arkode final : public Integrator<double> {
 public:
  using Model = MotionModel<double>;
  using State = Model::State;

  /// `fixed_step` 0: steps by the estimate of their error.
  Arkode(const Model& model, const Array& start, double t, const gauss::simulate::Settings<double>& settings,
         const ArkodeTable& table, double fixed_step = 0);
  Arkode(const Arkode&) = delete;
  Arkode& operator=(const Arkode&) = delete;

  bool advance_to(const double& end) override;
  double time() const override { return t_; }
  const Array& state() const override { return shown_ = Base::state_of(work_.state.get()).values; }
  Progress<double> progress() const override;

 private:
  using Base = gauss::integrate::sundials::Problem<Model, gauss::integrate::OwnJacobian>;
  using Outcome = gauss::simulate::Outcome;
  struct Problem : Base {
    Arkode* integrator = nullptr;
  };
  struct Free {
    void operator()(void* arkode) const { ARKStepFree(&arkode); }
  };

  bool is_running() const { return progress_.outcome == Outcome::running; }
  void set_up(const ArkodeTable& table);
  void use_newton(void* arkode);
  bool step_once(double end);
  bool arrives_at(double reached);
  static int weights(N_Vector y, N_Vector result, void* user_data);

  mutable Array shown_;
  Model model_;
  gauss::simulate::Settings<double> settings_;
  double t_, end_, fixed_step_;
  double planned_ = 0;  ///< the next step; 0: none is yet
  gauss::simulate::SundialsScales<Model> scales_{model_};
  Progress<double> progress_;
  Problem problem_;
  gauss::integrate::sundials::Workspace work_{static_cast<sunindextype>(model_.size())};
  std::unique_ptr<void, Free> arkode_;
};

}  // namespace gausssim
