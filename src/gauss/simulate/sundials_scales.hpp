// What the methods of SUNDIALS are to measure errors of a step by: sizes that the motion itself has, and rounding.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_SUNDIALS_SCALES_HPP
#define GAUSS_SIMULATE_SUNDIALS_SCALES_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/unit_groups.hpp"
#include "gauss/simulate/report.hpp"

namespace gauss::simulate {

/// As StepControl, but known before a step: SUNDIALS asks for weights at the state that a step begins from.
template <class Model>
class SundialsScales {
 public:
  using State = typename Model::State;
  using Array = integrate::StateArray<Model>;

  explicit SundialsScales(const Model& model)
      : groups_(model),
        n_q_(Arrays::n_q(model)),
        scales_(Arrays::zeros(model)),
        seen_(scales_),
        sizes_(scales_),
        first_(scales_) {}

  /// For a step from `state`, of a length that is not 0.
  void find(const Model& model, double t, double step, const State& state) {
    step_ = step;
    if (!has_begun_) find_first(model, t, state);
    has_begun_ = true;
    for (std::size_t i = 0; i < sizes_.size(); ++i) sizes_[i] = std::max(sizes_[i], std::abs(state.values[i]));
    // Before an edge, steps and with them the changes in sight become shorter without end: a part of earlier ones stays.
    const auto own = groups_.largest(sizes_);
    scales_ = groups_.scales(model, t, step_, state, sizes_);
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      seen_[i] = std::max(seen_[i], k_part_of_earlier * scales_[i]);
      if (own[i] == 0) scales_[i] = std::max(scales_[i], seen_[i]);
    }
  }

  /// What an error may be, by components: `tolerance` of the largest size so far, and rounding of the largest with the same unit. A speed is not told from places better than these are
  /// rounded, within a step. What rests at 0 has nothing but this. `places`: share of the tolerance that coordinates are allowed.
  Array allowed(const Settings<double>& settings, double tolerance, double places = 1) const {
    constexpr double k_of_places = 4 * std::numeric_limits<double>::epsilon();
    return bounds(settings, tolerance, places, k_of_places / std::abs(step_));
  }

  /// Where constraints lose their rank, projection may take any part of the motion away.
  bool is_near(const Settings<double>& settings, const State& before, const State& after, double places = 1) const {
    return is_within(settings.most_projected, allowed(settings, least(settings), places), before, after);
  }

  /// As is_near, of a state that keeps its energy: that moves speeds by less, and by no more in a shorter step. What places are rounded by, in the time of one, is far more than motions have near
  /// rest, and the history of a multistep method takes what is a thousand tolerances for a motion that no step is short enough for.
  bool is_energy_near(const Settings<double>& settings, const State& before, const State& after,
                      double places = 1) const {
    return is_within(k_of_energy * settings.most_projected, bounds(settings, least(settings), places, 0), before,
                     after);
  }

 private:
  static double least(const Settings<double>& settings) {
    return std::max(settings.tolerance, std::numeric_limits<double>::epsilon());
  }

  static bool is_within(double most, const Array& bounds, const State& before, const State& after) {
    for (std::size_t i = 0; i < bounds.size(); ++i)
      if (!(std::abs(after.values[i] - before.values[i]) <= most * bounds[i])) return false;
    return true;
  }

  /// `of_places`: what speeds are allowed of the largest place, per time.
  Array bounds(const Settings<double>& settings, double tolerance, double places, double of_places) const {
    constexpr double k_last_places = 64 * std::numeric_limits<double>::epsilon();
    constexpr double k_with_all_digits = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
    Array result = sizes_;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const bool is_speed = i >= n_q_;
      const double smallest = is_speed ? settings.least_speed() : settings.smallest_scale;
      const double size = std::max({sizes_[i] > 0 ? sizes_[i] : scales_[i], first_[i], smallest, k_with_all_digits});
      result[i] = tolerance * (is_speed ? 1 : places) * size + k_last_places * scales_[i];
      if (is_speed) result[i] += of_places * groups_.places_of(i, scales_);
      // What will not move, as far as can be seen, has no scale.
      if (!(result[i] > 0)) result[i] = tolerance;
    }
    return result;
  }

  static constexpr double k_part_of_earlier = 1e-3;
  static constexpr double k_of_energy = 0.1;

  /// A place that begins as t^2 is missed by all of itself in a first step of order 1, and by parts of it in others, however short they are: away from t = 0 they come down to rounding of the
  /// time. So what begins with 0 is allowed a part of the way that it is seen to go in the first step thought of: by its rate, and by the rate after that.
  void find_first(const Model& model, double t, const State& state) {
    typename Model::Derivative rates, after;
    State ahead = state;
    if (!integrate::is_motion_known(model.derivative(t, state, rates))) return;
    for (std::size_t i = 0; i < first_.size(); ++i) ahead.values[i] += step_ * rates.values[i];
    if (!integrate::is_motion_known(model.derivative(t + step_, ahead, after))) after = rates;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const double way = std::abs(step_) * std::max(std::abs(rates.values[i]), std::abs(after.values[i]));
      if (state.values[i] == 0) first_[i] = k_part_of_earlier * way;
    }
  }

  using Arrays = integrate::StateArrays<Model>;

  integrate::UnitGroups<Model> groups_;
  std::size_t n_q_;
  Array scales_;  ///< of groups, for a step of length step_
  Array seen_;    ///< part of the largest scale so far
  Array sizes_;   ///< largest so far
  Array first_;   ///< of what begins with 0
  bool has_begun_ = false;
  double step_ = 1;  ///< that scales are for
};

/// A spring and a damper make a speed follow a place, k/c times as large. What steps of backward differentiation may miss a place by is then a change of the speed, and where that is
/// beyond what the speed may be missed by, steps are refused again and again: neither their length nor their order grows. So where the order stays low from look to look
/// and refusals add up, coordinates are asked for a digit more, down to rounding. Tolerances become no looser by this. Where it does not help (rates that jump), it is taken back.
class DemandOnPlaces {
 public:
  /// `steps` and `inaccurate`: so far, taken and refused by the estimate of the error. `order`: of the last step.
  void look(long steps, long inaccurate, int order, double tolerance) {
    constexpr int k_steps_to_look = 50, k_looks = 2, k_refused = 15;
    if (steps < steps_ + k_steps_to_look) return;
    const bool is_low = order <= 2;
    looks_ = is_low ? looks_ + 1 : 0;
    refused_ = is_low ? refused_ + inaccurate - inaccurate_ : 0;
    steps_ = steps;
    inaccurate_ = inaccurate;
    if (is_given_up_ || looks_ < k_looks || refused_ < k_refused) return;
    forget();
    share_ /= 10;
    is_given_up_ = tolerance * share_ < 16 * std::numeric_limits<double>::epsilon();
    if (is_given_up_) share_ = 1;
  }
  /// What a method has refused that begins anew says nothing of the new one.
  void forget() { looks_ = refused_ = 0; }

  /// Of the tolerance that coordinates are allowed.
  double share() const { return share_; }

 private:
  long steps_ = 0, inaccurate_ = 0;  ///< at the last look
  long looks_ = 0, refused_ = 0;     ///< in a row with a low order
  bool is_given_up_ = false;
  double share_ = 1;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_SUNDIALS_SCALES_HPP
