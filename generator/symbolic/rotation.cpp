#include "symbolic/rotation.hpp"

namespace gaussgen::symbolic {

namespace {

std::size_t axis_of(char letter) { return static_cast<std::size_t>(letter - 'x'); }

/// Axes turned by `angle` about `axis`, as a matrix from the turned axes to the old ones.
Matrix3 elementary_rotation(const ex& angle, std::size_t axis) {
  Matrix3 matrix{unit_vector(0), unit_vector(1), unit_vector(2)};
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  matrix[i][i] = matrix[j][j] = GiNaC::cos(angle);
  matrix[j][i] = GiNaC::sin(angle);
  matrix[i][j] = -matrix[j][i];
  return matrix;
}

/// α̇ a, β̇ b, γ̇ c: each rate along its axis, in the axes in which that axis is a coordinate axis.
Vector3 part(const model::EulerAngles& euler, std::size_t i, const Chart& chart) {
  return chart.rate_of(chart(euler.angles[i])) * unit_vector(axis_of(euler.sequence[i]));
}

Matrix3 step(const model::EulerAngles& euler, std::size_t i, const Chart& chart) {
  return elementary_rotation(chart(euler.angles[i]), axis_of(euler.sequence[i]));
}

}  // namespace

Vector3 body_angular_velocity(const model::Model& model, const model::Body& body, const Chart& chart) {
  if (const auto* euler = std::get_if<model::EulerAngles>(&body.orientation)) {
    const Vector3 inner = part(*euler, 1, chart) + multiply(transposed(step(*euler, 1, chart)), part(*euler, 0, chart));
    return part(*euler, 2, chart) + multiply(transposed(step(*euler, 2, chart)), inner);
  }
  const std::size_t index = std::get<model::QuaternionOrientation>(body.orientation).index;
  if (model.orientations[index].frame == model::Frame::body) return chart.omega(index);
  return multiply(transposed(rotation_matrix(chart.attitude(index))), chart.omega(index));
}

Vector3 shortest_angular_velocity(const model::Body& body, const Chart& chart) {
  if (const auto* euler = std::get_if<model::EulerAngles>(&body.orientation)) {
    // b is fixed in the axes after the first rotation, and a is one of their axes.
    return part(*euler, 0, chart) + part(*euler, 1, chart) + multiply(step(*euler, 1, chart), part(*euler, 2, chart));
  }
  return chart.omega(std::get<model::QuaternionOrientation>(body.orientation).index);
}

}  // namespace gaussgen::symbolic
