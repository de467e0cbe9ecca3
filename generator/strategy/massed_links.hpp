#pragma once
// The links of a model with what has mass on them, for what is known of a state before anything is solved.

#include "strategy/link_motion.hpp"
#include "strategy/mass_properties.hpp"

namespace gaussgen::strategy {

/// Wheels keep their axes, and masses are at the ends of bars, as where Z is minimised (docs/decisions/0007).
class MassedLinks {
 public:
  MassedLinks(const kinematics::Linkage& linkage, ir::Graph& graph);
  MassedLinks(const MassedLinks&) = delete;  // motions refer to the links
  MassedLinks& operator=(const MassedLinks&) = delete;

  const std::vector<kinematics::Link>& links() const { return linkage_.links; }
  /// Of a link without the mass at its origin.
  const MassProperties& rest(std::size_t link) const { return properties_[link]; }
  /// kg, of all links with the same origin as this one, at the first of them; zero at the others.
  ir::Expr at_origin(std::size_t link) const { return at_origin_[link]; }

 private:
  kinematics::Linkage linkage_;
  std::vector<MassProperties> properties_;
  Vector at_origin_;
};

}  // namespace gaussgen::strategy
