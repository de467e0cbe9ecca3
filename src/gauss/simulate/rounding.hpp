// What rounding of a time makes of a step.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_ROUNDING_HPP
#define GAUSS_SIMULATE_ROUNDING_HPP

#include <algorithm>

#include "gauss/math.hpp"

namespace gauss::simulate {

/// Whether a step leads to `end`, or so near that what is left is no more than rounding of times, and little beside the step: where steps have a longest length and a whole number of them leads
/// there, that is no step of its own.
template <class Scalar>
bool arrives(const Scalar& t, const Scalar& dt, const Scalar& end) {
  const auto size_of = [](const Scalar& a) { return a < Scalar(0) ? Scalar(-a) : a; };
  const Scalar rounding = 8 * Math<Scalar>::epsilon() * std::max(size_of(t), size_of(end));
  // A shorter step than one that was refused is another one.
  return t + dt >= end - std::min(rounding, Scalar(dt / 8));
}

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_ROUNDING_HPP
