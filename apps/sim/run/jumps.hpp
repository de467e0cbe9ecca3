#pragma once
// Functions with jumps and kinks in what acts, where steps become short and end where a motion sticks; and what acts at some time.

#include <string>

#include "model/model.hpp"

namespace gausssim {

/// The function of the forces and constraints with the hardest edge that time or motion leads over, as the model calls it; empty: there is none.
std::string function_with_edge(const gaussgen::model::Model& of);

/// Forces or constraints are written with the time, so that one may come and go while nothing moves.
bool acts_by_time(const gaussgen::model::Model& of);

/// What to do about an edge.
std::string hint_for_edge(const std::string& function);

}  // namespace gausssim
