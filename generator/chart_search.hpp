#pragma once
// Configurations at which the coordinates no longer describe every motion: det g = 0 of the free speeds there, and nowhere beside.

#include <optional>
#include <vector>

#include "mechanics.hpp"

namespace gaussgen {

/// Beyond so many speeds nothing is looked for.
inline constexpr std::size_t k_most_charted_speeds = 20;

/// One coordinate is there, wherever the others are; or several, of which this is an instance.
struct SingularPlace {
  struct Pin {
    std::size_t coordinate;  ///< among the plain ones of the configuration
    double value;
  };
  std::vector<Pin> pins;
  bool is_instance = false;         ///< a relation between the coordinates, and not their values, makes it singular
  std::vector<std::size_t> speeds;  ///< that move nothing together
  bool is_of_speeds = false;        ///< det ∂u/∂q̇ = 0 of speeds that the model declares
};

/// Found by numbers in double, at t = 0 and the parameters of the model, on the equations of positions: at 0, half and whole turns,
/// at pairs of these, and by a search along each coordinate. What it takes is limited, so that it may miss a place; what it
/// finds is singular to 1e-10 of the usual.
std::vector<SingularPlace> singular_places(Mechanics& mechanics);

}  // namespace gaussgen
