// Steps that turn attitudes by rotations: exact for a steady spin, however many turns it makes in a step.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_ROTATION_STEPPER_HPP
#define GAUSS_INTEGRATE_ROTATION_STEPPER_HPP

#include <array>
#include <cmath>
#include <cstddef>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

/// Order 4, explicit: Runge and Kutta's classical method, in which a quaternion q moves by q exp(h omega/2) and not along its tangent (commutator-free
/// method of Celledoni, Marthinsen and Owren, Future Generation Computer Systems 19 (2003) 341-352). Quaternions keep their length to rounding. What limits
/// the step is how fast rates and angular velocities in the axes of the body change, and no longer how fast the body turns.
template <class Model>
class RotationRk4 {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  static constexpr int order = 4;

  /// The state has a quaternion, body to space, in components `scalar_part` to `scalar_part + 3`.
  void turn(std::size_t scalar_part) { is_quaternion_[scalar_part] = true; }

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    trouble_ = Status::ok;
    const Slope k1 = slope(model, t, state);
    const State second = moved(state, h / 2, k1);
    const Slope k2 = slope(model, t + h / 2, second);
    const Slope k3 = slope(model, t + h / 2, moved(state, h / 2, k2));
    const Slope k4 = slope(model, t + h, moved(second, h, sum({-Scalar(1) / 2, 0, 1, 0}, {&k1, &k2, &k3, &k3})));
    const StepResult result = result_of(trouble_);
    if (!result.is_taken()) return result;
    const State half = moved(state, h / 12, sum({3, 2, 2, -1}, {&k1, &k2, &k3, &k4}));
    state = moved(half, h / 12, sum({-1, 2, 2, 3}, {&k1, &k2, &k3, &k4}));
    return result;
  }

 private:
  /// Rates, and in the place of a quaternion's rates 0 and the angular velocity in the axes of the body.
  using Slope = std::array<Scalar, Model::size>;

  Slope slope(const Model& model, const Scalar& t, const State& state) {
    typename Model::Derivative rates;
    const Status status = model.derivative(t, state, rates);
    if (is_motion_known(trouble_) && status != Status::ok) trouble_ = status;
    Slope result;
    for (std::size_t i = 0; i < Model::size; ++i) result[i] = rates.values[i];
    for (std::size_t i = 0; i + 3 < Model::n_q; ++i)
      if (is_quaternion_[i]) angular_velocity(state.values + i, rates.values + i, &result[i]);
    return result;
  }

  /// omega = 2 conj(q) dq/dt / |q|^2
  static void angular_velocity(const Scalar* q, const Scalar* rate, Scalar* omega) {
    const Scalar factor = 2 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    omega[0] = 0;
    omega[1] = factor * (q[0] * rate[1] - q[1] * rate[0] - q[2] * rate[3] + q[3] * rate[2]);
    omega[2] = factor * (q[0] * rate[2] - q[2] * rate[0] - q[3] * rate[1] + q[1] * rate[3]);
    omega[3] = factor * (q[0] * rate[3] - q[3] * rate[0] - q[1] * rate[2] + q[2] * rate[1]);
  }

  State moved(const State& from, const Scalar& h, const Slope& slope) const {
    State result;
    for (std::size_t i = 0; i < Model::size; ++i) result.values[i] = from.values[i] + h * slope[i];
    for (std::size_t i = 0; i + 3 < Model::n_q; ++i)
      if (is_quaternion_[i]) turned(from.values + i, h, &slope[i], result.values + i);
    return result;
  }

  /// q exp(h omega/2)
  static void turned(const Scalar* q, const Scalar& h, const Scalar* omega, Scalar* result) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Scalar rate = sqrt(omega[1] * omega[1] + omega[2] * omega[2] + omega[3] * omega[3]);
    const Scalar w = cos(h * rate / 2);
    const Scalar s = rate > 0 ? sin(h * rate / 2) / rate : h / 2;
    const Scalar x = s * omega[1], y = s * omega[2], z = s * omega[3];
    result[0] = q[0] * w - q[1] * x - q[2] * y - q[3] * z;
    result[1] = q[0] * x + q[1] * w + q[2] * z - q[3] * y;
    result[2] = q[0] * y + q[2] * w + q[3] * x - q[1] * z;
    result[3] = q[0] * z + q[3] * w + q[1] * y - q[2] * x;
  }

  static Slope sum(const std::array<Scalar, 4>& weights, const std::array<const Slope*, 4>& slopes) {
    Slope result{};
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < Model::size; ++i) result[i] += weights[j] * (*slopes[j])[i];
    return result;
  }

  std::array<bool, Model::size> is_quaternion_{};
  Status trouble_ = Status::ok;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_ROTATION_STEPPER_HPP
