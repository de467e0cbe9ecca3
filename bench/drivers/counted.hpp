#pragma once
// A number that counts what is done with it. What is computed from constants of the text alone costs nothing: compilers do it.

#include <cmath>

#include "contender.hpp"

namespace bench {

class Counted {
 public:
  Counted() = default;
  Counted(double value) : value_(value), is_constant_(!numbers_vary()) {}  // NOLINT(google-explicit-constructor): numbers in a text
  static Counted variable(double value) {
    Counted result(value);
    result.is_constant_ = false;
    return result;
  }

  /// While parameters get their values.
  static bool& numbers_vary() {
    static bool are_parameters = false;
    return are_parameters;
  }

  double value() const { return value_; }
  static Operations& tally() {
    static Operations operations;
    return operations;
  }

  friend Counted operator-(const Counted& a) { return like(a, -a.value_); }
  friend Counted operator+(const Counted& a, const Counted& b) {
    return counted(tally().additions, a, b, a.value_ + b.value_);
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return counted(tally().additions, a, b, a.value_ - b.value_);
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return counted(tally().multiplications, a, b, a.value_ * b.value_);
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return counted(tally().divisions, a, b, a.value_ / b.value_);
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }

  friend Counted sin(const Counted& x) { return function(x, std::sin(x.value_)); }
  friend Counted cos(const Counted& x) { return function(x, std::cos(x.value_)); }
  friend Counted tan(const Counted& x) { return function(x, std::tan(x.value_)); }
  friend Counted atan(const Counted& x) { return function(x, std::atan(x.value_)); }
  friend Counted sqrt(const Counted& x) { return function(x, std::sqrt(x.value_)); }
  /// Compilers multiply where the exponent is a small whole number.
  friend Counted pow(const Counted& x, const Counted& y) {
    if (y.is_constant_ && y.value_ == 2) return x * x;
    if (y.is_constant_ && y.value_ == -1) return 1.0 / x;
    return function(x, std::pow(x.value_, y.value_));
  }
  friend Counted fabs(const Counted& x) { return like(x, std::fabs(x.value_)); }
  friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value_ == b.value_; }

 private:
  static Counted like(const Counted& a, double value) {
    Counted result(value);
    result.is_constant_ = a.is_constant_;
    return result;
  }
  static Counted counted(long& counter, const Counted& a, const Counted& b, double value) {
    if (a.is_constant_ && b.is_constant_) return {value};
    ++counter;
    return variable(value);
  }
  static Counted function(const Counted& x, double value) {
    if (!x.is_constant_) ++tally().functions;
    return like(x, value);
  }

  double value_ = 0;
  bool is_constant_ = true;
};

// Also by their full names.
Counted sin(const Counted& x);
Counted cos(const Counted& x);
Counted tan(const Counted& x);
Counted atan(const Counted& x);
Counted sqrt(const Counted& x);
Counted pow(const Counted& x, const Counted& y);
Counted fabs(const Counted& x);

inline void sine_and_cosine(double x, double& sine, double& cosine) { ::sincos(x, &sine, &cosine); }
inline void sine_and_cosine(const Counted& x, Counted& sine, Counted& cosine) {
  sine = sin(x);
  cosine = cos(x);
}

/// Of one call of f(q, v, a) at some state.
template <int n, class F>
Operations operations_of(F f) {
  Counted q[n], v[n], a[n];
  for (int i = 0; i < n; ++i) {
    q[i] = Counted::variable(0.3 + 0.11 * i);
    v[i] = Counted::variable(0.7 - 0.23 * i);
  }
  Counted::tally() = {};
  f(q, v, a);
  return Counted::tally();
}

}  // namespace bench
