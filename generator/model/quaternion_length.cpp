#include "model/quaternion_length.hpp"

#include <cmath>

namespace gaussgen::model {

std::optional<double> initial_length(const Orientation& orientation, const Values& values) {
  double square = 0;
  for (const Ast& component : orientation.initial) {
    const auto value = value_of(component, values);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    square += *value * *value;
  }
  return std::sqrt(square);
}

bool is_length_of_rotation(double length) {
  // Components e_i may then make |e|^2 differ from 1 by 2 sum |e_i| 0.0005, at most 0.002.
  constexpr double k_rounded_square = 2e-3;
  return std::abs(length * length - 1) <= k_rounded_square;
}

}  // namespace gaussgen::model
