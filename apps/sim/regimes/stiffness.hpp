#pragma once
// How fast a model comes back to where it tends, beside the steps that are made.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gauss/event/dense.hpp"
#include "sim/regimes/regime.hpp"

namespace gausssim {

/// About the largest absolute eigenvalue of the Jacobian, in 1/s: by powers of it on one vector. 0: the model has no Jacobian, or none here.
template <class S>
S fastest_decay(const Regime<S>& regime, const S& t, const Numbers<S>& x) {
  using gauss::event::magnitude_of;
  const MotionModel<S>& model = regime.motion();
  const std::size_t n = x.size();
  gauss::event::DenseMatrix<S> jacobian(n, n);
  const auto fill = [&](std::size_t i, std::size_t j, const S& value) { jacobian(i, j) = value; };
  if (!model.has_jacobian() || !gauss::integrate::is_motion_known(model.jacobian(t, {x}, fill))) return 0;
  constexpr int k_powers = 12;
  Numbers<S> vector(n), next(n);
  for (std::size_t i = 0; i < n; ++i) vector[i] = S(i % 2 == 0 ? 1 : -1) / S(i + 1);
  S growth = 0;
  for (int power = 0; power < k_powers; ++power) {
    growth = 0;
    for (std::size_t i = 0; i < n; ++i) {
      next[i] = 0;
      for (std::size_t j = 0; j < n; ++j) next[i] += jacobian(i, j) * vector[j];
      growth = std::max(growth, magnitude_of(next[i]));
    }
    if (!(growth > S(0))) return 0;
    for (std::size_t i = 0; i < n; ++i) vector[i] = next[i] / growth;
  }
  return growth;
}

}  // namespace gausssim
