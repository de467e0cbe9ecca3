#pragma once
// A naive form of every constrained model: the whole system [g, -b^T; b, 0] by elimination with partial pivoting, whatever its rank.

#include <cmath>
#include <utility>

#include "gauss/integrate/held_partition.hpp"

namespace hard_cases {

/// Accelerations, then multipliers; what is divided by 0 is not finite.
template <int n, int l, class System>
void eliminate_all(const System& system, double (&x)[n + l]) {
  constexpr int size = n + l;
  double a[size][size + 1] = {};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) a[i][j] = system.g[i][j];
    for (int mu = 0; mu < l; ++mu) a[n + mu][i] = system.b[mu][i], a[i][n + mu] = -system.b[mu][i];
    a[i][size] = system.f[i];
  }
  for (int mu = 0; mu < l; ++mu) a[n + mu][size] = -system.drift[mu];
  for (int k = 0; k < size; ++k) {
    int largest = k;
    for (int i = k + 1; i < size; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[largest][k])) largest = i;
    }
    std::swap(a[k], a[largest]);
    for (int i = k + 1; i < size; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j <= size; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  for (int i = size - 1; i >= 0; --i) {
    x[i] = a[i][size];
    for (int j = i + 1; j < size; ++j) x[i] -= a[i][j] * x[j];
    x[i] /= a[i][i];
  }
}

/// The model `Base` with accelerations found so.
template <class Base, class System>
class WithoutRank : public gauss::integrate::PartitionedModel<Base, System> {
  using Parent = gauss::integrate::PartitionedModel<Base, System>;

 public:
  using typename Parent::Derivative;
  using typename Parent::State;

  explicit WithoutRank(const Base& base) : Parent(base, {}) {}

  gauss::Status derivative(double t, const State& state, Derivative& result) const {
    System system;
    (void)this->linear_system(t, state, system);
    double x[Parent::n + Parent::l];
    eliminate_all<Parent::n, Parent::l>(system, x);
    typename Parent::Solution solution{};
    for (int i = 0; i < Parent::n; ++i) solution.accelerations[i] = x[i];
    return gauss::integrate::detail::rates_of(t, state, this->inputs(t, state), this->prepared(), solution, result);
  }
};

}  // namespace hard_cases
