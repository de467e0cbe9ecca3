#pragma once
// Is the initial state one that the motion can start from? Emitted code takes it as it is.

#include "assembly.hpp"
#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

struct StartOptions {
  bool is_emitted = false;
  bool is_elsewhere = false;                ///< the motion starts in another regime, and is not to start in this one
  bool is_assembled = false;                ///< given rates may have become guesses: that constraints choose is wanted
  const support::Source* source = nullptr;  ///< to quote from, if there is one
};

/// Warns where the initial state of the model has no value, makes constraints depend on each other, or makes the mass matrix
/// singular. One that violates a constraint is an error where the state is emitted.
void check_initial_state(Mechanics& mechanics, const StartOptions& options, support::Diagnostics& diagnostics);

/// Whether the initial state satisfies all constraints, as far as it has a value.
bool is_start_of(Mechanics& mechanics);

/// "theta2: 0.5 -> 0.5236": initial values that the search for a state without violations has moved from what the model stated.
std::vector<std::string> assembled_values(Mechanics& mechanics, const StatedStart& stated,
                                          const support::Rational& time = 0);

}  // namespace gaussgen
