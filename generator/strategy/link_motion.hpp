#pragma once
// What velocities do along a tree of links, each in its own axes.

#include <functional>

#include "kinematics/linkage.hpp"
#include "strategy/steps.hpp"

namespace gaussgen::strategy {

/// Acceleration of the origin and of the rotation of a link, in its axes.
struct LinkAcceleration {
  ir::Vector3 linear;
  ir::Vector3 angular;
};

class LinkMotion {
 public:
  /// `links` may change until velocities are asked for. `fall`: the acceleration of the ground against free fall.
  LinkMotion(const std::vector<kinematics::Link>& links, ir::Vector3 fall, std::string prefix);

  void find_velocities(Steps& steps);

  /// Accelerations as they would be if no speed changed, with `fall`; but zero along components that are free to follow any.
  void accumulate(const std::function<bool(std::size_t link, std::size_t k)>& is_free, Steps& steps);

  const ir::Vector3& fall() const { return fall_; }
  const ir::Vector3& omega(std::size_t link) const { return omega_[link]; }
  /// m/s, of the origin.
  const ir::Vector3& velocity(std::size_t link, Steps& steps);
  /// rad/s, of the axes, which do not follow a spin.
  ir::Vector3 omega_of_axes(std::size_t link) const;
  /// `fall` in the axes of a link.
  const ir::Vector3& fall_at(std::size_t link);
  const LinkAcceleration& accumulated(std::size_t link) const { return accumulated_[link]; }

  /// What a link adds to the acceleration before it where no speed changes: linear for a shift, else angular.
  const ir::Vector3& drift(std::size_t link, Steps& steps);

  /// From the axes of the link before to those of this one.
  ir::Vector3 turned(std::size_t link, const ir::Vector3& v) const;

  /// And back.
  ir::Vector3 turned_back(std::size_t link, const ir::Vector3& v) const;

  ir::Expr sine(std::size_t link) const { return call(ir::Function::sin, *links_[link].angle); }
  ir::Expr cosine(std::size_t link) const { return call(ir::Function::cos, *links_[link].angle); }

 private:
  using Found = std::vector<std::optional<ir::Vector3>>;
  std::vector<std::size_t> missing(const Found& found, std::size_t link) const;
  ir::Vector3 omega_before(std::size_t link) const;
  ir::Vector3 of_turn(std::size_t link) const;
  ir::Vector3 of_shift(std::size_t link) const;

  const std::vector<kinematics::Link>& links_;
  ir::Vector3 fall_;
  std::string prefix_;
  std::vector<ir::Vector3> omega_;
  Found drift_, velocity_, fall_at_;
  std::vector<LinkAcceleration> accumulated_;
};

/// The same links and parts, with lengths and masses in these units.
kinematics::Linkage in_units(const kinematics::Linkage& linkage, const ir::Rational& length, const ir::Rational& mass);

ir::Vector3 scaled(const ir::Rational& factor, const ir::Vector3& v);

}  // namespace gaussgen::strategy
