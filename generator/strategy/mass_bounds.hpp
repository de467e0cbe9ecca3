#pragma once
// How large what stands in Z can be, in any configuration: of that size is the rounding in a pivot.

#include <array>
#include <string>
#include <vector>

#include "strategy/mass_properties.hpp"

namespace gaussgen::strategy {

/// Bounds along three axes. Axes that turned into each other share one: then it bounds the sum of their diagonal entries.
class AxisBounds {
 public:
  explicit AxisBounds(const ir::Vector3& values) : values_{values[0], values[1], values[2]} {}

  ir::Expr along(std::size_t axis) const { return values_[of_[axis]]; }
  ir::Expr sum() const;

  void add(std::size_t axis, ir::Expr value) { values_[of_[axis]] += value; }
  void add(const AxisBounds& other);
  /// Turned into each other.
  void join(std::size_t axis, std::size_t other);
  /// Nothing is left along this axis.
  void clear(std::size_t axis);
  void keep_short(const std::string& name);

 private:
  bool is_used(std::size_t place) const { return of_[0] == place || of_[1] == place || of_[2] == place; }

  std::array<ir::Expr, 3> values_;
  std::array<std::size_t, 3> of_{0, 1, 2};
};

/// Of Z over the acceleration a of the origin of a link and its angular acceleration α: ½ mass a·a + |a| moment |α| + ½ inertia α·α is not
/// less than what stays of Z once it is minimised. A minimum is not above the value for any choice, such as no angular acceleration about an axis
/// over which Z is minimised.
struct MassBound {
  ir::Expr mass;
  AxisBounds moment;   ///< kg m
  AxisBounds inertia;  ///< kg m²

  static MassBound of(const MassProperties& own);
  void add(const MassBound& other);
  /// Minimised over the angular acceleration about this axis.
  void minimise(std::size_t axis);
};

/// In the axes of the link before, about its origin.
MassBound passed_on(const kinematics::Link& link, MassBound bound);

}  // namespace gaussgen::strategy
