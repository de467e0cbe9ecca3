#pragma once
// States, accelerations and forces of the files that tools/oracles writes, which name them as the models do.

#include <cmath>
#include <string>

#include "catch_shim.hpp"
#include "follow.hpp"
#include "reference.hpp"

namespace physics {

template <class Model>
typename Model::template State<double> state_of(const reference::Json& named) {
  typename Model::template State<double> state{};
  for (int i = 0; i < Model::n_q; ++i) state.values[i] = reference::number(named.at(Model::coordinates[i].name));
  for (int i = 0; i < Model::n_v; ++i)
    state.values[Model::n_q + i] = reference::number(named.at(Model::speeds[i].name));
  return state;
}

/// x_ddot of x_dot, p_dot of p
inline std::string acceleration_of(const std::string& speed) {
  const std::string rate = "_dot";
  if (speed.size() <= rate.size() || speed.substr(speed.size() - rate.size()) != rate) return speed + rate;
  return speed.substr(0, speed.size() - rate.size()) + "_ddot";
}

/// Accelerations at a state, to `tolerance` of the largest; those that the file does not name are not compared.
template <class Model, class Inputs, class Prepared>
void check_accelerations(const reference::Json& sample, const Inputs& inputs, const Prepared& prepared,
                         double tolerance) {
  const auto state = state_of<Model>(sample["state"]);
  typename Model::template Derivative<double> found;
  REQUIRE(Model::rhs(reference::number(sample["t"]), state, inputs, prepared, found) == gauss::Status::ok);
  double size = 1;
  for (const auto& value : sample["accelerations"]) size = std::max(size, std::abs(reference::number(value)));
  std::size_t compared = 0;
  for (int i = 0; i < Model::n_v; ++i) {
    const std::string name = acceleration_of(Model::speeds[i].name);
    if (!sample["accelerations"].contains(name)) continue;
    INFO(name);
    CHECK(found.values[Model::n_q + i] ==
          Approx(reference::number(sample["accelerations"][name])).epsilon(0).margin(tolerance * size));
    ++compared;
  }
  CHECK(compared == sample["accelerations"].size());
}

/// Every coordinate and rate, relative to 1 or its size.
template <class Model>
void check_state(const reference::Json& named, const typename Model::template State<double>& found, double tolerance) {
  const auto expected = state_of<Model>(named);
  for (int i = 0; i < Model::n_q + Model::n_v; ++i) {
    INFO((i < Model::n_q ? Model::coordinates[i] : Model::speeds[i - Model::n_q]).name);
    const double size = std::max(1.0, std::abs(expected.values[i]));
    CHECK(found.values[i] == Approx(expected.values[i]).epsilon(0).margin(tolerance * size));
  }
}

/// The largest component of any force of a sample: what forces are compared relative to.
inline double size_of_forces(const reference::Json& forces) {
  double size = 1;
  for (const auto& force : forces)
    for (const auto& component : force) size = std::max(size, std::abs(reference::number(component)));
  return size;
}

template <class Vector>
void check_vector(const reference::Json& expected, const Vector& found, double margin) {
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(found[i] == Approx(reference::number(expected[i])).epsilon(0).margin(margin));
}

/// Force and moment that a joint transmits; the file may leave the moment out.
template <class Wrench>
void check_joint(const reference::Json& forces, const std::string& name, const Wrench& found, double margin) {
  INFO(name);
  check_vector(forces.at(name), found.force, margin);
  if (forces.contains(name + ".moment")) check_vector(forces.at(name + ".moment"), found.moment, margin);
}

/// At a state accelerations and forces are good to rounding; along a motion they carry what the integration leaves.
inline constexpr double k_state = 1e-12;
inline constexpr double k_motion = 1e-10;

/// `check_forces(sample, state, inputs, prepared, margin)` at the states of a file and along its motion.
template <class Model, class Prepared, class Inputs, class CheckForces>
void check_motion(const reference::Json& file, const Prepared& prepared, const Inputs& inputs,
                  const typename Model::template State<double>& start, CheckForces&& check_forces) {
  follow<Model>(file["expected"]["motion"], prepared, inputs, start,
                [&](const auto& sample, double, const auto& state) {
                  check_state<Model>(sample["state"], state, k_motion);
                  check_forces(sample, state, inputs, k_motion * size_of_forces(sample["forces"]));
                });
}

template <class Model, class Prepared, class InputsOf, class CheckForces>
void check_states(const reference::Json& file, const Prepared& prepared, InputsOf&& inputs_of,
                  CheckForces&& check_forces) {
  REQUIRE(file["expected"]["states"].size() >= 4);
  for (const auto& sample : file["expected"]["states"]) {
    const auto inputs = inputs_of(sample);
    check_accelerations<Model>(sample, inputs, prepared, k_state);
    check_forces(sample, state_of<Model>(sample["state"]), inputs, k_state * size_of_forces(sample["forces"]));
  }
}

}  // namespace physics
