#include "sim/methods/ida.hpp"

#include <algorithm>

#include "sim/methods/settings.hpp"

namespace gausssim {

namespace sundials = gauss::integrate::sundials;

Ida::Ida(const Model& model, const Array& start, double t, const gauss::simulate::Settings<double>& settings)
    : model_(model), settings_(settings), t_(t), end_(t) {
  problem_.set_model(model_);
  problem_.integrator = this;
  Base::copy(State{start}, work_.state.get());
  rates_.reset(sundials::created(N_VClone(work_.state.get())));
  if (!settings_.are_usable()) progress_.outcome = Outcome::bad_settings;
  // Rates that fit the start, as IDA asks for.
  if (Base::rates(t_, work_.state.get(), rates_.get(), static_cast<Base*>(&problem_)) != 0) {
    problem_.rethrow();
    progress_.status = problem_.trouble();
    progress_.outcome = Outcome::model_failed;
  }
  set_up();
}

void Ida::set_up() {
  void* const ida = sundials::created(IDACreate(work_.context.get()));
  ida_.reset(ida);
  IDASetErrHandlerFn(ida, sundials::be_quiet, nullptr);
  IDAInit(ida, residual, t_, work_.state.get(), rates_.get());
  IDASetUserData(ida, static_cast<Base*>(&problem_));
  IDAWFtolerances(ida, weights);
  // Each makes the step shorter: enough to come down to rounding.
  constexpr int k_most_failures = 60;
  IDASetMaxErrTestFails(ida, k_most_failures);
  IDASetMaxConvFails(ida, k_most_failures);
  if (settings_.longest_step > 0) IDASetMaxStep(ida, settings_.longest_step);
  IDASetLinearSolver(ida, work_.solver.get(), work_.matrix.get());
  if (model_.has_jacobian()) IDASetJacFn(ida, jacobian);
}

bool Ida::advance_to(const double& end) {
  while (t_ < end && is_running()) step_once(end);
  return is_running() && t_ == end;
}

void Ida::step_once(double end) {
  progress_.outcome = settings_.before_step(progress_.steps);
  if (!is_running()) return;
  end_ = end;
  problem_.forget_trouble();
  void* const ida = ida_.get();
  IDASetStopTime(ida, end);
  sunrealtype reached = t_;
  const int flag = IDASolve(ida, end, &reached, work_.state.get(), rates_.get(), IDA_ONE_STEP);
  // Asked for within a step, it is the last one.
  IDAGetCurrentStep(ida, &planned_);
  problem_.rethrow();
  if (problem_.trouble() != gauss::Status::ok) progress_.status = problem_.trouble();
  constexpr int k_most_without_way = 20;
  without_way_ = reached == t_ ? without_way_ + 1 : 0;
  if (flag < 0 || without_way_ > k_most_without_way) {
    const bool is_model = !gauss::integrate::is_motion_known(problem_.trouble());
    progress_.outcome = is_model ? Outcome::model_failed : Outcome::step_too_small;
    return;
  }
  if (problem_.trouble() == gauss::Status::dependent_constraints) ++progress_.with_fewer_constraints;
  t_ = reached;
  ++progress_.steps;
  long inaccurate = 0;
  int order = 0;
  IDAGetNumErrTestFails(ida, &inaccurate);
  IDAGetLastOrder(ida, &order);
  places_.look(progress_.steps, inaccurate, order, settings_.tolerance);
}

Progress<double> Ida::progress() const {
  Progress<double> progress = progress_;
  long inaccurate = 0, unsolved = 0;
  IDAGetNumErrTestFails(ida_.get(), &inaccurate);
  IDAGetNumNonlinSolvConvFails(ida_.get(), &unsolved);
  progress.rejected = inaccurate + unsolved;
  progress.calls = problem_.calls();
  progress.jacobians = problem_.jacobians();
  return progress;
}

int Ida::residual(sunrealtype t, N_Vector y, N_Vector rates, N_Vector result, void* user_data) {
  const int failure = Base::rates(t, y, result, user_data);
  N_VLinearSum(1, rates, -1, result, result);
  return failure;
}

/// dF/dy + by_rates dF/dy'.
int Ida::jacobian(sunrealtype t, sunrealtype by_rates, N_Vector y, N_Vector rates, N_Vector, SUNMatrix result,
                  void* user_data, N_Vector, N_Vector, N_Vector) {
  const int failure = Base::jacobian(t, y, rates, result, user_data, nullptr, nullptr, nullptr);
  for (sunindextype j = 0; j < SM_COLUMNS_D(result); ++j) {
    for (sunindextype i = 0; i < SM_ROWS_D(result); ++i)
      SM_ELEMENT_D(result, i, j) = (i == j ? by_rates : 0) - SM_ELEMENT_D(result, i, j);
  }
  return failure;
}

int Ida::weights(N_Vector y, N_Vector result, void* user_data) {
  Ida& self = *static_cast<Problem&>(Base::self(user_data)).integrator;
  return self.problem_.guarded([&](Base&) {
    constexpr double k_first_guess = 1e-3;
    const double way = self.end_ - self.t_;
    const double step = self.planned_ > 0 ? std::min(self.planned_, way) : k_first_guess * way;
    self.scales_.find(self.model_, self.t_, step > 0 ? step : 1, Base::state_of(y));
    const Array allowed = self.scales_.allowed(self.settings_, self.settings_.tolerance, self.places_.share());
    for (std::size_t i = 0; i < allowed.size(); ++i) N_VGetArrayPointer(result)[i] = 1 / allowed[i];
    return gauss::Status::ok;
  });
}

Made<double> make_ida(const Problem<double>& problem) {
  return std::make_unique<Ida>(problem.model, problem.start, problem.t, settings_of(problem));
}

}  // namespace gausssim
