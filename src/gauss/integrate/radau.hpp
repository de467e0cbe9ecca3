// Collocation at Radau's points: implicit, order 9, L-stable, for stiff models of which many digits are wanted.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_RADAU_HPP
#define GAUSS_INTEGRATE_RADAU_HPP

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/algebra/algebra_dispatcher.hpp>
#include <boost/numeric/odeint/algebra/operations_dispatcher.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <boost/numeric/odeint/util/resizer.hpp>
#include <boost/numeric/odeint/util/state_wrapper.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "gauss/integrate/dense_lu.hpp"
#include "gauss/integrate/state_arrays.hpp"

namespace gauss::integrate {

/// Radau IIA with five stages (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5): points and the inverse of A.
template <class S>
struct RadauTableau {
  static constexpr std::size_t stages = 5;
  std::array<S, stages> c;                            ///< the last one is 1
  std::array<std::array<S, stages>, stages> inverse;  ///< of A
  std::array<S, stages> at_start;  ///< weights of values at the points, for that of their polynomial at 0

  RadauTableau() {
    // Zeros of P5 - P4 on [0, 1], of Legendre's polynomials.
    const double guesses[] = {0.0571041961, 0.2768430136, 0.5835904324, 0.8602401357};
    for (std::size_t i = 0; i + 1 < stages; ++i) c[i] = zero_near(S(guesses[i]));
    c[stages - 1] = S(1);
    find_inverse();
    for (std::size_t i = 0; i < stages; ++i) at_start[i] = lagrange(i, S(0));
  }

  /// That is 1 at point i, and 0 at the others.
  S lagrange(std::size_t i, const S& at) const {
    S product = 1;
    for (std::size_t j = 0; j < stages; ++j)
      if (j != i) product *= (at - c[j]) / (c[i] - c[j]);
    return product;
  }

 private:
  static S zero_near(S x) {
    for (int k = 0; k < 6; ++k) {
      // P_n and its derivative by the recursion of Bonnet, at 2 x - 1.
      const S z = 2 * x - 1;
      S p[6] = {1, z}, d[6] = {0, 1};
      for (int n = 1; n < 5; ++n) {
        p[n + 1] = (S(2 * n + 1) * z * p[n] - S(n) * p[n - 1]) / S(n + 1);
        d[n + 1] = d[n - 1] + S(2 * n + 1) * p[n];
      }
      x -= (p[5] - p[4]) / (2 * (d[5] - d[4]));
    }
    return x;
  }

  /// Derivatives, at the points, of polynomials that are 0 at 0: A maps these to their values.
  void find_inverse() {
    DenseLu<S> powers;
    powers.begin(stages);
    for (std::size_t j = 0; j < stages; ++j) {
      S power = c[j];
      for (std::size_t k = 0; k < stages; ++k, power *= c[j]) powers.at(k, j) = power;
    }
    powers.factorise();
    std::vector<S> derivatives(stages), weights;
    for (std::size_t i = 0; i < stages; ++i) {
      S power = 1;
      for (std::size_t k = 0; k < stages; ++k, power *= c[i]) derivatives[k] = S(k + 1) * power;
      powers.solve(derivatives, weights);
      std::copy(weights.begin(), weights.end(), inverse[i].begin());
    }
  }
};

/// A stepper of Odeint with an estimate of its error. The system has, besides rates,
///
///     bool jacobian(t, x, fill)     // calls fill(row, column, value) for what may not be 0; false: it has none, and differences are taken
///     const Array& allowed(h)       // what the error of a step of length h may be, by components: iterations go on until they are far below it
///
/// Stages are solved by Newton's method with the Jacobian at each of them, so it converges where the model changes much within a step. The estimate is of order 5, as the
/// collocation itself: what the polynomial of the rates has at the start beside the rates there, times (1 - h g J)^-1 (IV.8.19 and IV.8.20): what decays within the step is no error.
template <class Array, class S>
class RadauIIA {
 public:
  using state_type = Array;
  using deriv_type = Array;
  using value_type = S;
  using time_type = S;
  using algebra_type = typename boost::numeric::odeint::algebra_dispatcher<Array>::algebra_type;
  using operations_type = typename boost::numeric::odeint::operations_dispatcher<Array>::operations_type;
  using resizer_type = boost::numeric::odeint::initially_resizer;
  using wrapped_state_type = boost::numeric::odeint::state_wrapper<Array>;
  using wrapped_deriv_type = wrapped_state_type;
  using stepper_category = boost::numeric::odeint::explicit_error_stepper_tag;
  using order_type = unsigned short;
  static constexpr order_type order_value = 9, stepper_order_value = 6, error_order_value = 7;

  order_type order() const { return order_value; }
  /// Steps follow the estimate, which goes with the sixth power of the step.
  order_type stepper_order() const { return stepper_order_value; }
  order_type error_order() const { return error_order_value; }
  algebra_type& algebra() { return algebra_; }
  template <class Any>
  void adjust_size(const Any&) {}

  /// Where no stages are found, the error is infinite: a shorter step has better guesses.
  template <class System, class In, class Rates, class Out, class Error>
  void do_step(System system, const In& x, const Rates& rates, const S& t, Out& out, const S& h, Error& error) {
    typename boost::numeric::odeint::unwrap_reference<System>::type& sys = system;
    n_ = x.size();
    out = x;
    error = x;
    if (!find_stages_from_guesses(sys, x, rates, t, h))
      return std::fill(error.begin(), error.end(), std::numeric_limits<S>::infinity());
    const S* const last = shifts_.data() + (k_stages - 1) * n_;
    for (std::size_t i = 0; i < n_; ++i) out[i] += last[i];
    estimate(sys, x, rates, t, h, error);
    known_from_ = t;
    known_h_ = h;
    known_shifts_ = shifts_;
    is_known_ = true;
  }

 private:
  static constexpr std::size_t k_stages = RadauTableau<S>::stages;
  static constexpr int k_most_iterations = 15;
  static constexpr double k_arrived = 1e-3;  ///< of what is allowed
  static constexpr double k_rounding = 0.1;  ///< the same, where changes become no smaller
  static constexpr double k_slow = 0.1;      ///< what is left by an iteration, from which on Jacobians are formed again
  static constexpr double k_longest_guess = 1.5;
  static constexpr double k_filter = 0.16;    ///< near the real eigenvalue of A
  static constexpr double k_no_longer = 0.5;  ///< of what is allowed

  /// The polynomial of the step before; the tangent, along which a slip stays as small as it is; then the start, to which what decays at once has gone.
  template <class System, class Rates>
  bool find_stages_from_guesses(System& system, const Array& x, const Rates& rates, const S& t, const S& h) {
    if (guess(t, h) && find_stages(system, x, t, h)) return true;
    guess_on_tangent(rates, h);
    if (find_stages(system, x, t, h)) return true;
    shifts_.assign(k_stages * n_, S(0));
    return find_stages(system, x, t, h);
  }

  /// The polynomial of the step before, or of the one that was refused here, as far as it reaches.
  bool guess(const S& t, const S& h) {
    shifts_.assign(k_stages * n_, S(0));
    if (!is_known_ || known_shifts_.size() != shifts_.size() || !(h <= S(k_longest_guess) * known_h_)) return false;
    const bool is_again = known_from_ == t, follows = magnitude(S(known_from_ + known_h_ - t)) <= S(1e-6) * known_h_;
    if (!is_again && !follows) return false;
    for (std::size_t s = 0; s < k_stages; ++s) {
      const S at = (is_again ? S(0) : S(1)) + tableau_.c[s] * h / known_h_;
      for (std::size_t j = 0; j < k_stages; ++j) {
        const bool is_start = !is_again && j + 1 == k_stages;
        const S weight = tableau_.lagrange(j, at) * at / tableau_.c[j] - (is_start ? S(1) : S(0));
        for (std::size_t i = 0; i < n_; ++i) shifts_[s * n_ + i] += weight * known_shifts_[j * n_ + i];
      }
    }
    return true;
  }

  template <class Rates>
  void guess_on_tangent(const Rates& rates, const S& h) {
    for (std::size_t s = 0; s < k_stages; ++s)
      for (std::size_t i = 0; i < n_; ++i) shifts_[s * n_ + i] = tableau_.c[s] * h * rates[i];
  }

  /// Newton's method for sum_j (A^-1)_ij Z_j = h f(t + c_i h, x + Z_i).
  template <class System>
  bool find_stages(System& system, const Array& x, const S& t, const S& h) {
    S last = std::numeric_limits<S>::infinity();
    bool is_formed = false;
    for (int iteration = 0; iteration < k_most_iterations; ++iteration) {
      if (!find_residuals(system, x, t, h)) return false;
      if (!is_formed && !form(system, x, t, h)) return false;
      is_formed = true;
      lu_.solve(residuals_, changes_);
      const Array& allowed = system.allowed(h);
      S change = 0;
      for (std::size_t k = 0; k < changes_.size(); ++k) {
        shifts_[k] += changes_[k];
        change = std::max(change, S(magnitude(changes_[k]) / allowed[k % n_]));
        if (!(changes_[k] == changes_[k])) return false;
      }
      const S part = change / last;
      if (change <= S(k_arrived) || (iteration > 0 && part < S(1) && change * part <= S(k_arrived) * (1 - part)))
        return true;
      if (!(part < S(0.9)) && change <= S(k_rounding)) return true;
      if (iteration > 3 && !(part < S(2))) return false;
      is_formed = part < S(k_slow);
      last = change;
    }
    return false;
  }

  template <class System>
  bool find_residuals(System& system, const Array& x, const S& t, const S& h) {
    residuals_.assign(k_stages * n_, S(0));
    Array rates = x;
    for (std::size_t s = 0; s < k_stages; ++s) {
      system(at_stage(x, s), rates, S(t + tableau_.c[s] * h));
      for (std::size_t i = 0; i < n_; ++i) {
        S sum = h * rates[i];
        for (std::size_t j = 0; j < k_stages; ++j) sum -= tableau_.inverse[s][j] * shifts_[j * n_ + i];
        if (!(sum - sum == S(0))) return false;
        residuals_[s * n_ + i] = sum;
      }
    }
    return true;
  }

  Array at_stage(const Array& x, std::size_t s) const {
    Array result = x;
    for (std::size_t i = 0; i < n_; ++i) result[i] += shifts_[s * n_ + i];
    return result;
  }

  template <class System>
  bool form(System& system, const Array& x, const S& t, const S& h) {
    lu_.begin(k_stages * n_);
    for (std::size_t s = 0; s < k_stages; ++s) {
      for (std::size_t j = 0; j < k_stages; ++j)
        for (std::size_t i = 0; i < n_; ++i) lu_.at(s * n_ + i, j * n_ + i) = tableau_.inverse[s][j];
      each_derivative(
          system, at_stage(x, s), S(t + tableau_.c[s] * h),
          [&](std::size_t i, std::size_t j, const S& value) { lu_.at(s * n_ + i, s * n_ + j) -= h * value; });
    }
    return lu_.factorise();
  }

  template <class System, class Fill>
  void each_derivative(System& system, const Array& x, const S& t, const Fill& fill) {
    if (system.jacobian(t, x, fill)) return;
    using std::sqrt;
    Array here = x, there = x, moved = x;
    system(x, here, t);
    for (std::size_t j = 0; j < n_; ++j) {
      const S wanted =
          sqrt(std::numeric_limits<S>::epsilon()) * std::max(magnitude(x[j]), magnitude(S(1e-5) * here[j]));
      moved[j] = x[j] + (wanted > S(0) ? wanted : sqrt(std::numeric_limits<S>::epsilon()));
      const S dx = moved[j] - x[j];
      system(moved, there, t);
      for (std::size_t i = 0; i < n_; ++i)
        if (there[i] != here[i]) fill(i, j, S((there[i] - here[i]) / dx));
      moved[j] = x[j];
    }
  }

  template <class System>
  void estimate(System& system, const Array& x, const Array& rates, const S& t, const S& h, Array& error) {
    Array at_start = x;  // h times what the polynomial of the rates has there
    for (std::size_t i = 0; i < n_; ++i) {
      at_start[i] = 0;
      for (std::size_t s = 0; s < k_stages; ++s)
        for (std::size_t j = 0; j < k_stages; ++j)
          at_start[i] += tableau_.at_start[s] * tableau_.inverse[s][j] * shifts_[j * n_ + i];
    }
    lu_.begin(n_);
    for (std::size_t i = 0; i < n_; ++i) lu_.at(i, i) = S(1);
    each_derivative(system, x, t,
                    [&](std::size_t i, std::size_t j, const S& value) { lu_.at(i, j) -= S(k_filter) * h * value; });
    if (!lu_.factorise()) return std::fill(error.begin(), error.end(), std::numeric_limits<S>::infinity());
    filter(rates, at_start, h, error);
    const S found = part_of(system.allowed(h), error), before = last_error_;
    last_error_ = found;
    // What the start itself is off by decays within the step, and seems to be an error of it, however short it is made: all but that, then.
    const bool is_of_start = known_from_ == t && h < known_h_ && found > before * h / known_h_;
    if (!(found > S(1)) || !is_of_start) return;
    Array near = x, rates_near = x;
    for (std::size_t i = 0; i < n_; ++i) near[i] += error[i];
    system(near, rates_near, t);
    filter(rates_near, at_start, h, error);
    // No reason for a longer step.
    const S rest = part_of(system.allowed(h), error);
    if (rest < S(k_no_longer)) error[0] = S(k_no_longer) * system.allowed(h)[0];
  }

  void filter(const Array& rates, const Array& at_start, const S& h, Array& error) {
    residuals_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) residuals_[i] = S(k_filter) * (h * rates[i] - at_start[i]);
    lu_.solve(residuals_, changes_);
    std::copy(changes_.begin(), changes_.end(), error.begin());
  }

  static S part_of(const Array& allowed, const Array& error) {
    S largest = 0;
    for (std::size_t i = 0; i < error.size(); ++i) largest = std::max(largest, S(magnitude(error[i]) / allowed[i]));
    return largest;
  }

  RadauTableau<S> tableau_;
  algebra_type algebra_;
  std::size_t n_ = 0;
  DenseLu<S> lu_;
  std::vector<S> shifts_, residuals_, changes_;      ///< stage by stage
  std::vector<S> known_shifts_;                      ///< of the step that was found last
  S known_from_ = 0, known_h_ = 0, last_error_ = 0;  ///< the error as a part of what was allowed
  bool is_known_ = false;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_RADAU_HPP
