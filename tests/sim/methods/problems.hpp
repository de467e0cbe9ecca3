#pragma once
// Models by hand, with closed forms: functions as an engine would offer them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "sim/methods/methods.hpp"

namespace problems {

using gausssim::Functions;
using gausssim::Numbers;

/// (t, state) -> result, of a function that an engine would hold.
using Call = int (*)(const void*, void* const*);
template <class S>
gausssim::Callable<S> bound(Call call) {
  using gausssim::ArgumentIs;
  gausssim::Callable<S> result({call, nullptr}, {ArgumentIs::time, ArgumentIs::state, ArgumentIs::first_result});
  result.bind(nullptr, nullptr);
  return result;
}

/// Time, state and result of a call.
template <class S>
struct Arguments {
  explicit Arguments(void* const* all)
      : t(*static_cast<const S*>(all[0])), y(static_cast<const S*>(all[1])), result(static_cast<S*>(all[2])) {}
  S t;
  const S* y;
  S* result;
};

/// All entries are kept.
inline gausssim::JacobianLayout full_layout(std::size_t n) {
  gausssim::JacobianLayout layout{n * n, 0, {0}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) layout.column.push_back(k);
    layout.row_begin.push_back((i + 1) * n);
  }
  return layout;
}

/// A planet around a sun, masses and units 1: accelerations depend on coordinates alone.
template <class S>
struct Kepler {
  static constexpr double eccentricity = 0.3;

  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S r2 = a.y[0] * a.y[0] + a.y[1] * a.y[1], r3 = r2 * std::sqrt(r2);
    const S result[] = {a.y[2], a.y[3], -a.y[0] / r3, -a.y[1] / r3};
    std::copy(result, result + 4, a.result);
    return 0;
  }
  static int jacobian(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S x = a.y[0], y = a.y[1], r2 = x * x + y * y, r5 = r2 * r2 * std::sqrt(r2);
    std::fill(a.result, a.result + 16, S(0));
    a.result[2] = a.result[7] = 1;
    a.result[8] = (3 * x * x - r2) / r5;
    a.result[9] = a.result[12] = 3 * x * y / r5;
    a.result[13] = (3 * y * y - r2) / r5;
    return 0;
  }
  static int energy(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S kinetic = (a.y[2] * a.y[2] + a.y[3] * a.y[3]) / 2;
    a.result[0] = kinetic;
    a.result[1] = kinetic - 1 / std::sqrt(a.y[0] * a.y[0] + a.y[1] * a.y[1]);
    return 0;
  }

  static std::shared_ptr<Functions<S>> functions() {
    auto result = std::make_shared<Functions<S>>();
    result->n_q = result->n_v = 2;
    result->units = {"m", "m", "m/s", "m/s"};
    result->rates = bound<S>(rates);
    result->jacobian = bound<S>(jacobian);
    result->jacobian_layout = full_layout(4);
    result->energy = bound<S>(energy);
    result->energy_layout = {2, 0, 1, true};
    return result;
  }
  /// Nearest to the sun at time 0; semi-major axis 1.
  static Numbers<S> at(S t) {
    const S e = S(eccentricity), b = std::sqrt(1 - e * e);
    S angle = t;  // Kepler's equation t = E - e sin E, by Newton's method
    for (int i = 0; i < 50; ++i) angle -= (angle - e * std::sin(angle) - t) / (1 - e * std::cos(angle));
    const S c = std::cos(angle), s = std::sin(angle), r = 1 - e * c;
    return {c - e, b * s, -s / r, b * c / r};
  }
};

/// q'' = (cos^2 t - sin t) q, which exp(sin t) satisfies: rates depend on time, as where a table of coefficients has wrong times.
template <class S>
struct Driven {
  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S q = a.y[0], c = std::cos(a.t);
    a.result[0] = a.y[1];
    a.result[1] = (c * c - std::sin(a.t)) * q;
    return 0;
  }
  static std::shared_ptr<Functions<S>> functions() {
    auto result = std::make_shared<Functions<S>>();
    result->n_q = result->n_v = 1;
    result->units = {"m", "m/s"};
    result->rates = bound<S>(rates);
    return result;
  }
  static Numbers<S> at(S t) { return {std::exp(std::sin(t)), std::cos(t) * std::exp(std::sin(t))}; }
};

/// q' = v, v' = -k (v - cos t) - sin t: v is cos t, however large k is, and q is sin t.
template <class S>
struct Relaxation {
  static constexpr double k = 1e6;

  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S v = a.y[1];
    a.result[0] = v;
    a.result[1] = -S(k) * (v - std::cos(a.t)) - std::sin(a.t);
    return 0;
  }
  static int jacobian(const void*, void* const* all) {
    const Arguments<S> a(all);
    a.result[0] = a.result[2] = 0;
    a.result[1] = 1;
    a.result[3] = -S(k);
    return 0;
  }
  static std::shared_ptr<Functions<S>> functions() {
    auto result = std::make_shared<Functions<S>>();
    result->n_q = result->n_v = 1;
    result->units = {"m", "m/s"};
    result->rates = bound<S>(rates);
    result->jacobian = bound<S>(jacobian);
    result->jacobian_layout = full_layout(2);
    return result;
  }
  static Numbers<S> at(S t) { return {std::sin(t), std::cos(t)}; }
};

/// A mass that a spring and a damper, both very stiff, pull along behind a place that moves as cos t: rates of 1e9/s and 1e3/s beside one of 1/s.
template <class S>
struct Pulled {
  static constexpr double m = 1e-3, c = 1e6, k = 1e9;

  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S s = a.y[0], v = a.y[1];
    a.result[0] = v;
    a.result[1] = (-S(k) * (s - std::cos(a.t)) - S(c) * v) / S(m);
    return 0;
  }
  static int jacobian(const void*, void* const* all) {
    const Arguments<S> a(all);
    a.result[0] = 0;
    a.result[1] = 1;
    a.result[2] = -S(k / m);
    a.result[3] = -S(c / m);
    return 0;
  }
  static std::shared_ptr<Functions<S>> functions() {
    auto result = std::make_shared<Functions<S>>();
    result->n_q = result->n_v = 1;
    result->units = {"m", "m/s"};
    result->rates = bound<S>(rates);
    result->jacobian = bound<S>(jacobian);
    result->jacobian_layout = full_layout(2);
    return result;
  }
  /// What is left when all else has decayed: A cos t + B sin t with m s'' + c s' + k s = k cos t.
  static Numbers<S> at(S t) {
    const S real = S(k - m), all = real * real + S(c) * S(c);
    const S a = S(k) * real / all, b = S(k) * S(c) / all;
    return {a * std::cos(t) + b * std::sin(t), b * std::cos(t) - a * std::sin(t)};
  }
};

/// A mass of 1 kg on a rod of 1 m in Cartesian coordinates, g = 9.81 m/s^2: a constraint of positions.
template <class S>
struct Bob {
  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S x = a.y[0], y = a.y[1], u = a.y[2], v = a.y[3], g = S(9.81L), r2 = x * x + y * y;
    const S tension = (u * u + v * v - g * y) / r2;
    const S result[] = {u, v, -x * tension, -y * tension - g};
    std::copy(result, result + 4, a.result);
    return 0;
  }
  static int positions(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S r = std::sqrt(a.y[0] * a.y[0] + a.y[1] * a.y[1]);
    const S result[] = {a.y[0] / r, a.y[1] / r, a.y[2], a.y[3]};
    std::copy(result, result + 4, a.result);
    return 0;
  }
  static int speeds(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S x = a.y[0], y = a.y[1], off = (x * a.y[2] + y * a.y[3]) / (x * x + y * y);
    const S result[] = {x, y, a.y[2] - off * x, a.y[3] - off * y};
    std::copy(result, result + 4, a.result);
    return 0;
  }
  static int project(const void*, void* const* all) {
    positions(nullptr, all);
    S* const state = static_cast<S*>(all[2]);
    void* again[] = {all[0], state, state};
    return speeds(nullptr, again);
  }
  static int energy(const void*, void* const* all) {
    const Arguments<S> a(all);
    a.result[0] = (a.y[2] * a.y[2] + a.y[3] * a.y[3]) / 2;
    a.result[1] = a.result[0] + S(9.81L) * a.y[1];
    return 0;
  }
  static std::shared_ptr<Functions<S>> functions() {
    auto result = std::make_shared<Functions<S>>();
    result->n_q = result->n_v = 2;
    result->units = {"m", "m", "m/s", "m/s"};
    result->rates = bound<S>(rates);
    result->projection = bound<S>(project);
    result->positions = bound<S>(positions);
    result->speeds = bound<S>(speeds);
    result->energy = bound<S>(energy);
    result->energy_layout = {2, 0, 1, true};
    return result;
  }
  static Numbers<S> start() { return {S(0.8L), S(-0.6L), S(0), S(0)}; }
};

template <class S>
S distance(const Numbers<S>& a, const Numbers<S>& b) {
  S largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const S miss = std::abs(a[i] - b[i]);
    if (!(miss <= largest)) largest = miss;
  }
  return largest;
}

}  // namespace problems
