// gauss::Math: the functions, selections and constants that emitted models need from their scalar type S.
// SPDX-License-Identifier: MIT-0
//
// Works as it is for float, double, long double and for any type with arithmetic, comparison and functions that are
// found by argument-dependent lookup (Boost.Multiprecision, dual numbers). Others specialise Math: gauss/scalar/ has
// __float128 and SIMD batches.
#ifndef GAUSS_MATH_HPP
#define GAUSS_MATH_HPP

#define GAUSS_MATH_VERSION 5

// Conditions on values that are not finite, the order of sums and signs of zeros are part of the results. Single options of -ffast-math
// have macros of their own, but clang++ has none for a new order of sums: see GAUSS_IN_ORDER.
#if !defined(GAUSS_ALLOW_FAST_MATH) &&                                                                \
    (defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) ||         \
     defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) || \
     defined(_M_FP_FAST))
#error \
    "Emitted models need exact floating-point semantics: compile without -ffast-math and its parts, or define GAUSS_ALLOW_FAST_MATH."
#endif

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(__CUDACC__)
#define GAUSS_FUNCTION inline __host__ __device__
#else
#define GAUSS_FUNCTION inline
#endif

// Functions that one file of a program compiles for all others (gauss-gen --split).
#if defined(__CUDACC__)
#define GAUSS_SEPARATE __host__ __device__
#else
#define GAUSS_SEPARATE
#endif

// What only passes arguments on, and would be in the way of optimisation as a call.
#if defined(__GNUC__)
#define GAUSS_INLINED GAUSS_FUNCTION __attribute__((always_inline))
#else
#define GAUSS_INLINED GAUSS_FUNCTION
#endif

// A part of a function that is too large for compilers in one piece; inlined, it would be one again.
#if defined(__GNUC__)
#define GAUSS_PART GAUSS_FUNCTION __attribute__((noinline))
#else
#define GAUSS_PART GAUSS_FUNCTION
#endif

// At the beginning of a block: its sums are taken as they are written, whatever options allow. clang++ 14 forgets it in a fold over a +.
#if defined(__clang__)
#define GAUSS_IN_ORDER _Pragma("clang fp reassociate(off)")
#else
#define GAUSS_IN_ORDER
#endif

namespace gauss {

/// How a computation went. Results are to be trusted with `ok` only.
enum class Status { ok, singular_mass_matrix, dependent_constraints, not_finite, violated_constraints };

constexpr const char* name(Status status) noexcept {
  return status == Status::ok                      ? "ok"
         : status == Status::singular_mass_matrix  ? "singular mass matrix"
         : status == Status::dependent_constraints ? "dependent constraints"
         : status == Status::not_finite            ? "not finite"
                                                   : "violated constraints";
}

/// An entry of the tables that describe a model.
struct Quantity {
  const char* name;
  const char* unit;
  const char* about;
};

// Functions by argument-dependent lookup, outside of Math, whose members would hide them.
namespace adl {
#define GAUSS_BY_LOOKUP(f)                \
  template <class S>                      \
  GAUSS_FUNCTION S call_##f(const S& x) { \
    return f(x);                          \
  }
GAUSS_BY_LOOKUP(sin)
GAUSS_BY_LOOKUP(cos)
GAUSS_BY_LOOKUP(tan)
GAUSS_BY_LOOKUP(asin)
GAUSS_BY_LOOKUP(acos)
GAUSS_BY_LOOKUP(atan)
GAUSS_BY_LOOKUP(exp)
GAUSS_BY_LOOKUP(log)
GAUSS_BY_LOOKUP(sinh)
GAUSS_BY_LOOKUP(cosh)
GAUSS_BY_LOOKUP(tanh)
GAUSS_BY_LOOKUP(sqrt)
#undef GAUSS_BY_LOOKUP
template <class S>
GAUSS_FUNCTION S call_atan2(const S& y, const S& x) {
  return atan2(y, x);
}
template <class S>
GAUSS_FUNCTION S call_pow(const S& x, const S& y) {
  return pow(x, y);
}
}  // namespace adl

namespace detail {

/// A compiler that knows the argument of a function computes the function itself, with a last digit that may be another than that of the library
/// at run time: the same program would have other results with other options. So arguments that it knows are hidden from it.
template <class S>
GAUSS_INLINED S at_run_time(S x) noexcept {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
  if (__builtin_constant_p(x)) __asm__("" : "+m"(x));
#endif
  return x;
}

/// Infinite or not a number, by the bits of the exponent: for compilers that take all numbers for finite.
template <class S>
GAUSS_FUNCTION bool has_largest_exponent(const S& x) noexcept {
  constexpr int digits = std::numeric_limits<S>::digits;
  static_assert(digits == 24 || digits == 53 || digits == 64 || digits == 113, "a format of IEEE 754, or that of x87");
  using Word =
      std::conditional_t<digits == 24, std::uint32_t, std::conditional_t<digits == 53, std::uint64_t, std::uint16_t>>;
  constexpr Word exponent = static_cast<Word>(digits == 24   ? 0x7F800000U
                                              : digits == 53 ? 0x7FF0000000000000U
                                                             : 0x7FFFU);
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  constexpr std::size_t place = 0;
#else
  constexpr std::size_t place = digits == 64 ? 8 : digits == 113 ? 14 : 0;
#endif
  Word bits = 0;
  std::memcpy(&bits, reinterpret_cast<const unsigned char*>(&x) + place, sizeof bits);
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
  // What it takes for finite has no such bits, and some compilers know.
  __asm__("" : "+m"(bits));
#endif
  return (bits & exponent) == exponent;
}

}  // namespace detail

/// Comparison and selection for types whose conditions are bool.
template <class S>
struct ScalarLogic {
  using Bool = bool;
  using Status = gauss::Status;

  GAUSS_FUNCTION static Bool less(const S& a, const S& b) { return a < b; }
  GAUSS_FUNCTION static Bool at_most(const S& a, const S& b) { return a < b || a == b; }
  GAUSS_FUNCTION static S select(Bool condition, const S& a, const S& b) { return condition ? a : b; }

  template <class... Rest>
  GAUSS_FUNCTION static Bool any(Bool first, Rest... rest) {
    return (first || ... || rest);
  }

  /// x - x is 0 for finite x, else a NaN, which equals nothing.
  template <class... Rest>
  GAUSS_FUNCTION static Bool not_finite(const S& first, const Rest&... rest) {
    GAUSS_IN_ORDER
    S sum = first - first;
    ((sum = sum + (rest - rest)), ...);
    return !(sum == sum);
  }

  /// Of the conditions that hold, the one that leaves least: with dependent constraints alone the motion is known. What is divided by where inertia is
  /// missing is not finite, and its cause is told.
  GAUSS_FUNCTION static Status status(Bool singular_mass_matrix, Bool dependent_constraints, Bool not_finite,
                                      Bool violated_constraints = false) {
    return singular_mass_matrix    ? Status::singular_mass_matrix
           : not_finite            ? Status::not_finite
           : violated_constraints  ? Status::violated_constraints
           : dependent_constraints ? Status::dependent_constraints
                                   : Status::ok;
  }

  /// What one computation has to say of both.
  GAUSS_FUNCTION static Status worse(Status a, Status b) {
    return status(a == Status::singular_mass_matrix || b == Status::singular_mass_matrix,
                  a == Status::dependent_constraints || b == Status::dependent_constraints,
                  a == Status::not_finite || b == Status::not_finite,
                  a == Status::violated_constraints || b == Status::violated_constraints);
  }

  GAUSS_FUNCTION static S epsilon() { return std::numeric_limits<S>::epsilon(); }
  /// A number that needs more digits than double has, as hi + mid + lo.
  GAUSS_FUNCTION static S constant(double hi, double mid, double lo) {
    return (static_cast<S>(lo) + static_cast<S>(mid)) + static_cast<S>(hi);
  }
};

/// To be specialised for types that need it.
template <class S>
struct Math : ScalarLogic<S> {
  GAUSS_FUNCTION static S sin(const S& x) { return adl::call_sin(x); }
  GAUSS_FUNCTION static S cos(const S& x) { return adl::call_cos(x); }
  GAUSS_FUNCTION static S tan(const S& x) { return adl::call_tan(x); }
  GAUSS_FUNCTION static S asin(const S& x) { return adl::call_asin(x); }
  GAUSS_FUNCTION static S acos(const S& x) { return adl::call_acos(x); }
  GAUSS_FUNCTION static S atan(const S& x) { return adl::call_atan(x); }
  GAUSS_FUNCTION static S atan2(const S& y, const S& x) { return adl::call_atan2(y, x); }
  GAUSS_FUNCTION static S exp(const S& x) { return adl::call_exp(x); }
  GAUSS_FUNCTION static S log(const S& x) { return adl::call_log(x); }
  GAUSS_FUNCTION static S sinh(const S& x) { return adl::call_sinh(x); }
  GAUSS_FUNCTION static S cosh(const S& x) { return adl::call_cosh(x); }
  GAUSS_FUNCTION static S tanh(const S& x) { return adl::call_tanh(x); }
  GAUSS_FUNCTION static S sqrt(const S& x) { return adl::call_sqrt(x); }
  GAUSS_FUNCTION static S pow(const S& x, const S& y) { return adl::call_pow(x, y); }
  GAUSS_FUNCTION static void sincos(const S& x, S& sine, S& cosine) {
    sine = sin(x);
    cosine = cos(x);
  }
  GAUSS_FUNCTION static S pi() { return acos(S(-1)); }
};

/// float, double and long double.
template <class S>
struct StandardMath : ScalarLogic<S> {
  /// One comparison, where any type with < and == may need two.
  GAUSS_FUNCTION static bool at_most(S a, S b) noexcept { return a <= b; }
#if defined(GAUSS_ALLOW_FAST_MATH)
  template <class... Rest>
  GAUSS_FUNCTION static bool not_finite(const S& first, const Rest&... rest) noexcept {
    return (detail::has_largest_exponent(first) || ... || detail::has_largest_exponent(rest));
  }
#endif
  GAUSS_FUNCTION static S sin(S x) noexcept { return std::sin(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S cos(S x) noexcept { return std::cos(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S tan(S x) noexcept { return std::tan(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S asin(S x) noexcept { return std::asin(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S acos(S x) noexcept { return std::acos(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S atan(S x) noexcept { return std::atan(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S atan2(S y, S x) noexcept {
    return std::atan2(detail::at_run_time(y), detail::at_run_time(x));
  }
  GAUSS_FUNCTION static S exp(S x) noexcept { return std::exp(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S log(S x) noexcept { return std::log(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S sinh(S x) noexcept { return std::sinh(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S cosh(S x) noexcept { return std::cosh(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S tanh(S x) noexcept { return std::tanh(detail::at_run_time(x)); }
  GAUSS_FUNCTION static S sqrt(S x) noexcept { return std::sqrt(x); }
  GAUSS_FUNCTION static S pow(S x, S y) noexcept { return std::pow(detail::at_run_time(x), detail::at_run_time(y)); }
  GAUSS_FUNCTION static void sincos(S x, S& sine, S& cosine) noexcept {
    sine = sin(x);
    cosine = cos(x);
  }
  GAUSS_FUNCTION static S pi() noexcept { return static_cast<S>(3.14159265358979323846264338327950288L); }
  /// A constant: device code calls no function of the host, not a constexpr one either.
  static constexpr S rounding_unit = std::numeric_limits<S>::epsilon();
  GAUSS_FUNCTION static S epsilon() noexcept { return rounding_unit; }
};

// One call for both where the C library offers it; compilers do not always find the pair by themselves.
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
#define GAUSS_SINCOS(S, function)                                       \
  GAUSS_FUNCTION static void sincos(S x, S& sine, S& cosine) noexcept { \
    function(detail::at_run_time(x), &sine, &cosine);                   \
  }
#else
#define GAUSS_SINCOS(S, function)
#endif

template <>
struct Math<float> : StandardMath<float> {
  GAUSS_SINCOS(float, ::sincosf)
};

template <>
struct Math<double> : StandardMath<double> {
  GAUSS_SINCOS(double, ::sincos)
};

template <>
struct Math<long double> : StandardMath<long double> {
  GAUSS_SINCOS(long double, ::sincosl)
};

#undef GAUSS_SINCOS

namespace detail {

/// Whether it holds in some lane.
template <class S>
GAUSS_FUNCTION bool holds_in_any(const typename Math<S>::Bool& condition) {
  if constexpr (std::is_enum_v<typename Math<S>::Status>) {
    return condition;
  } else {
    return Math<S>::status(condition, condition, condition).any();
  }
}

/// Steps of Newton's method, in each lane until one has moved nothing. Errors are squared: where a step was less than this part, only rounding is left after it.
template <class S>
class Newton {
  using Bool = typename Math<S>::Bool;

 public:
  GAUSS_FUNCTION bool goes_on() const { return holds_in_any<S>(Math<S>::less(S(0), moving_)); }

  /// What a step from `before` to `after` has to say. Lanes that had arrived stay where they were. A component is measured by its size, and by 1 besides
  /// where `by_one` is 1.
  template <int n>
  GAUSS_FUNCTION typename Math<S>::Status take(const typename Math<S>::Status& status, const S (&before)[n],
                                               S (&after)[n], const int (&by_one)[n]) {
    const S root = Math<S>::sqrt(Math<S>::epsilon());
    const S part = root * Math<S>::sqrt(root);
    const Bool moves = Math<S>::less(S(0), moving_);
    S next = S(0);
    for (int i = 0; i < n; ++i) {
      after[i] = Math<S>::select(moves, after[i], before[i]);
      const S change = after[i] - before[i];
      const S own = by_one[i] == 1 ? S(1) : S(0);
      const S size = own + Math<S>::select(Math<S>::less(before[i], S(0)), -before[i], before[i]);
      const Bool has_moved = Math<S>::any(Math<S>::less(part * size, change), Math<S>::less(change, -part * size));
      next = Math<S>::select(has_moved, S(1), next);
    }
    moving_ = next;
    if constexpr (std::is_enum_v<typename Math<S>::Status>) {
      return status;
    } else {
      return status.within(moves);
    }
  }

 private:
  S moving_ = S(1);  ///< 1: on its way; 0
};

}  // namespace detail

/// Sines and cosines of angles that are known at the same time, three arguments for each: the angle, its sine, its cosine.
/// One after the other; to be specialised for types that compute several at once, as gauss/scalar/vectorised.hpp does.
template <class S>
struct Angles {
  GAUSS_INLINED static void sincos() {}
  template <class... Rest>
  GAUSS_INLINED static void sincos(const S& x, S& sine, S& cosine, Rest&&... rest) {
    Math<S>::sincos(x, sine, cosine);
    sincos(rest...);
  }
};

/// An enumeration for scalars, a mask per condition for batches.
template <class S>
using StatusOf = typename Math<S>::Status;

}  // namespace gauss

#elif GAUSS_MATH_VERSION != 5
#error "Two versions of the gauss prelude meet in one file: generate all models with the same gauss-gen."
#endif  // GAUSS_MATH_HPP
