#include "symbolic/frames.hpp"

#include "symbolic/chart.hpp"

namespace gaussgen::symbolic {

namespace {

std::size_t axis_of(char letter) { return static_cast<std::size_t>(letter - 'x'); }

Vector3 direction(const model::Turn& turn, const Chart& chart) {
  if (const char* letter = std::get_if<char>(&turn.axis)) return unit_vector(axis_of(*letter));
  const Vector3 v = chart(std::get<std::array<model::Ast, 3>>(turn.axis));
  return GiNaC::pow(dot(v, v), GiNaC::numeric(-1, 2)) * v;
}

/// From the turned axes to those before: each axis e of the turned ones is n (n·e) + cos (e - n (n·e)) + sin n × e.
Matrix3 rotation(const Vector3& n, const ex& angle) {
  Matrix3 columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 e = unit_vector(i);
    const Vector3 along = n[i] * n;
    columns[i] = along + GiNaC::cos(angle) * (e - along) + GiNaC::sin(angle) * cross(n, e);
  }
  return transposed(columns);
}

Matrix3 step(const model::Turn& turn, const Chart& chart) {
  return rotation(direction(turn, chart), chart(turn.angle));
}

/// α̇ n, in the axes before the turn and in those after it.
Vector3 part(const model::Turn& turn, const Chart& chart) {
  return chart.rate_of(chart(turn.angle)) * direction(turn, chart);
}

}  // namespace

const Placement& Frames::operator()(std::size_t frame) const {
  const auto known = placed_.find(frame);
  return known != placed_.end() ? known->second : placed_.emplace(frame, place(frame)).first->second;
}

Vector3 Frames::point(std::size_t frame, const std::array<model::Ast, 3>& inside) const {
  if (frame == model::k_space) return chart_(inside);
  const Placement& placement = (*this)(frame);
  return placement.origin + multiply(placement.axes, chart_(inside));
}

Placement Frames::place(std::size_t index) const {
  const model::Frame& frame = model_.frames[index];
  Placement placement;
  if (frame.parent == model::k_space) {
    placement = {chart_(frame.position), {unit_vector(0), unit_vector(1), unit_vector(2)}, {0, 0, 0}};
  } else {
    const Placement& parent = (*this)(frame.parent);
    placement = {point(frame.parent, frame.position), parent.axes, parent.omega_body};
  }
  if (const auto* turns = std::get_if<model::Turns>(&frame.attitude)) {
    for (const model::Turn& turn : *turns) {
      const Matrix3 matrix = step(turn, chart_);
      placement.axes = multiply(placement.axes, matrix);
      placement.omega_body = part(turn, chart_) + multiply(transposed(matrix), placement.omega_body);
    }
  } else if (const auto* quaternion = std::get_if<model::QuaternionOrientation>(&frame.attitude)) {
    const Matrix3 matrix = rotation_matrix(chart_.attitude(quaternion->index));
    const bool in_body = model_.orientations[quaternion->index].axes == model::Axes::body;
    const Vector3 carried = multiply(transposed(matrix), placement.omega_body);
    const Vector3& own = chart_.omega(quaternion->index);
    placement.axes = multiply(placement.axes, matrix);
    placement.omega_body = carried + (in_body ? own : multiply(transposed(matrix), own));
  }
  return placement;
}

Vector3 Frames::shortest_angular_velocity(std::size_t index) const {
  const model::Frame& frame = model_.frames[index];
  const auto* turns = std::get_if<model::Turns>(&frame.attitude);
  const auto* quaternion = std::get_if<model::QuaternionOrientation>(&frame.attitude);
  if (frame.parent == model::k_space && quaternion != nullptr) return chart_.omega(quaternion->index);
  if (frame.parent != model::k_space || turns == nullptr || turns->size() != 3) return (*this)(index).omega_body;
  // b is fixed in the axes after the first rotation, and a is one of their axes.
  const model::Turns& turn = *turns;
  return part(turn[0], chart_) + part(turn[1], chart_) + multiply(step(turn[1], chart_), part(turn[2], chart_));
}

}  // namespace gaussgen::symbolic
