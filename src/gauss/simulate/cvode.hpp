// Integration in time by the multistep methods of CVODE (SUNDIALS): BDF for stiff models, Adams for rates that are dear.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_CVODE_HPP
#define GAUSS_SIMULATE_CVODE_HPP

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <cvode/cvode_proj.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/projection_near.hpp"
#include "gauss/integrate/sundials.hpp"
#include "gauss/simulate/report.hpp"
#include "gauss/simulate/sundials_scales.hpp"

namespace gauss::simulate {

enum class Multistep {
  bdf,    ///< backward differentiation of order 1 to 5, by Newton's method; projects after each step
  adams,  ///< order 1 to 12, by fixed-point iteration: for what is not stiff. CVODE does not project with it
};

/// As Simulation. Errors are measured as there, but in the mean square over the components. `Derivatives` is integrate::ByDifferences or
/// integrate::EmittedJacobian.
template <class Model, class Derivatives = integrate::ByDifferences>
class CvodeSimulation {
 public:
  using State = typename Model::State;

  CvodeSimulation(const Model& model, const State& start, double start_time = 0, const Settings<double>& settings = {},
                  Multistep method = Multistep::bdf)
      : model_(model), settings_(settings), method_(method), t_(start_time) {
    problem_.set_model(model_);
    Base::copy(start, work_.state.get());
    if (!settings_.are_usable() || !std::isfinite(start_time)) {
      report_.outcome = Outcome::bad_settings;
      return;
    }
    if (settings_.project) project_start(start);
    set_up();
  }

  // CVODE holds the address.
  CvodeSimulation(const CvodeSimulation&) = delete;
  CvodeSimulation& operator=(const CvodeSimulation&) = delete;

  /// Integrates to `end`, where the last step is shortened to arrive. False: it did not get there, see report(); or `end` is no time from
  /// here on.
  bool advance_to(double end) {
    return advance_to(end, [](double, const State&) {});
  }

  /// `on_step(t, state)` sees each state that was reached.
  template <class OnStep>
  bool advance_to(double end, OnStep&& on_step) {
    end_ = end;
    if (t_ < end && report_.outcome == Outcome::running) CVodeSetStopTime(cvode_.get(), end);
    while (t_ < end && report_.outcome == Outcome::running) {
      report_.outcome = settings_.before_step(report_.steps);
      if (report_.outcome == Outcome::running && step_towards(end)) on_step(t_, state());
    }
    return report_.outcome == Outcome::running && t_ == end;
  }

  double time() const { return t_; }
  State state() const { return Problem::state_of(work_.state.get()); }
  /// As it is in force: of one that writes its state in other coordinates from time to time.
  const Model& model() const { return model_; }
  const Report<Status>& report() const { return report_; }

 private:
  // Callbacks get the address of the base, and the simulation's own ones cast it back.
  struct Problem : integrate::sundials::Problem<Model, Derivatives> {
    CvodeSimulation* simulation = nullptr;
  };
  struct Free {
    void operator()(void* cvode) const { CVodeFree(&cvode); }
    void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
  };
  using Base = integrate::sundials::Problem<Model, Derivatives>;
  using Arrays = integrate::StateArrays<Model>;

  /// Each halves the step at least, as does a failure of the projection: enough to come down to rounding.
  static constexpr int k_most_failures = 60;
  static constexpr int k_most_without_way = 20;

  /// What a start misses the constraints by is no error of a step. Where it cannot be mended, the first step will tell.
  void project_start(const State& given) {
    State start = given;
    if (!integrate::is_motion_known(model_.projection(t_, start))) return;
    report_.compare_start(given, start, Arrays::size(model_));
    Base::copy(start, work_.state.get());
  }

  void set_up() {
    problem_.simulation = this;
    const bool is_stiff = method_ == Multistep::bdf;
    cvode_.reset(integrate::sundials::created(CVodeCreate(is_stiff ? CV_BDF : CV_ADAMS, work_.context.get())));
    void* const cvode = cvode_.get();
    CVodeSetErrHandlerFn(cvode, integrate::sundials::be_quiet, nullptr);
    CVodeInit(cvode, Base::rates, t_, work_.state.get());
    CVodeSetUserData(cvode, static_cast<Base*>(&problem_));
    CVodeWFtolerances(cvode, weights);
    CVodeSetMaxConvFails(cvode, k_most_failures);
    CVodeSetMaxErrTestFails(cvode, k_most_failures);
    CVodeSetMaxHnilWarns(cvode, -1);
    if (settings_.first_step > 0) CVodeSetInitStep(cvode, settings_.first_step);
    if (settings_.longest_step > 0) CVodeSetMaxStep(cvode, settings_.longest_step);
    if (is_stiff) {
      use_newton(cvode);
    } else {
      fixed_point_.reset(
          integrate::sundials::created(SUNNonlinSol_FixedPoint(work_.state.get(), 0, work_.context.get())));
      CVodeSetNonlinearSolver(cvode, fixed_point_.get());
    }
  }

  void use_newton(void* cvode) {
    CVodeSetLinearSolver(cvode, work_.solver.get(), work_.matrix.get());
    if constexpr (Base::has_jacobian) {
      if (Base::is_jacobian_there(model_)) CVodeSetJacFn(cvode, Base::jacobian);
    }
    if (!settings_.project) return;
    CVodeSetProjFn(cvode, project);
    // Estimates of the error stay those of the method.
    CVodeSetProjErrEst(cvode, SUNFALSE);
    CVodeSetMaxNumProjFails(cvode, k_most_failures);
  }

  /// A multistep method has no use for states in other coordinates: it begins anew, with order 1 and a step of its own choice.
  void rewrite([[maybe_unused]] double end) {
    if constexpr (integrate::Rewrites<Model>::value) {
      State now = state();
      if (!model_.rewrite(now)) return;
      Base::copy(now, work_.state.get());
      before_ = {report_.steps, inaccurate_, unsolved_};
      places_.forget();
      CVodeReInit(cvode_.get(), t_, work_.state.get());
      CVodeSetInitStep(cvode_.get(), 0);
      planned_ = 0;
      CVodeSetStopTime(cvode_.get(), end);
    }
  }

  bool step_towards(double end) {
    rewrite(end);
    problem_.forget_trouble();
    jumped_ = false;
    sunrealtype reached = t_;
    const int flag = CVode(cvode_.get(), end, work_.state.get(), &reached, CV_ONE_STEP);
    const long inaccurate_before = inaccurate_;
    // Asked for within a step, it is the last one.
    CVodeGetCurrentStep(cvode_.get(), &planned_);
    count();
    hold_step(inaccurate_ > inaccurate_before);
    demand_places();
    problem_.rethrow();
    if (!integrate::is_motion_known(problem_.trouble())) report_.status = problem_.trouble();
    if (flag < 0) {
      report_.outcome = outcome_of(flag);
      return false;
    }
    if (problem_.trouble() == Status::dependent_constraints) ++report_.with_fewer_constraints;
    if (is_stuck(reached)) {
      report_.outcome = jumped_ ? Outcome::constraints_lost : Outcome::step_too_small;
      return false;
    }
    t_ = reached;
    return true;
  }

  /// CVODE accepts steps below rounding of the time. A few are those of its start.
  bool is_stuck(double reached) {
    without_way_ = reached == t_ ? without_way_ + 1 : 0;
    return without_way_ > k_most_without_way;
  }

  /// CVODE thinks about a higher order after some steps of equal length, but makes them longer before that. Where the estimate of the error refuses this each
  /// time, it would stay with order 1 for good: so a step that follows such a refusal is not made longer.
  void hold_step([[maybe_unused]] bool is_held) {
#if SUNDIALS_VERSION_MINOR >= 2
    constexpr double k_usual = -1;
    CVodeSetEtaFixedStepBounds(cvode_.get(), 0, is_held ? std::numeric_limits<double>::max() : k_usual);
#endif
  }

  void demand_places() {
    if (method_ != Multistep::bdf) return;
    int order = 0;
    CVodeGetLastOrder(cvode_.get(), &order);
    places_.look(report_.steps, inaccurate_, order, settings_.tolerance);
  }

  Outcome outcome_of(int flag) const {
    if (flag == CV_FIRST_RHSFUNC_ERR) return Outcome::model_failed;
    return jumped_ ? Outcome::constraints_lost : Outcome::step_too_small;
  }

  void count() {
    CVodeGetNumSteps(cvode_.get(), &report_.steps);
    CVodeGetNumErrTestFails(cvode_.get(), &inaccurate_);
    CVodeGetNumStepSolveFails(cvode_.get(), &unsolved_);
    report_.steps += before_.steps;
    inaccurate_ += before_.inaccurate;
    unsolved_ += before_.unsolved;
    report_.rejected = inaccurate_ + unsolved_;
    report_.calls = problem_.calls();
    report_.jacobians = problem_.jacobians();
  }

  static CvodeSimulation& self(void* user_data) { return *static_cast<Problem&>(Base::self(user_data)).simulation; }

  static int weights(N_Vector y, N_Vector result, void* user_data) {
    CvodeSimulation& simulation = self(user_data);
    const int failure = simulation.problem_.guarded([&](Base& problem) {
      simulation.find_scales(problem.model(), Base::state_of(y));
      return Status::ok;
    });
    const auto allowed =
        simulation.scales_.allowed(simulation.settings_, simulation.settings_.tolerance, simulation.places_.share());
    for (std::size_t i = 0; i < allowed.size(); ++i) N_VGetArrayPointer(result)[i] = 1 / allowed[i];
    return failure;
  }

  /// Of groups, for a step from `state` with the length that CVODE has in mind.
  void find_scales(const Model& model, const State& state) {
    constexpr double k_first_guess = 1e-3;
    double t = t_;
    CVodeGetCurrentTime(cvode_.get(), &t);
    scales_.find(model, t, planned_ > 0 ? std::min(planned_, end_ - t) : k_first_guess * (end_ - t), state);
  }

  static int project(sunrealtype t, N_Vector y, N_Vector correction, sunrealtype, N_Vector, void* user_data) {
    CvodeSimulation& simulation = self(user_data);
    const State before = Base::state_of(y);
    State after = before;
    const auto is_near = [&] {
      return simulation.scales_.is_near(simulation.settings_, before, after, simulation.places_.share());
    };
    const auto is_energy_near = [&] {
      return simulation.scales_.is_energy_near(simulation.settings_, before, after, simulation.places_.share());
    };
    const int failure = simulation.problem_.guarded(
        [&](Base& problem) { return integrate::projection_near(problem.model(), t, before, after, is_energy_near); });
    if (failure != 0) return failure;
    for (std::size_t i = 0; i < std::size(before.values); ++i)
      N_VGetArrayPointer(correction)[i] = after.values[i] - before.values[i];
    simulation.jumped_ = !is_near();
    return simulation.jumped_ ? 1 : 0;
  }

  Model model_;
  Settings<double> settings_;
  Multistep method_;
  double t_;
  double end_ = 0;       ///< asked for last
  bool jumped_ = false;  ///< the last trial, by its projection
  int without_way_ = 0;  ///< steps in a row that did not move the time
  long inaccurate_ = 0;  ///< trials that the estimate of the error refused
  long unsolved_ = 0;    ///< trials whose equations were not solved
  struct Before {
    long steps = 0, inaccurate = 0, unsolved = 0;
  };
  Before before_;  ///< what CVODE has counted before it began anew
  DemandOnPlaces places_;
  SundialsScales<Model> scales_{model_};
  double planned_ = 0;  ///< the next step; 0: none is yet
  Report<Status> report_;
  Problem problem_;
  integrate::sundials::Workspace work_{static_cast<sunindextype>(Arrays::size(model_))};
  std::unique_ptr<integrate::sundials::Target<SUNNonlinearSolver>, Free> fixed_point_;
  std::unique_ptr<void, Free> cvode_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_CVODE_HPP
