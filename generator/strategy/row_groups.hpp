#pragma once
// Which constraints may follow from each other for what they depend on, whatever their coefficients are.

#include <optional>
#include <vector>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// For each constraint the number of its group; nothing for one that has a coordinate of its own.
///
/// A coordinate that one constraint alone is about is set by it: whatever holds on all constraints holds without this one as well, and it takes part in no
/// combination of others. Without it another may have a coordinate of its own, and so on. What is left falls into parts without common coordinates.
std::vector<std::optional<std::size_t>> row_groups(const Dynamics& dynamics);

}  // namespace gaussgen::strategy
