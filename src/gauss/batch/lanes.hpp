#pragma once
// How many trajectories one evaluation takes: as many as a SIMD register has numbers, where xsimd is there; else one.
// SPDX-License-Identifier: MIT-0

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "gauss/math.hpp"

#if defined(__has_include) && !defined(GAUSS_WITHOUT_XSIMD)
#if __has_include(<xsimd/xsimd.hpp>)
#include "gauss/scalar/xsimd.hpp"
#define GAUSS_HAS_XSIMD
#endif
#endif

namespace gauss::batch {

/// Numbers of several trajectories in one scalar of emitted code. `count`: how many of them there are, where they may be fewer.
template <class S>
struct Lanes {
  using Number = S;
  static constexpr std::size_t size = 1;

  static S load(const S* from) { return *from; }
  static void store(const S& value, S* to) { *to = value; }
  static void store(const S& value, S* to, std::size_t /*count*/) { *to = value; }
  static S same(const S& value) { return value; }
  static bool all_ok(const StatusOf<S>& status) { return status == Status::ok; }
  static Status status_of(const StatusOf<S>& status, std::size_t /*lane*/) { return status; }
};

#ifdef GAUSS_HAS_XSIMD
template <class T, class Arch>
struct Lanes<xsimd::batch<T, Arch>> {
  using S = xsimd::batch<T, Arch>;
  using Number = T;
  static constexpr std::size_t size = S::size;

  static S load(const T* from) { return S::load_unaligned(from); }
  static void store(const S& value, T* to) { value.store_unaligned(to); }
  static void store(const S& value, T* to, std::size_t count) {
    T numbers[size];
    value.store_unaligned(numbers);
    std::copy_n(numbers, std::min(count, size), to);
  }
  static S same(T value) { return S(value); }
  static bool all_ok(const StatusOf<S>& status) { return !status.any(); }
  static Status status_of(const StatusOf<S>& status, std::size_t lane) { return status.lane(lane); }
};
#endif

namespace detail {

template <class T>
auto widest() {
#if defined(GAUSS_HAS_XSIMD) && !defined(XSIMD_NO_SUPPORTED_ARCHITECTURE)
  // Boost's numbers, long double and their like have no registers of several.
  if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) {
    return xsimd::batch<T>(T(0));
  } else {
    return T();
  }
#else
  return T();
#endif
}

}  // namespace detail

/// The widest scalar for numbers of type T that this machine computes with, as the compiler's flags (-march=native) say.
template <class T>
using Widest = decltype(detail::widest<T>());

}  // namespace gauss::batch
