// Boost.Odeint steps an emitted model.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_ODEINT_HPP
#define GAUSS_INTEGRATE_ODEINT_HPP

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/prince_dormand87.hpp"
#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

template <class Model, class = void>
struct TellsJacobian : std::false_type {};
template <class Model>
struct TellsJacobian<Model, std::void_t<decltype(std::declval<const Model&>().has_jacobian())>> : std::true_type {};

/// A system in Odeint's sense over std::array. Odeint copies systems: hand it std::ref(system).
template <class Model>
class OdeintSystem {
 public:
  using Scalar = typename Model::Scalar;
  using Array = StateArray<Model>;

  explicit OdeintSystem(const Model& model) : model_(model) {}

  void operator()(const Array& x, Array& dxdt, const Scalar& t) {
    const typename Model::Status status = rates(x, dxdt, t);
    ++calls_;
    if (is_motion_known(trouble_) && status != typename Model::Status{}) trouble_ = status;
  }

  /// Of a model as OwnJacobian has it (sundials.hpp). False: it has none.
  template <class Fill>
  bool jacobian(const Scalar& t, const Array& x, const Fill& fill) {
    if constexpr (TellsJacobian<Model>::value) {
      if (!model_.has_jacobian()) return false;
      ++jacobians_;
      model_.jacobian(t, StateArrays<Model>::state_of(x), fill);
      return true;
    } else {
      return false;
    }
  }

  /// The first status that stops a motion, or else a milder one other than ok, since the last forget_trouble(): Odeint has no way to return it.
  typename Model::Status trouble() const { return trouble_; }
  void forget_trouble() { trouble_ = typename Model::Status{}; }
  long calls() const { return calls_; }
  long jacobians() const { return jacobians_; }

 private:
  typename Model::Status rates(const Array& x, Array& dxdt, const Scalar& t) const {
    if constexpr (HasOwnArrays<Model>::value) {
      return model_.rates(t, x, dxdt);
    } else {
      typename Model::State state;
      typename Model::Derivative derivative;
      copy_into(x, state);
      const typename Model::Status status = model_.derivative(t, state, derivative);
      copy_values(derivative, dxdt);
      return status;
    }
  }

  const Model& model_;
  typename Model::Status trouble_{};
  long calls_ = 0, jacobians_ = 0;
};

/// An error checker of Odeint, which copies it: `Control` has error(errors, dt), the error of a step in units of what is allowed.
template <class Control>
class ErrorBy {
 public:
  /// `control` outlives the stepper.
  explicit ErrorBy(Control& control) : control_(&control) {}

  template <class Algebra, class Array, class Scalar>
  Scalar error(Algebra&, const Array&, const Array&, const Array& errors, const Scalar& dt) const {
    return control_->error(errors, dt);
  }

 private:
  Control* control_;
};

/// A method with an estimate of its error, and a step that follows it. No dense output.
template <class Method, class Control>
using Stepper = boost::numeric::odeint::controlled_runge_kutta<Method, ErrorBy<Control>>;

template <class Method, class Control>
Stepper<Method, Control> make_stepper(Control& control) {
  using Result = Stepper<Method, Control>;
  // The controller copies a stepper. A static one is zero, where a temporary would have its scratch space copied
  // uninitialised, which compilers warn of.
  static const typename Result::stepper_type k_blank;
  return {ErrorBy<Control>(control), typename Result::step_adjuster_type(), k_blank};
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_ODEINT_HPP
