#pragma once
// The initial state where emitted code finds it by its general way: among rows of which some follow from others.

#include "mechanics.hpp"

namespace gaussgen {

/// Looks for the initial state at a time, to `digits` digits, where open values are to be found among constraints of which some always follow from others;
/// Mechanics::known_start becomes it, and nothing where there is none. A step that takes as many rows as are independent in general position has rows that depend on
/// each other at the solution of a loop in space, and comes near it by halves or not at all.
void find_general_start(Mechanics& mechanics, const support::Rational& time, int digits);

/// The same where constraints are independent elsewhere, and steps that count on it do not lead to a state that satisfies them.
void find_start_otherwise(Mechanics& mechanics, const support::Rational& time, int digits);

/// Whether `initial_values` are such a state.
bool is_start_found(Mechanics& mechanics, const support::Rational& time, int digits);

}  // namespace gaussgen
