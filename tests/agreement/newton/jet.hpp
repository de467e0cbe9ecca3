#pragma once
// Numbers, vectors and matrices with their first two derivatives along a motion.

#include "newton/real.hpp"

namespace agreement::newton {

template <class T>
struct Jet {
  T value;
  T rate;
  T second;
};

using Number = Jet<Real>;
using Vector = Jet<Vector3>;
using Matrix = Jet<Matrix3>;

inline Number constant(Real value) { return {value, 0, 0}; }

template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}

template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}

inline Number operator-(const Number& a) { return {-a.value, -a.rate, -a.second}; }

/// Leibniz, for whatever can be multiplied: the order of the factors is kept.
template <class Result, class A, class B>
Jet<Result> product(const Jet<A>& a, const Jet<B>& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + Real(2) * (a.rate * b.rate) + a.value * b.second};
}

inline Number operator*(const Number& a, const Number& b) { return product<Real>(a, b); }
inline Vector operator*(const Number& a, const Vector& b) { return product<Vector3>(a, b); }
inline Vector operator*(const Matrix& a, const Vector& b) { return product<Vector3>(a, b); }
inline Matrix operator*(const Matrix& a, const Matrix& b) { return product<Matrix3>(a, b); }

inline Matrix transposed(const Matrix& a) { return {a.value.transpose(), a.rate.transpose(), a.second.transpose()}; }

/// f(a) by f, f' and f'' at the value.
inline Number composed(const Number& a, Real f, Real f1, Real f2) {
  return {f, f1 * a.rate, f2 * a.rate * a.rate + f1 * a.second};
}

/// Zero where a constant factor is, whatever the power would be: the derivatives of x^1 at 0.
inline Real monomial(Real factor, Real x, Real exponent) {
  return factor == 0 ? 0 : factor * functions::pow(x, exponent);
}

inline Number pow(const Number& a, Real n) {
  return composed(a, functions::pow(a.value, n), monomial(n, a.value, n - 1), monomial(n * (n - 1), a.value, n - 2));
}

inline Number sin(const Number& a) {
  return composed(a, functions::sin(a.value), functions::cos(a.value), -functions::sin(a.value));
}
inline Number cos(const Number& a) {
  return composed(a, functions::cos(a.value), -functions::sin(a.value), -functions::cos(a.value));
}

inline Number atan2(const Number& y, const Number& x) {
  const Real square = x.value * x.value + y.value * y.value;
  const Real top = x.value * y.rate - y.value * x.rate;
  const Real top_rate = x.value * y.second - y.value * x.second;
  const Real square_rate = 2 * (x.value * x.rate + y.value * y.rate);
  return {functions::atan2(y.value, x.value), top / square, top_rate / square - top * square_rate / (square * square)};
}

}  // namespace agreement::newton
