#pragma once
// double and long double: the operations that emitted code performs, in the same order.

#include "evaluate/arithmetic.hpp"

namespace gaussgen::evaluate {

/// Shared by the built-in floating types.
template <class F>
class NativeArithmetic {
 public:
  F number(const Rational& value) const;
  F pi() const;
  F epsilon() const;
  Outcome<F> sum(const Rational& constant, const ir::Coefficients& coefficients, const std::vector<F>& x) const;
  Outcome<F> product(const std::vector<F>& x) const;
  Outcome<F> power(F x, const Rational& exponent) const;
  Outcome<F> call(ir::Function function, const std::vector<F>& x) const;
  bool less(F a, F b) const { return a < b; }
  bool is_true(F x) const { return x != 0; }
};

template <>
class Arithmetic<double> : public NativeArithmetic<double> {};
template <>
class Arithmetic<long double> : public NativeArithmetic<long double> {};

/// The value of a finite floating-point number without rounding.
Rational exact(double value);
Rational exact(long double value);

}  // namespace gaussgen::evaluate
