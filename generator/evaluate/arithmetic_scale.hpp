#pragma once
// Absolute sums: how large the numbers were that went into a value. The error of an evaluation in a type with rounding
// unit eps is a small multiple of eps times this scale, whatever cancelled on the way.

#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"

namespace gaussgen::evaluate {

/// A value v and its scale s >= |v|:
///   constants and symbols |v|, sums |c| + Σ |c_i| s_i, products Π s_i, or Σ s_i Π |v_j| (j ≠ i) where that is less, whole positive
///   powers likewise;
///   everything else max(|f(v)|, Σ |∂f/∂x_i| s_i), the first-order bound.
template <class T>
struct Scaled {
  T value;
  T scale;
};

template <class T>
class Arithmetic<Scaled<T>> {
 public:
  explicit Arithmetic(Arithmetic<T> base) : base_(std::move(base)) {}

  /// A bound symbol: exact up to rounding.
  Scaled<T> input(const T& value) const { return {value, magnitude(value)}; }

  Scaled<T> number(const Rational& value) const { return input(base_.number(value)); }
  Scaled<T> pi() const { return input(base_.pi()); }
  Scaled<T> epsilon() const { return input(base_.epsilon()); }
  Outcome<Scaled<T>> sum(const Rational& constant, const ir::Coefficients& coefficients,
                         const std::vector<Scaled<T>>& x) const;
  Outcome<Scaled<T>> product(const std::vector<Scaled<T>>& x) const;
  Outcome<Scaled<T>> power(const Scaled<T>& x, const Rational& exponent) const;
  Outcome<Scaled<T>> call(ir::Function function, const std::vector<Scaled<T>>& x) const;
  bool less(const Scaled<T>& a, const Scaled<T>& b) const { return base_.less(a.value, b.value); }
  bool is_true(const Scaled<T>& x) const { return base_.is_true(x.value); }

 private:
  T magnitude(const T& x) const { return x < base_.number(Rational(0)) ? T(-x) : x; }
  Outcome<Scaled<T>> joined(const Outcome<T>& value, const Outcome<T>& scale) const;
  Outcome<T> lesser(const Outcome<T>& a, const T& b) const;
  Outcome<T> slope(ir::Function function, const T& x) const;
  Outcome<T> spread(ir::Function function, const std::vector<Scaled<T>>& x) const;

  Arithmetic<T> base_;
};

}  // namespace gaussgen::evaluate
