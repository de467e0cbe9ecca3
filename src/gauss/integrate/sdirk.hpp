// Steps of one length by an L-stable method of ARKODE (SUNDIALS), for stiff models.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_SDIRK_HPP
#define GAUSS_INTEGRATE_SDIRK_HPP

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_ls.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "gauss/integrate/sundials.hpp"
#include "gauss/integrate/unit_groups.hpp"

namespace gauss::integrate {

/// Singly diagonally implicit, five stages, order 4, L-stable and stiffly accurate (Hairer and Wanner, Solving Ordinary Differential Equations II,
/// table IV.6.5): what decays within a step is gone at its end, however fast it is. Stages are solved by Newton's method with the Jacobian of
/// `Derivatives`: ByDifferences or EmittedJacobian.
template <class Model, class Derivatives = ByDifferences>
class Sdirk {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  static constexpr int order = 4;

  /// `tolerance` of Newton's method, relative to the largest component with the same unit so far (to 1 rad, for angles), or to `smallest_scale` in its unit where that
  /// is larger.
  explicit Sdirk(double tolerance = 1e-13, double smallest_scale = 0)
      : memory_(std::make_unique<Memory>()), tolerance_(tolerance), smallest_scale_(smallest_scale) {}

  StepResult step(const Model& model, double t, double h, State& state) {
    Problem& problem = memory_->problem;
    problem.set_model(model);
    problem.forget_trouble();
    N_Vector y = memory_->work.state.get();
    std::copy_n(state.values, Model::size, N_VGetArrayPointer(y));
    weigh(model, t, h, state);
    begin(t, h);
    sunrealtype reached = t;
    const int flag = ARKStepEvolve(memory_->arkode.get(), t + h, y, &reached, ARK_ONE_STEP);
    problem.rethrow();
    if (!is_motion_known(problem.trouble())) return result_of(problem.trouble());
    if (flag < 0) return {StepOutcome::not_converged, problem.trouble()};
    std::copy_n(N_VGetArrayPointer(y), Model::size, state.values);
    return result_of(problem.trouble());
  }

  long calls() const { return memory_->problem.calls(); }
  long jacobians() const { return memory_->problem.jacobians(); }

 private:
  using Base = sundials::Problem<Model, Derivatives>;
  using Sizes = typename UnitGroups<Model>::Array;
  // The callback of rates gets the address of the base.
  struct Problem : Base {
    Sizes weights{};
  };

  struct Free {
    void operator()(void* arkode) const { ARKStepFree(&arkode); }
  };

  // At an address that ARKODE may hold while the stepper moves.
  struct Memory {
    Problem problem;
    sundials::Workspace work{static_cast<sunindextype>(Model::size)};
    std::unique_ptr<void, Free> arkode;
  };

  void weigh(const Model& model, double t, double h, const State& state) {
    for (std::size_t i = 0; i < Model::size; ++i) sizes_[i] = std::max(sizes_[i], std::abs(state.values[i]));
    const UnitGroups<Model> groups(model);
    const Sizes scales = groups.scales(model, t, h, state, sizes_);
    const double rounding = 4 * std::numeric_limits<double>::epsilon() / std::abs(h);
    for (std::size_t i = 0; i < Model::size; ++i) {
      // What will not move, as far as can be seen, has no scale.
      const double scale = std::max(scales[i] > 0 ? scales[i] : 1.0, smallest_scale_);
      // Equations of a stage say what speeds are by places, too, and no better than these are rounded.
      const double of_places = i < Model::n_q ? 0 : rounding * groups.places_of(i, scales);
      memory_->problem.weights[i] = 1 / (tolerance_ * scale + of_places);
    }
  }

  static int weights(N_Vector, N_Vector result, void* user_data) {
    const Sizes& from = static_cast<Problem&>(Base::self(user_data)).weights;
    std::copy(from.begin(), from.end(), N_VGetArrayPointer(result));
    return 0;
  }

  void begin(double t, double h) {
    N_Vector y = memory_->work.state.get();
    if (!memory_->arkode) {
      create(t);
    } else {
      ARKStepReset(memory_->arkode.get(), t, y);
    }
    ARKStepSetFixedStep(memory_->arkode.get(), h);
  }

  void create(double t) {
    sundials::Workspace& work = memory_->work;
    void* const arkode =
        sundials::created(ARKStepCreate(nullptr, Problem::rates, t, work.state.get(), work.context.get()));
    memory_->arkode.reset(arkode);
    ARKStepSetErrHandlerFn(arkode, sundials::be_quiet, nullptr);
    ARKStepSetUserData(arkode, static_cast<Base*>(&memory_->problem));
    ARKStepWFtolerances(arkode, weights);
    ARKStepSetTableNum(arkode, ARKODE_SDIRK_5_3_4, ARKODE_ERK_NONE);
    ARKStepSetLinearSolver(arkode, work.solver.get(), work.matrix.get());
    if constexpr (Problem::has_jacobian) ARKStepSetJacFn(arkode, Problem::jacobian);
    // Rates of a stage from the stage: evaluated there, they would magnify what Newton's method leaves.
    ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE);
    ARKStepSetMaxNonlinIters(arkode, k_most_iterations);
  }

  static constexpr int k_most_iterations = 20;

  std::unique_ptr<Memory> memory_;
  double tolerance_;
  double smallest_scale_;
  Sizes sizes_{};  ///< largest so far
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_SDIRK_HPP
