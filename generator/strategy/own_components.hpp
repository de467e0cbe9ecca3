#pragma once
// Which acceleration components are free themselves, whatever the links before do: over these Z is minimised first.

#include "strategy/link_rows.hpp"
#include "strategy/mass_properties.hpp"

namespace gaussgen::strategy {

/// A component of a joint that is free: by a speed, or because constraints say what it is.
struct OwnComponent {
  bool is_free = false;
  const kinematics::Freedom* freedom = nullptr;
};

/// The links from one whose origin is free to the one at whose origin its free components are minimised; often it is one link.
struct FloatingBase {
  std::size_t base;
  std::size_t anchor;
  std::array<bool, 3> along;  ///< of both
};

struct OwnComponents {
  std::vector<std::array<OwnComponent, 3>> of_joint;  ///< of links: along what moves, linear for a shift, else angular
  std::vector<FloatingBase> bases;
  std::vector<std::vector<std::size_t>>
      uses;  ///< of speeds: links that they move in components that are not free, in order

  std::vector<char> is_owned;  ///< of speeds: one of the components is theirs
  std::vector<std::pair<std::size_t, std::size_t>>
      in_order;  ///< links and components, as they were found to be free by a speed

  const FloatingBase* base_anchored_at(std::size_t link) const;
  const FloatingBase* base_at(std::size_t link) const;
};

/// `is_acted_on`: speeds along which something acts besides inertia.
OwnComponents own_components(const std::vector<kinematics::Link>& links, const std::vector<MassProperties>& properties,
                             const std::vector<char>& is_acted_on,
                             const std::vector<std::pair<std::size_t, std::size_t>>& released);

}  // namespace gaussgen::strategy
