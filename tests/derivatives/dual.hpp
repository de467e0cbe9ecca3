#pragma once
// A number with its rate: automatic differentiation of the emitted text, by the rules of the chain and nothing of ours.

#include <cmath>
#include <limits>

namespace derivatives {

struct Dual {
  double value = 0;
  double rate = 0;
  Dual() = default;
  explicit Dual(double v, double r = 0) : value(v), rate(r) {}
};

/// f(a) with f'(a): a constant has no rate, whatever the slope there.
inline Dual chained(const Dual& a, double value, double slope) { return Dual(value, a.rate == 0 ? 0 : slope * a.rate); }

inline Dual operator-(const Dual& a) { return Dual(-a.value, -a.rate); }
inline Dual operator+(const Dual& a, const Dual& b) { return Dual(a.value + b.value, a.rate + b.rate); }
inline Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return Dual(a.value * b.value, a.rate * b.value + a.value * b.rate);
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return Dual(quotient, (a.rate - quotient * b.rate) / b.value);
}
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
inline bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

inline Dual sin(const Dual& a) { return chained(a, std::sin(a.value), std::cos(a.value)); }
inline Dual cos(const Dual& a) { return chained(a, std::cos(a.value), -std::sin(a.value)); }
inline Dual tan(const Dual& a) { return chained(a, std::tan(a.value), 1 / (std::cos(a.value) * std::cos(a.value))); }
inline Dual asin(const Dual& a) { return chained(a, std::asin(a.value), 1 / std::sqrt(1 - a.value * a.value)); }
inline Dual acos(const Dual& a) { return chained(a, std::acos(a.value), -1 / std::sqrt(1 - a.value * a.value)); }
inline Dual atan(const Dual& a) { return chained(a, std::atan(a.value), 1 / (1 + a.value * a.value)); }
inline Dual exp(const Dual& a) { return chained(a, std::exp(a.value), std::exp(a.value)); }
inline Dual log(const Dual& a) { return chained(a, std::log(a.value), 1 / a.value); }
inline Dual sinh(const Dual& a) { return chained(a, std::sinh(a.value), std::cosh(a.value)); }
inline Dual cosh(const Dual& a) { return chained(a, std::cosh(a.value), std::sinh(a.value)); }
inline Dual tanh(const Dual& a) {
  const double value = std::tanh(a.value);
  return chained(a, value, 1 - value * value);
}
inline Dual sqrt(const Dual& a) { return chained(a, std::sqrt(a.value), 0.5 / std::sqrt(a.value)); }
inline Dual pow(const Dual& a, const Dual& n) {
  return chained(a, std::pow(a.value, n.value), n.value * std::pow(a.value, n.value - 1));
}
inline Dual atan2(const Dual& y, const Dual& x) {
  const double square = x.value * x.value + y.value * y.value;
  return Dual(std::atan2(y.value, x.value), (x.value * y.rate - y.value * x.rate) / square);
}

}  // namespace derivatives

template <>
struct std::numeric_limits<derivatives::Dual> {
  static derivatives::Dual epsilon() { return derivatives::Dual(std::numeric_limits<double>::epsilon()); }
};
