#pragma once
// What is corrected in a state after each step.

#include <array>
#include <string>
#include <utility>

namespace gausssim {

enum class Projection {
  full,        ///< onto all that constraints ask for
  positions,   ///< onto their equations of positions alone: loops stay closed, while speeds drift
  velocities,  ///< onto constraints of velocities alone
  energy,      ///< full, and speeds are scaled so that the energy is that of the start
  gains,       ///< nothing: accelerations pull violations back (Baumgarte)
  off,
};

/// As scenes call them.
inline constexpr std::array<std::pair<const char*, Projection>, 6> k_projections{
    {{"full", Projection::full},
     {"positions", Projection::positions},
     {"velocities", Projection::velocities},
     {"energy", Projection::energy},
     {"gains", Projection::gains},
     {"off", Projection::off}}};

inline std::string name_of(Projection projection) {
  for (const auto& [name, how] : k_projections) {
    if (how == projection) return name;
  }
  return "";
}

/// Of one of these names.
inline Projection projection_of(const std::string& name) {
  for (const auto& [known, how] : k_projections) {
    if (known == name) return how;
  }
  return Projection::full;
}

}  // namespace gausssim
