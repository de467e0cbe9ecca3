// Boost.Odeint steps an emitted model.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_ODEINT_HPP
#define GAUSS_INTEGRATE_ODEINT_HPP

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <cmath>
#include <limits>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/prince_dormand87.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

/// A system in Odeint's sense over std::array. Odeint copies systems: hand it std::ref(system).
template <class Model>
class OdeintSystem {
 public:
  using Scalar = typename Model::Scalar;
  using Array = std::array<Scalar, Model::size>;

  explicit OdeintSystem(const Model& model) : model_(model) {}

  void operator()(const Array& x, Array& dxdt, const Scalar& t) {
    typename Model::State state;
    typename Model::Derivative derivative;
    std::copy(x.begin(), x.end(), state.values);
    const typename Model::Status status = model_.derivative(t, state, derivative);
    std::copy_n(derivative.values, Model::size, dxdt.begin());
    ++calls_;
    if (is_motion_known(trouble_) && status != typename Model::Status{}) trouble_ = status;
  }

  /// The first status that stops a motion, or else a milder one other than ok, since the last forget_trouble(): Odeint has no way to return it.
  typename Model::Status trouble() const { return trouble_; }
  void forget_trouble() { trouble_ = typename Model::Status{}; }
  long calls() const { return calls_; }

 private:
  const Model& model_;
  typename Model::Status trouble_{};
  long calls_ = 0;
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

/// Order 8, with a step that follows the estimate of order 7. No dense output.
template <class Scalar, std::size_t n, class Control>
using Stepper =
    boost::numeric::odeint::controlled_runge_kutta<PrinceDormand87<std::array<Scalar, n>, Scalar>, ErrorBy<Control>>;

template <class Scalar, std::size_t n, class Control>
Stepper<Scalar, n, Control> make_stepper(Control& control) {
  using Result = Stepper<Scalar, n, Control>;
  // The controller copies a stepper. A static one is zero, where a temporary would have its scratch space copied
  // uninitialised, which compilers warn of.
  static const typename Result::stepper_type k_blank;
  return {ErrorBy<Control>(control), typename Result::step_adjuster_type(), k_blank};
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_ODEINT_HPP
