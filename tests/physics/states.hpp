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
  for (int i = 0; i < Model::n_q; ++i) {
    const std::string name = std::string(Model::coordinates[i].name) + "_ddot";
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

}  // namespace physics
