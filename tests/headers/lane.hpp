#pragma once
// One lane of a batch as a scalar: the same arithmetic, one number at a time, with the batch library's own functions.

#include "gauss/scalar/xsimd.hpp"

namespace headertest {

template <class T>
struct Lane {
  T value{};

  Lane() = default;
  explicit Lane(T number) : value(number) {}
  template <class Number>
  explicit Lane(Number number) : value(static_cast<T>(number)) {}
  explicit operator double() const { return static_cast<double>(value); }

  friend Lane operator+(Lane a, Lane b) { return Lane(a.value + b.value); }
  friend Lane operator-(Lane a, Lane b) { return Lane(a.value - b.value); }
  friend Lane operator*(Lane a, Lane b) { return Lane(a.value * b.value); }
  friend Lane operator/(Lane a, Lane b) { return Lane(a.value / b.value); }
  friend Lane operator-(Lane a) { return Lane(-a.value); }
  friend bool operator<(Lane a, Lane b) { return a.value < b.value; }
  friend bool operator==(Lane a, Lane b) { return a.value == b.value; }
};

}  // namespace headertest

namespace gauss {

template <class T>
struct Math<headertest::Lane<T>> : ScalarLogic<headertest::Lane<T>> {
  using S = headertest::Lane<T>;
  using Batch = xsimd::batch<T>;

  static S sin(S x) noexcept { return S(Math<Batch>::sin(Batch(x.value)).get(0)); }
  static S cos(S x) noexcept { return S(Math<Batch>::cos(Batch(x.value)).get(0)); }
  static S tan(S x) noexcept { return S(Math<Batch>::tan(Batch(x.value)).get(0)); }
  static S asin(S x) noexcept { return S(Math<Batch>::asin(Batch(x.value)).get(0)); }
  static S acos(S x) noexcept { return S(Math<Batch>::acos(Batch(x.value)).get(0)); }
  static S atan(S x) noexcept { return S(Math<Batch>::atan(Batch(x.value)).get(0)); }
  static S atan2(S y, S x) noexcept { return S(Math<Batch>::atan2(Batch(y.value), Batch(x.value)).get(0)); }
  static S exp(S x) noexcept { return S(Math<Batch>::exp(Batch(x.value)).get(0)); }
  static S log(S x) noexcept { return S(Math<Batch>::log(Batch(x.value)).get(0)); }
  static S sinh(S x) noexcept { return S(Math<Batch>::sinh(Batch(x.value)).get(0)); }
  static S cosh(S x) noexcept { return S(Math<Batch>::cosh(Batch(x.value)).get(0)); }
  static S tanh(S x) noexcept { return S(Math<Batch>::tanh(Batch(x.value)).get(0)); }
  static S sqrt(S x) noexcept { return S(Math<Batch>::sqrt(Batch(x.value)).get(0)); }
  static S pow(S x, S y) noexcept { return S(Math<Batch>::pow(Batch(x.value), Batch(y.value)).get(0)); }
  static void sincos(S x, S& sine, S& cosine) noexcept {
    Batch sines, cosines;
    Math<Batch>::sincos(Batch(x.value), sines, cosines);
    sine = S(sines.get(0));
    cosine = S(cosines.get(0));
  }
  static S epsilon() noexcept { return S(Math<T>::epsilon()); }
  static S pi() noexcept { return S(Math<T>::pi()); }
  static S constant(double hi, double mid, double lo) noexcept { return S(Math<T>::constant(hi, mid, lo)); }
};

}  // namespace gauss
