#pragma once
// What tests of steppers and simulations have in common: starts, and how far two states are from each other.

#include <cmath>
#include <iterator>

#include "catch_shim.hpp"
#include "gauss/integrate/bound_model.hpp"

namespace physics {

/// The initial state of the model's file.
template <class Model>
typename Model::State start_of(const Model& model) {
  typename Model::State state;
  REQUIRE(initial_state(model.prepared(), state) == gauss::Status::ok);
  return state;
}

/// Makes `largest` the largest size so far; what is not a number stays.
inline void grow(double& largest, double value) {
  const double size = std::abs(value);
  if (!std::isnan(largest) && !(size <= largest)) largest = size;
}

/// Largest component of the difference of two states, or of two derivatives.
template <class Values>
auto distance(const Values& a, const Values& b) -> decltype(std::size(a.values), 0.0) {
  double largest = 0;
  for (std::size_t i = 0; i < std::size(a.values); ++i) grow(largest, a.values[i] - b.values[i]);
  return largest;
}

}  // namespace physics
