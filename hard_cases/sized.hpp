#pragma once
// A number beside the same expression with absolute values: what rounding may do to it, in units of eps.

#include <cmath>
#include <limits>

namespace hard_cases {

/// `size` is |x| of a value that is given. Of a sum it is the sum of the sizes; of products and functions, what their arguments' sizes amount
/// to by the first derivatives, and the value itself.
struct Sized {
  double value = 0;
  double size = 0;

  Sized() = default;
  Sized(double given) : value(given), size(std::abs(given)) {}  // NOLINT: numbers are taken as they are
  Sized(double v, double s) : value(v), size(s) {}

  friend Sized operator-(const Sized& a) { return {-a.value, a.size}; }
  friend Sized operator+(const Sized& a, const Sized& b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator-(const Sized& a, const Sized& b) { return {a.value - b.value, a.size + b.size}; }
  friend Sized operator*(const Sized& a, const Sized& b) { return {a.value * b.value, a.size * b.size}; }
  friend Sized operator/(const Sized& a, const Sized& b) {
    const double divisor = std::abs(b.value);
    return {a.value / b.value, a.size * b.size / (divisor * divisor)};
  }
  friend bool operator<(const Sized& a, const Sized& b) { return a.value < b.value; }
  friend bool operator<=(const Sized& a, const Sized& b) { return a.value <= b.value; }
  friend bool operator==(const Sized& a, const Sized& b) { return a.value == b.value; }

  /// f(a), whose slope is given.
  static Sized of(double f, double slope, const Sized& a) { return {f, std::abs(f) + std::abs(slope) * a.size}; }
};

inline Sized sin(const Sized& a) { return Sized::of(std::sin(a.value), std::cos(a.value), a); }
inline Sized cos(const Sized& a) { return Sized::of(std::cos(a.value), std::sin(a.value), a); }
inline Sized sqrt(const Sized& a) {
  const double root = std::sqrt(a.value);
  return Sized::of(root, 1 / (2 * root), a);
}

}  // namespace hard_cases

template <>
class std::numeric_limits<hard_cases::Sized> : public std::numeric_limits<double> {
 public:
  static hard_cases::Sized epsilon() noexcept { return std::numeric_limits<double>::epsilon(); }
};
