#include "newton/course.hpp"

#include <limits>

namespace agreement::newton {

using gaussgen::model::Coordinate;
using gaussgen::model::Model;
using gaussgen::model::Orientation;

namespace {

const Real k_unspecified = std::numeric_limits<Real>::quiet_NaN();

/// Half the product of a quaternion with (0, ω), on the side where ω is resolved.
std::array<Real, 4> rate(const std::array<Real, 4>& e, const Real* omega, bool in_space) {
  const Vector3 v(e[1], e[2], e[3]);
  const Vector3 w(omega[0], omega[1], omega[2]);
  const Vector3 turn = in_space ? w.cross(v) : v.cross(w);
  const Vector3 result = (e[0] * w + turn) / 2;
  return {-v.dot(w) / 2, result[0], result[1], result[2]};
}

}  // namespace

Values constants(const Model& model) {
  Values values;
  values["pi"] = constant(functions::acos(Real(-1)));
  for (const auto& parameter : model.parameters) {
    const Number value = Motion(model, values)(parameter.value);
    values[parameter.name.text] = value;
  }
  for (const auto& input : model.inputs) {
    const Number value = Motion(model, values)(input.value);
    values[input.name.text] = value;
  }
  return values;
}

Values at_rest(const Values& values) {
  Values result;
  for (const auto& [name, value] : values) result[name] = constant(value.value);
  return result;
}

Course::Course(const Model& model, const Values& constants, const State& state)
    : model_(model), state_(state), fixed_(constants) {
  fixed_["t"] = {state.time, 1, 0};
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    if (coordinate.held_at) {
      held_.push_back(i);
      const Number value = Motion(model, fixed_)(*coordinate.held_at);
      fixed_[coordinate.name.text] = value;
      continue;
    }
    rates_.push_back(state.speeds[free_.size()]);
    if (coordinate.speed) slow_.push_back(free_.size());
    free_.push_back(i);
  }
  if (!slow_.empty()) solve_rates();
}

Motion Course::motion(const std::vector<Real>& accelerations, std::size_t pushed) {
  Values values = fixed_;
  if (pushed < held_.size()) values[model_.coordinates[held_[pushed]].name.text].second += 1;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Coordinate& coordinate = model_.coordinates[free_[i]];
    values[coordinate.name.text] = {Real(state_.configuration[i]), rates_[i], accelerations[i]};
    if (coordinate.speed) {
      values[model_.speeds[*coordinate.speed].name.text] = {Real(state_.speeds[i]), accelerations[i], k_unspecified};
    }
  }
  for (std::size_t i = 0; i < model_.orientations.size(); ++i) bind_orientation(i, accelerations, values);
  if (!slow_.empty()) solve_second(accelerations, values);
  return {model_, std::move(values)};
}

Motion Course::unit_acceleration(std::size_t i) {
  std::vector<Real> accelerations(free_count(), 0.0);
  if (i < free_count()) accelerations[i] = 1;
  return motion(accelerations, i < free_count() ? held_.size() : i - free_count());
}

void Course::bind_orientation(std::size_t index, const std::vector<Real>& accelerations, Values& values) const {
  const Orientation& orientation = model_.orientations[index];
  const bool in_space = orientation.axes == gaussgen::model::Axes::space;
  const double* first = &state_.configuration[free_.size() + 4 * index];
  const double* speeds = &state_.speeds[free_.size() + 3 * index];
  const std::array<Real, 3> omega{speeds[0], speeds[1], speeds[2]};
  const Real* omega_dot = &accelerations[free_.size() + 3 * index];
  const std::array<Real, 4> e{first[0], first[1], first[2], first[3]};
  const std::array<Real, 4> e_dot = rate(e, omega.data(), in_space);
  const std::array<Real, 4> turning = rate(e_dot, omega.data(), in_space);
  const std::array<Real, 4> speeding = rate(e, omega_dot, in_space);
  for (std::size_t i = 0; i < 4; ++i) {
    values[orientation.quaternion[i].text] = {e[i], e_dot[i], turning[i] + speeding[i]};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    values[orientation.angular_velocity[i].text] = {omega[i], omega_dot[i], k_unspecified};
  }
}

// Definitions are linear in the rates, so their values at single rates are their matrix.
void Course::solve_rates() {
  std::vector<Real> none(free_count(), 0.0);
  Values values = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    values[model_.coordinates[free_[i]].name.text] = {Real(state_.configuration[i]), rates_[i], 0};
  }
  for (std::size_t i = 0; i < model_.orientations.size(); ++i) bind_orientation(i, none, values);
  const auto n = static_cast<Eigen::Index>(slow_.size());
  VectorX u(n);
  const auto set = [&](std::size_t k, Real rate) { values[model_.coordinates[free_[slow_[k]]].name.text].rate = rate; };
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    set(k, 0);
    u[static_cast<Eigen::Index>(k)] = state_.speeds[slow_[k]];
  }
  const VectorX without = of_definitions(values, false);
  MatrixX definitions(n, n);
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    set(k, 1);
    definitions.col(static_cast<Eigen::Index>(k)) = of_definitions(values, false) - without;
    set(k, 0);
  }
  from_speeds_ = definitions.inverse();
  drift_ = -from_speeds_ * without;
  const VectorX rates = from_speeds_ * u + drift_;
  for (std::size_t k = 0; k < slow_.size(); ++k) rates_[slow_[k]] = rates[static_cast<Eigen::Index>(k)];
}

void Course::solve_second(const std::vector<Real>& accelerations, Values& values) const {
  VectorX wanted(static_cast<Eigen::Index>(slow_.size()));
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    values[model_.coordinates[free_[slow_[k]]].name.text].second = 0;
    wanted[static_cast<Eigen::Index>(k)] = accelerations[slow_[k]];
  }
  const VectorX second = from_speeds_ * (wanted - of_definitions(values, true));
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    values[model_.coordinates[free_[slow_[k]]].name.text].second = second[static_cast<Eigen::Index>(k)];
  }
}

/// By slow coordinate: the definition of the speed that takes the place of its rate.
VectorX Course::of_definitions(Values values, bool second) const {
  Motion motion(model_, std::move(values));
  VectorX result(static_cast<Eigen::Index>(slow_.size()));
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    const Number value = motion(model_.speeds[*model_.coordinates[free_[slow_[k]]].speed].is);
    result[static_cast<Eigen::Index>(k)] = second ? value.rate : value.value;
  }
  return result;
}

/// Rates of free coordinates and quaternions at these speeds, without the part of time.
void Course::displace(const std::vector<Real>& speeds, Values& values) const {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Coordinate& coordinate = model_.coordinates[free_[i]];
    values[coordinate.name.text] = {Real(state_.configuration[i]), speeds[i], 0};
    if (coordinate.speed) values[model_.speeds[*coordinate.speed].name.text] = {0, speeds[i], 0};
  }
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    Real rate = 0;
    for (std::size_t j = 0; j < slow_.size(); ++j) {
      rate += from_speeds_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) * speeds[slow_[j]];
    }
    values[model_.coordinates[free_[slow_[k]]].name.text].rate = rate;
  }
  for (std::size_t i = 0; i < model_.orientations.size(); ++i) displace_orientation(i, speeds, values);
}

void Course::displace_orientation(std::size_t index, const std::vector<Real>& speeds, Values& values) const {
  const Orientation& orientation = model_.orientations[index];
  const double* first = &state_.configuration[free_.size() + 4 * index];
  const std::array<Real, 4> e{first[0], first[1], first[2], first[3]};
  const Real* omega = &speeds[free_.size() + 3 * index];
  const std::array<Real, 4> e_dot = rate(e, omega, orientation.axes == gaussgen::model::Axes::space);
  for (std::size_t i = 0; i < 4; ++i) values[orientation.quaternion[i].text] = {e[i], e_dot[i], 0};
  for (std::size_t i = 0; i < 3; ++i) values[orientation.angular_velocity[i].text] = {0, omega[i], 0};
}

Motion Course::displacement(std::size_t i) {
  std::vector<Real> speeds(free_count(), 0.0);
  if (i < free_count()) speeds[i] = 1;
  Values values = at_rest(fixed_);
  displace(speeds, values);
  if (i >= free_count()) values[model_.coordinates[held_[i - free_count()]].name.text].rate = 1;
  return {model_, std::move(values)};
}

Motion Course::passage_of_time() {
  Values values = at_rest(fixed_);
  displace(std::vector<Real>(free_count(), 0.0), values);
  values["t"].rate = 1;
  for (std::size_t k = 0; k < slow_.size(); ++k) {
    values[model_.coordinates[free_[slow_[k]]].name.text].rate = drift_[static_cast<Eigen::Index>(k)];
  }
  return {model_, std::move(values)};
}

std::vector<Real> Course::rates() const {
  std::vector<Real> result(state_.speeds.begin(), state_.speeds.end());
  for (const std::size_t i : held_) result.push_back(fixed_.at(model_.coordinates[i].name.text).rate);
  return result;
}

}  // namespace agreement::newton
