#pragma once
// Functions with jumps and kinks in what acts: steps become short where they are passed, and end where a motion sticks there.

#include <string>

#include "model/model.hpp"

namespace gausssim {

/// The function of the forces and constraints with the hardest edge that time or motion leads over, as the model calls it; empty: there is none.
std::string function_with_edge(const gaussgen::model::Model& of);

/// Whether forces or constraints are functions of time, too: they may act for a short one.
bool acts_in_time(const gaussgen::model::Model& of);

/// And no kink.
bool is_jump(const std::string& function);

/// What to do about it.
std::string hint_for_edge(const std::string& function);

}  // namespace gausssim
