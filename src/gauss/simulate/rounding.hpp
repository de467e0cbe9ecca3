// What rounding of a time makes of a step, and of a state of a function of it.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_ROUNDING_HPP
#define GAUSS_SIMULATE_ROUNDING_HPP

#include <algorithm>
#include <cstddef>

#include "gauss/math.hpp"

namespace gauss::simulate {

/// Whether a step leads to `end`, or so near that what is left is no more than rounding of times, and little beside the step: where steps have a longest length and a whole number of them leads
/// there, that is no step of its own. Behind a refused step, none is made longer: it could be that one again.
template <class Scalar>
bool arrives(const Scalar& t, const Scalar& dt, const Scalar& end, bool was_refused) {
  if (was_refused) return t + dt >= end;
  const auto size_of = [](const Scalar& a) { return a < Scalar(0) ? Scalar(-a) : a; };
  const Scalar rounding = 8 * Math<Scalar>::epsilon() * std::max(size_of(t), size_of(end));
  return t + dt >= end - std::min(rounding, Scalar(dt / 8));
}

/// How far a function of a state changes when the state is rounded otherwise: the smaller of two changes in opposite directions, of eight units in the last place, so that an edge
/// on one side is none. `apply(state, result)` is false where it has no value. Scalars may be lanes.
template <class Array, class Apply>
bool changes_by_rounding(const Array& x, const Array& value, const Apply& apply, Array& changes) {
  using Scalar = typename Array::value_type;
  using Logic = Math<Scalar>;
  const auto size_of = [](const Scalar& a) { return Logic::select(Logic::less(a, Scalar(0)), -a, a); };
  for (const int sign : {1, -1}) {
    Array moved = x, result = x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      // Not the same for all components, which would be a change of units: many models have none of.
      const Scalar share = Scalar(i % 2 == 0 ? sign : -sign) * (Scalar(8) - Scalar(static_cast<int>(i % 5)));
      moved[i] = x[i] + share * Logic::epsilon() * x[i];
    }
    if (!apply(moved, result)) return false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Scalar change = size_of(result[i] - value[i]);
      changes[i] = sign > 0 ? change : Logic::select(Logic::less(change, changes[i]), change, changes[i]);
    }
  }
  return true;
}

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_ROUNDING_HPP
