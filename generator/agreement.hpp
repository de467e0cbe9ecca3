#pragma once
// Whether constraints that follow from each other ask for the same elsewhere, too: two that agree at the initial state may be x' = 0 and x' = a t^2.

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics.hpp"

namespace gaussgen {

/// Of constraint `index`, whose gradient is a combination of those of `others`, or elsewhere of `more`: whether the same combination of what they ask for
/// vanishes at other times, in states that nothing singles out, on the equations of positions. Nothing where no such state is found.
/// `part` of a row of length 1, and of what is asked for, is taken for nothing; less than rounding leaves is so anyway.
std::optional<bool> agree_elsewhere(Mechanics& mechanics, const std::vector<std::size_t>& others,
                                    const std::vector<std::size_t>& more, std::size_t index, double part);

}  // namespace gaussgen
