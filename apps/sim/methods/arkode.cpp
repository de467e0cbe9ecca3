#include "sim/methods/arkode.hpp"

#include <cmath>
#include <iterator>

#include "gauss/integrate/projection_near.hpp"
#include "sim/drive/project_start.hpp"

namespace gausssim {

namespace sundials = gauss::integrate::sundials;

Arkode::Arkode(const Model& model, const Array& start, double t, const gauss::simulate::Settings<double>& settings,
               const ArkodeTable& table, double fixed_step)
    : model_(model), settings_(settings), t_(t), end_(t), fixed_step_(fixed_step) {
  problem_.set_model(model_);
  problem_.integrator = this;
  State state{start};
  if (!settings_.are_usable()) progress_.outcome = Outcome::bad_settings;
  if (settings_.project) project_start(model_, t_, state, progress_);
  Base::copy(state, work_.state.get());
  set_up(table);
}

void Arkode::set_up(const ArkodeTable& table) {
  const bool is_implicit = table.is_implicit();
  void* const arkode =
      sundials::created(ARKStepCreate(is_implicit ? nullptr : Base::rates, is_implicit ? Base::rates : nullptr, t_,
                                      work_.state.get(), work_.context.get()));
  arkode_.reset(arkode);
  ARKStepSetErrHandlerFn(arkode, sundials::be_quiet, nullptr);
  ARKStepSetUserData(arkode, static_cast<Base*>(&problem_));
  ARKStepWFtolerances(arkode, weights);
  ARKStepSetTableNum(arkode, table.implicit, table.explicit_one);
  ARKStepSetMaxHnilWarns(arkode, -1);
  // Each makes the step shorter: enough to come down to rounding.
  constexpr int k_most_failures = 60;
  ARKStepSetMaxErrTestFails(arkode, k_most_failures);
  ARKStepSetMaxConvFails(arkode, k_most_failures);
  if (fixed_step_ > 0) ARKStepSetFixedStep(arkode, fixed_step_);
  if (settings_.longest_step > 0) ARKStepSetMaxStep(arkode, settings_.longest_step);
  if (is_implicit) use_newton(arkode);
}

void Arkode::use_newton(void* arkode) {
  ARKStepSetLinearSolver(arkode, work_.solver.get(), work_.matrix.get());
  if (model_.has_jacobian()) ARKStepSetJacFn(arkode, Base::jacobian);
  // Rates of a stage from the stage: evaluated there, they would magnify what Newton's method leaves of a stiff model.
  ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE);
  if (fixed_step_ > 0) ARKStepSetMaxNonlinIters(arkode, 20);
  // As it comes, ARKODE goes on with the matrix of a step that was up to 0.2 longer or shorter, and with the rate of convergence of all steps since it was made. That of exact
  // matrices is next to nothing: so it took the first iteration for the solution where a step was cut off to arrive, and left errors of thousands of tolerances.
  constexpr double k_same_step = 1e-12, k_no_better = 1;
  ARKStepSetDeltaGammaMax(arkode, k_same_step);
  ARKStepSetNonlinCRDown(arkode, k_no_better);
}

bool Arkode::advance_to(const double& end) {
  while (t_ < end && is_running()) step_once(end);
  return is_running() && t_ == end;
}

bool Arkode::step_once(double end) {
  progress_.outcome = settings_.before_step(progress_.steps);
  if (!is_running()) return false;
  end_ = end;
  problem_.forget_trouble();
  void* const arkode = arkode_.get();
  ARKStepSetStopTime(arkode, end);
  sunrealtype reached = t_;
  const int flag = ARKStepEvolve(arkode, end, work_.state.get(), &reached, ARK_ONE_STEP);
  // Asked for within a step, it is the last one.
  ARKStepGetCurrentStep(arkode, &planned_);
  problem_.rethrow();
  if (problem_.trouble() != gauss::Status::ok) progress_.status = problem_.trouble();
  if (flag < 0) {
    const bool is_model = !gauss::integrate::is_motion_known(problem_.trouble());
    progress_.outcome = is_model ? Outcome::model_failed : Outcome::step_too_small;
    return false;
  }
  if (problem_.trouble() == gauss::Status::dependent_constraints) ++progress_.with_fewer_constraints;
  return arrives_at(reached);
}

/// A state that projection moves is one that ARKODE has to be told of: it keeps rates of the one that it knows.
bool Arkode::arrives_at(double reached) {
  if (!(reached > t_)) return progress_.outcome = Outcome::step_too_small, false;
  t_ = reached;
  ++progress_.steps;
  if (!settings_.project) return true;
  const State before = Base::state_of(work_.state.get());
  State after = before;
  const auto is_near = [&] { return scales_.is_near(settings_, before, after); };
  const auto is_energy_near = [&] { return scales_.is_energy_near(settings_, before, after); };
  const gauss::Status status = gauss::integrate::projection_near(model_, t_, before, after, is_energy_near);
  if (!gauss::integrate::is_motion_known(status) || !is_near()) {
    progress_.status = status;
    progress_.outcome = Outcome::constraints_lost;
    return false;
  }
  if (before.values == after.values) return true;
  Base::copy(after, work_.state.get());
  ARKStepReset(arkode_.get(), t_, work_.state.get());
  return true;
}

Progress<double> Arkode::progress() const {
  Progress<double> progress = progress_;
  long inaccurate = 0, unsolved = 0;
  ARKStepGetNumErrTestFails(arkode_.get(), &inaccurate);
  ARKStepGetNumStepSolveFails(arkode_.get(), &unsolved);
  progress.rejected = inaccurate + unsolved;
  progress.calls = problem_.calls();
  progress.jacobians = problem_.jacobians();
  return progress;
}

int Arkode::weights(N_Vector y, N_Vector result, void* user_data) {
  Arkode& self = *static_cast<Problem&>(Base::self(user_data)).integrator;
  return self.problem_.guarded([&](Base&) {
    constexpr double k_first_guess = 1e-3;
    const double way = self.end_ - self.t_;
    double step = self.planned_ > 0 ? std::min(self.planned_, way) : k_first_guess * way;
    if (self.fixed_step_ > 0) step = self.fixed_step_;
    self.scales_.find(self.model_, self.t_, step > 0 ? step : 1, Base::state_of(y));
    const Array allowed = self.scales_.allowed(self.settings_, self.settings_.tolerance);
    for (std::size_t i = 0; i < allowed.size(); ++i) N_VGetArrayPointer(result)[i] = 1 / allowed[i];
    return gauss::Status::ok;
  });
}

}  // namespace gausssim
