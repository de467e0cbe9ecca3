#pragma once
// Both generated models, seen alike: what a state means, whatever its coordinates are.

#include <cmath>

#include "attitude.hpp"
#include "closed_form.hpp"
#include "gauss/model_concept.hpp"
#include "rolling_along_as_printed.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

namespace sphere {

namespace euler = gauss::sphere_in_cylinder;
namespace quaternion = gauss::sphere_in_cylinder_quaternion;
namespace as_printed = gauss::rolling_along_as_printed;

GAUSS_MODEL(EulerModel, euler);
GAUSS_MODEL(QuaternionModel, quaternion);
GAUSS_MODEL(AsPrintedModel, as_printed);

/// One instant of a motion.
struct Sample {
  double t = 0;
  Motion motion{};
  Quaternion<double> attitude{};
  gauss::Status status = gauss::Status::ok;  ///< of the generated code
};

using SpaceVector = std::array<double, 3>;  // x, y, z

inline CylinderVector along_cylinder(const SpaceVector& v, double chi) {
  const double s = std::sin(chi);
  const double c = std::cos(chi);
  return {c * v[0] + s * v[1], -s * v[0] + c * v[1], v[2]};
}

/// States with Euler angles, of either model that has them.
template <class State>
SpaceVector omega_of(const State& state) {
  const double sin_psi = std::sin(state.psi()), cos_psi = std::cos(state.psi());
  const double sin_theta = std::sin(state.theta()), cos_theta = std::cos(state.theta());
  return {state.theta_dot() * cos_psi + state.phi_dot() * sin_theta * sin_psi,
          state.theta_dot() * sin_psi - state.phi_dot() * sin_theta * cos_psi,
          state.psi_dot() + state.phi_dot() * cos_theta};
}

inline SpaceVector omega_of(const quaternion::State<double>& state) { return {state.wx(), state.wy(), state.wz()}; }

template <class State>
Quaternion<double> attitude_of(const State& state) {
  return from_euler(state.psi(), state.theta(), state.phi());
}

inline Quaternion<double> attitude_of(const quaternion::State<double>& state) {
  return {state.e0(), state.e1(), state.e2(), state.e3()};
}

// A force that the generator knows to be zero is not in the header.
template <class Forces>
auto force_around(int, const Forces& forces, std::size_t i) -> decltype(forces.rolling_around.force_on_ball[i] + 0) {
  return forces.rolling_around.force_on_ball[i];
}
template <class Forces>
double force_around(long, const Forces&, std::size_t) {
  return 0;
}

/// The force on the ball at the contact point: what the wall (rho) and the two rolling constraints exert together.
template <class Forces>
SpaceVector contact_force(const Forces& forces) {
  SpaceVector sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i] = forces.rho.force_on_ball[i] + force_around(0, forces, i) + forces.rolling_along.force_on_ball[i];
  }
  return sum;
}

/// What the generated code says about a state.
template <class State, class Inputs, class Prepared, class Forces>
Sample observe(double t, const State& state, const Inputs& inputs, const Prepared& prepared, Forces& forces) {
  Sample sample;
  sample.status = reaction_forces(t, state, inputs, prepared, forces);
  sample.t = t;
  sample.attitude = attitude_of(state);
  sample.motion = {state.chi(),
                   state.chi_dot(),
                   state.zeta(),
                   state.zeta_dot(),
                   along_cylinder(omega_of(state), state.chi()),
                   along_cylinder(contact_force(forces), state.chi())};
  return sample;
}

/// Speed (m/s) of the ball's material point at the contact: v + omega x r e_r. From kinematics alone, so that it can judge a
/// constraint that is wrong.
template <class State>
double contact_speed(const State& state, double R, double r) {
  const CylinderVector omega = along_cylinder(omega_of(state), state.chi());
  return std::hypot((R - r) * state.chi_dot() + r * omega[2], state.zeta_dot() - r * omega[1]);
}

}  // namespace sphere
