#pragma once
// gauss::Vectorised<T>: float or double, with the sines and cosines of an evaluation computed several at a time by xsimd.
// SPDX-License-Identifier: MIT-0
//
// One state, as with T itself, where emitted code asks for the angles of a mechanism together; everything else is arithmetic of T.
// Sines and cosines are within some units of the last place of those of the C library, and not the same. It pays from some
// ten angles on; for many states, batches are better.
//
//     using S = gauss::Vectorised<double>;
//     chain::State<S> state;                     // of the layout of State<double>
//     chain::rhs<S>(0.0, state, inputs, prepared, derivative);

#include <cstddef>
#include <type_traits>
#include <utility>

#include "gauss/scalar/xsimd.hpp"

namespace gauss {

template <class T>
struct Vectorised {
  T value;

  Vectorised() = default;
  Vectorised(T number) noexcept : value(number) {}
  template <class Number>
  explicit Vectorised(const Number& number) noexcept : value(static_cast<T>(number)) {}
  explicit operator T() const noexcept { return value; }

  friend Vectorised operator+(Vectorised a, Vectorised b) noexcept { return a.value + b.value; }
  friend Vectorised operator-(Vectorised a, Vectorised b) noexcept { return a.value - b.value; }
  friend Vectorised operator*(Vectorised a, Vectorised b) noexcept { return a.value * b.value; }
  friend Vectorised operator/(Vectorised a, Vectorised b) noexcept { return a.value / b.value; }
  friend Vectorised operator-(Vectorised a) noexcept { return -a.value; }
  friend bool operator<(Vectorised a, Vectorised b) noexcept { return a.value < b.value; }
  friend bool operator==(Vectorised a, Vectorised b) noexcept { return a.value == b.value; }
};

/// One angle, and everything else, as T has it.
template <class T>
struct Math<Vectorised<T>> : ScalarLogic<Vectorised<T>> {
  using S = Vectorised<T>;

  static S sin(S x) noexcept { return Math<T>::sin(x.value); }
  static S cos(S x) noexcept { return Math<T>::cos(x.value); }
  static S tan(S x) noexcept { return Math<T>::tan(x.value); }
  static S asin(S x) noexcept { return Math<T>::asin(x.value); }
  static S acos(S x) noexcept { return Math<T>::acos(x.value); }
  static S atan(S x) noexcept { return Math<T>::atan(x.value); }
  static S atan2(S y, S x) noexcept { return Math<T>::atan2(y.value, x.value); }
  static S exp(S x) noexcept { return Math<T>::exp(x.value); }
  static S log(S x) noexcept { return Math<T>::log(x.value); }
  static S sinh(S x) noexcept { return Math<T>::sinh(x.value); }
  static S cosh(S x) noexcept { return Math<T>::cosh(x.value); }
  static S tanh(S x) noexcept { return Math<T>::tanh(x.value); }
  static S sqrt(S x) noexcept { return Math<T>::sqrt(x.value); }
  static S pow(S x, S y) noexcept { return Math<T>::pow(x.value, y.value); }
  static void sincos(S x, S& sine, S& cosine) noexcept { Math<T>::sincos(x.value, sine.value, cosine.value); }
  static S epsilon() noexcept { return Math<T>::epsilon(); }
  static S pi() noexcept { return Math<T>::pi(); }
  static S constant(double hi, double mid, double lo) noexcept { return Math<T>::constant(hi, mid, lo); }
};

template <class T>
struct Angles<Vectorised<T>> {
  using S = Vectorised<T>;
  /// Registers of 32 bytes: wider ones pay in code that stays in them, and cost more than they save beside scalar code.
  using Arch = std::conditional_t<(sizeof(xsimd::batch<T>) > 32), xsimd::avx2, xsimd::default_arch>;
  using Batch = xsimd::batch<T, Arch>;

  template <class... All>
  GAUSS_INLINED static void sincos(All&&... all) noexcept {
    constexpr std::size_t count = sizeof...(All) / 3;
    constexpr std::size_t padded = (count + Batch::size - 1) / Batch::size * Batch::size;
    T angles[padded] = {};
    alignas(Batch) T sines[padded], cosines[padded];
    read(angles, all...);
    for (std::size_t i = 0; i < padded; i += Batch::size) {
      Batch sine, cosine;
      Math<Batch>::sincos(gathered(angles + i, std::make_index_sequence<Batch::size>()), sine, cosine);
      sine.store_aligned(sines + i);
      cosine.store_aligned(cosines + i);
    }
    write(sines, cosines, all...);
  }

 private:
  /// From registers: to load what was just written number by number would wait for memory.
  template <std::size_t... I>
  GAUSS_INLINED static Batch gathered(const T* angles, std::index_sequence<I...>) noexcept {
#if defined(__GNUC__)
    const typename Batch::register_type together = {angles[I]...};
    return Batch(together);
#else
    return Batch({angles[I]...});
#endif
  }
  GAUSS_INLINED static void read(T*) noexcept {}
  template <class... Rest>
  GAUSS_INLINED static void read(T* angle, const S& x, const S&, const S&, const Rest&... rest) noexcept {
    *angle = x.value;
    read(angle + 1, rest...);
  }
  GAUSS_INLINED static void write(const T*, const T*) noexcept {}
  template <class... Rest>
  GAUSS_INLINED static void write(const T* sines, const T* cosines, const S&, S& sine, S& cosine,
                                  Rest&... rest) noexcept {
    sine = *sines;
    cosine = *cosines;
    write(sines + 1, cosines + 1, rest...);
  }
};

}  // namespace gauss
