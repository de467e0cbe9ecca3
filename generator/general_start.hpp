#pragma once
// The initial state where emitted code finds it by its general way: among rows of which some follow from others.

#include "mechanics.hpp"

namespace gaussgen {

/// Looks for the initial state at a time, to `digits` digits, where open values are to be found and constraints follow from others there; Mechanics::known_start becomes
/// it, and nothing where there is none. A step that takes as many rows as are independent in general position has rows that depend on each other at the solution of
/// a loop in space, and comes near it by halves or not at all.
void find_general_start(Mechanics& mechanics, const support::Rational& time, int digits);

}  // namespace gaussgen
