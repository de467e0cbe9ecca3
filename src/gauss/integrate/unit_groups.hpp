// Which components of a state have the same unit, and what sizes are to be compared with.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_UNIT_GROUPS_HPP
#define GAUSS_INTEGRATE_UNIT_GROUPS_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace gauss::integrate {

/// Components of a model's state in groups of the same unit, coordinates apart from speeds. A component of which no unit is known is alone.
template <class Model>
class UnitGroups {
 public:
  using Scalar = typename Model::Scalar;
  using Array = std::array<Scalar, Model::size>;

  explicit UnitGroups(const Model& model) {
    for (std::size_t i = 0; i < Model::size; ++i) {
      is_angle_[i] = has_unit(model, i, "rad");
      first_[i] = i;
      for (std::size_t k = i < Model::n_q ? 0 : Model::n_q; k < i && first_[i] == i; ++k)
        if (has_unit(model, i, model.unit(k))) first_[i] = k;
    }
  }

  /// For each component the largest of its group, of `sizes` that are not negative; for angles it is 1 at least, since they have a scale of their own.
  Array largest(const Array& sizes) const {
    Array result{};
    for (std::size_t i = 0; i < Model::size; ++i)
      result[first_[i]] = std::max({result[first_[i]], sizes[i], is_angle_[i] ? Scalar(1) : Scalar(0)});
    for (std::size_t i = 0; i < Model::size; ++i) result[i] = result[first_[i]];
    return result;
  }

  Array largest(const typename Model::State& state) const {
    Array sizes;
    for (std::size_t i = 0; i < Model::size; ++i) sizes[i] = std::abs(state.values[i]);
    return largest(sizes);
  }

 private:
  static bool has_unit(const Model& model, std::size_t i, const char* unit) {
    const char* const own = model.unit(i);
    return own != nullptr && unit != nullptr && std::strcmp(own, unit) == 0;
  }

  std::array<std::size_t, Model::size> first_{};
  std::array<bool, Model::size> is_angle_{};
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_UNIT_GROUPS_HPP
