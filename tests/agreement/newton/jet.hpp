#pragma once
// Numbers, vectors and matrices with their first two derivatives along a motion.

#include <Eigen/Dense>
#include <cmath>

namespace agreement::newton {

template <class T>
struct Jet {
  T value;
  T rate;
  T second;
};

using Number = Jet<double>;
using Vector = Jet<Eigen::Vector3d>;
using Matrix = Jet<Eigen::Matrix3d>;

inline Number constant(double value) { return {value, 0, 0}; }

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
          a.second * b.value + 2 * (a.rate * b.rate) + a.value * b.second};
}

inline Number operator*(const Number& a, const Number& b) { return product<double>(a, b); }
inline Vector operator*(const Number& a, const Vector& b) { return product<Eigen::Vector3d>(a, b); }
inline Vector operator*(const Matrix& a, const Vector& b) { return product<Eigen::Vector3d>(a, b); }
inline Matrix operator*(const Matrix& a, const Matrix& b) { return product<Eigen::Matrix3d>(a, b); }

inline Matrix transposed(const Matrix& a) { return {a.value.transpose(), a.rate.transpose(), a.second.transpose()}; }

/// f(a) by f, f' and f'' at the value.
inline Number composed(const Number& a, double f, double f1, double f2) {
  return {f, f1 * a.rate, f2 * a.rate * a.rate + f1 * a.second};
}

/// Zero where a constant factor is, whatever the power would be: the derivatives of x^1 at 0.
inline double monomial(double factor, double x, double exponent) {
  return factor == 0 ? 0 : factor * std::pow(x, exponent);
}

inline Number pow(const Number& a, double n) {
  return composed(a, std::pow(a.value, n), monomial(n, a.value, n - 1), monomial(n * (n - 1), a.value, n - 2));
}

inline Number sin(const Number& a) { return composed(a, std::sin(a.value), std::cos(a.value), -std::sin(a.value)); }
inline Number cos(const Number& a) { return composed(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value)); }

inline Number atan2(const Number& y, const Number& x) {
  const double square = x.value * x.value + y.value * y.value;
  const double top = x.value * y.rate - y.value * x.rate;
  const double top_rate = x.value * y.second - y.value * x.second;
  const double square_rate = 2 * (x.value * x.rate + y.value * y.rate);
  return {std::atan2(y.value, x.value), top / square, top_rate / square - top * square_rate / (square * square)};
}

}  // namespace agreement::newton
