// Steps of one length by an explicit method of Boost.Odeint.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_EXPLICIT_STEPPER_HPP
#define GAUSS_INTEGRATE_EXPLICIT_STEPPER_HPP

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <functional>

#include "gauss/integrate/odeint.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

// A stepper is what has
//
//     StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state);
//
// and moves the state from t to t + h, or leaves it and says why. What corrects the states of a stepper is a stepper, too
// (gauss/integrate/corrections.hpp). Steppers allocate nothing.

/// `Method<Array, Scalar>` is a stepper of Odeint over std::array with do_step(system, x, t, h).
template <class Model, class Method>
class ExplicitStepper {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;

  // A method holds nothing between steps but scratch space, which has no values to copy before the first one.
  ExplicitStepper() = default;
  ExplicitStepper(const ExplicitStepper&) {}
  ExplicitStepper& operator=(const ExplicitStepper&) { return *this; }

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    OdeintSystem<Model> system(model);
    StateArray<Model> x = StateArrays<Model>::array_of(state);
    method_.do_step(std::ref(system), x, t, h);
    const StepResult result = result_of(system.trouble());
    if (result.is_taken()) copy_into(x, state);
    return result;
  }

 private:
  Method method_;
};

template <class Model>
using Rk4 = ExplicitStepper<Model, boost::numeric::odeint::runge_kutta4<StateArray<Model>, typename Model::Scalar,
                                                                        StateArray<Model>, typename Model::Scalar>>;
/// Order 5. Without the reuse of the last stage, which a correction of the state would make wrong.
template <class Model>
class Dopri5 {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    ExplicitStepper<Model, Method> fresh;
    return fresh.step(model, t, h, state);
  }

 private:
  using Method = boost::numeric::odeint::runge_kutta_dopri5<StateArray<Model>, Scalar, StateArray<Model>, Scalar>;
};

/// Order 8.
template <class Model>
using Fehlberg78 =
    ExplicitStepper<Model, boost::numeric::odeint::runge_kutta_fehlberg78<StateArray<Model>, typename Model::Scalar,
                                                                          StateArray<Model>, typename Model::Scalar>>;
/// Order 8.
template <class Model>
using Prince8 = ExplicitStepper<Model, PrinceDormand87<StateArray<Model>, typename Model::Scalar>>;

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_EXPLICIT_STEPPER_HPP
