#pragma once
// The derivatives of an emitted right-hand side without its Jacobian: by dual numbers, and by differences in long double.

#include <vector>

#include "gauss/scalar/dual.hpp"

namespace derivatives {

using Matrix = std::vector<double>;  ///< one row after the other

/// A model at one state. Columns: the components of the state, the inputs, the time.
template <class M>
class Rates {
 public:
  static constexpr int n = M::n_q + M::n_v;
  static constexpr int n_inputs = M::n_inputs;
  static constexpr int columns = n + n_inputs + 1;

  Rates(double time, const typename M::template State<double>& state,
        const typename M::template Inputs<double>& inputs) {
    for (int i = 0; i < n; ++i) point_.push_back(state.values[i]);
    for (int i = 0; i < n_inputs; ++i) point_.push_back(inputs.*M::template inputs_of<double>()[i]);
    point_.push_back(time);
  }

  Matrix by_dual_numbers() const {
    using S = gauss::Dual<double, columns>;
    const auto variable = [&](int k) { return S::variable(at(k), k); };
    Matrix result;
    for (const S& rate : rates<S>(variable)) result.insert(result.end(), rate.tangent, rate.tangent + columns);
    return result;
  }

  /// Central differences of two steps, extrapolated: the error is of the fourth order in the step.
  Matrix by_differences() const {
    Matrix result(static_cast<std::size_t>(n * columns));
    for (int k = 0; k < columns; ++k) {
      const auto wide = quotients(k, 2 * k_step), narrow = quotients(k, k_step);
      for (std::size_t i = 0; i < wide.size(); ++i)
        result[i * columns + static_cast<std::size_t>(k)] = static_cast<double>((4 * narrow[i] - wide[i]) / 3);
    }
    return result;
  }

 private:
  static constexpr long double k_step = 1e-4L;

  double at(int k) const { return point_[static_cast<std::size_t>(k)]; }

  template <class S, class Variable>
  std::vector<S> rates(const Variable& variable) const {
    typename M::template State<S> state;
    typename M::template Inputs<S> inputs{};
    for (int i = 0; i < n; ++i) state.values[i] = variable(i);
    for (int i = 0; i < n_inputs; ++i) inputs.*M::template inputs_of<S>()[i] = variable(n + i);
    const auto prepared = prepare(typename M::template Parameters<S>{});
    typename M::template Derivative<S> derivative;
    (void)rhs(variable(n + n_inputs), state, inputs, prepared, derivative);
    return {derivative.values, derivative.values + n};
  }

  std::vector<long double> quotients(int of, long double step) const {
    const auto moved = [&](long double by) {
      return rates<long double>([&, by](int k) { return at(k) + (k == of ? by : 0); });
    };
    std::vector<long double> ahead = moved(step);
    const std::vector<long double> behind = moved(-step);
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] = (ahead[i] - behind[i]) / (2 * step);
    return ahead;
  }

  std::vector<double> point_;
};

}  // namespace derivatives
