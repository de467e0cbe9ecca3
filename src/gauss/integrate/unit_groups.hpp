// Which components of a state have the same unit, and what sizes are to be compared with.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_UNIT_GROUPS_HPP
#define GAUSS_INTEGRATE_UNIT_GROUPS_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"
#include "gauss/math.hpp"

namespace gauss::integrate {

/// Components of a model's state in groups of the same unit, coordinates apart from speeds. Those without a unit are one group.
template <class Model>
class UnitGroups {
 public:
  using Scalar = typename Model::Scalar;
  using Array = StateArray<Model>;

  explicit UnitGroups(const Model& model)
      : n_q_(Arrays::n_q(model)),
        first_(Arrays::template filled<std::size_t>(model, 0)),
        place_(first_),
        is_angle_(Arrays::template filled<bool>(model, false)),
        is_number_(is_angle_) {
    for (std::size_t i = 0; i < first_.size(); ++i) {
      is_angle_[i] = unit(model, i) == "rad";
      is_number_[i] = is_angle_[i] || unit(model, i) == "1";
      first_[i] = i;
      for (std::size_t k = i < n_q_ ? 0 : n_q_; k < i && first_[i] == i; ++k)
        if (unit(model, k) == unit(model, i)) first_[i] = k;
    }
    for (std::size_t i = n_q_; i < first_.size(); ++i) {
      place_[i] = k_none;
      for (std::size_t k = 0; k < n_q_ && place_[i] == k_none; ++k)
        if (is_rate_of(unit(model, i), unit(model, k))) place_[i] = k;
    }
  }

  /// For each component the largest of its group, of `sizes` that are not negative; for angles it is 1 at least, since they have a scale of their own.
  Array largest(const Array& sizes) const {
    Array result = sizes;
    find_largest(sizes.data(), result.data());
    return result;
  }

  /// The same, into `result`. Scalars may be lanes.
  void find_largest(const Scalar* sizes, Scalar* result) const {
    const std::size_t n = first_.size();
    const std::size_t* const first = first_.data();
    const bool* const is_angle = is_angle_.data();
    // The first of a group comes before all others.
    for (std::size_t i = 0; i < n; ++i) {
      const Scalar size = is_angle[i] ? larger(sizes[i], Scalar(1)) : sizes[i];
      result[first[i]] = first[i] == i ? size : larger(result[first[i]], size);
    }
    for (std::size_t i = 0; i < n; ++i) result[i] = result[first[i]];
  }

  /// How far components go in a time, as `sizes` are: angles and numbers by 1; others by their rates, since places may be counted from far away. Speeds of angles so far that these go so far, others
  /// by the largest of their unit.
  Array moves(const Array& sizes, const Scalar& time) const {
    const Array all = largest(sizes);
    Array result = zeros_like(sizes);
    for (std::size_t i = 0; i < n_q_; ++i) result[i] = is_number_[i] ? Scalar(1) : Scalar(0);
    for (std::size_t k = n_q_; k < first_.size(); ++k) {
      const std::size_t place = place_[k];
      if (place != k_none && is_number_[place] && time > Scalar(0)) {
        result[k] = 1 / time;
        continue;
      }
      result[k] = all[k];
      for (std::size_t i = 0; place != k_none && i < n_q_; ++i)
        if (first_[i] == first_[place] && !is_number_[i]) result[i] = std::max(result[i], time * all[k]);
    }
    return result;
  }

  Array largest(const typename Model::State& state) const {
    Array sizes = Arrays::array_of(state);
    for (Scalar& size : sizes) size = magnitude(size);
    return largest(sizes);
  }

  /// The same of `sizes`, those of `state` at least. What has no size, as all speeds at rest, has that of its change in a step from `t` to `t + h`: by its rate, and where that is 0,
  /// too, by its rate after it, and after another one (a force, a speed, a place); 0 where none is in sight.
  Array scales(const Model& model, const Scalar& t, const Scalar& h, const typename Model::State& state,
               const Array& sizes) const {
    Array result = largest(sizes);
    typename Model::State ahead = state;
    for (int look = 0; look < 3 && *std::min_element(result.begin(), result.end()) == Scalar(0); ++look) {
      typename Model::Derivative rates;
      if (!is_motion_known(model.derivative(look == 0 ? t : t + h, ahead, rates))) break;
      Array changes = zeros_like(result);
      for (std::size_t i = 0; i < first_.size(); ++i) {
        changes[i] = magnitude(h * rates.values[i]);
        ahead.values[i] = state.values[i] + h * rates.values[i];
      }
      changes = largest(changes);
      for (std::size_t i = 0; i < first_.size(); ++i)
        if (result[i] == Scalar(0)) result[i] = changes[i];
    }
    return result;
  }

  /// Of `largest`: the size of coordinates that speed i is the rate of, by its unit; 0 if there are none.
  Scalar places_of(std::size_t i, const Array& largest) const {
    return place_[i] == k_none ? Scalar(0) : largest[place_[i]];
  }

 private:
  using Arrays = StateArrays<Model>;
  static constexpr std::size_t k_none = static_cast<std::size_t>(-1);

  static Scalar larger(const Scalar& a, const Scalar& b) {
    return Math<Scalar>::select(Math<Scalar>::less(a, b), b, a);
  }

  static std::string_view unit(const Model& model, std::size_t i) {
    const char* const text = model.unit(i);
    return text == nullptr ? std::string_view{} : std::string_view{text};
  }

  static bool is_rate_of(std::string_view rate, std::string_view place) {
    constexpr std::string_view k_per_second = "/s";
    if (rate.empty() || place.empty()) return rate == place;
    return rate.size() == place.size() + k_per_second.size() && rate.substr(0, place.size()) == place &&
           rate.substr(place.size()) == k_per_second;
  }

  std::size_t n_q_;
  typename Arrays::template Of<std::size_t> first_;
  typename Arrays::template Of<std::size_t> place_;  ///< of speeds
  typename Arrays::template Of<bool> is_angle_, is_number_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_UNIT_GROUPS_HPP
