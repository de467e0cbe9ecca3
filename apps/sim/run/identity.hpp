#pragma once
// Whether two runs are of the same motion.

#include <string>

#include "sim/run/prepare.hpp"

namespace gausssim {

/// The model with the values of its parameters and its start, and all that is made of it. Words about the file, such as a comment in it, are no part of that.
std::string identity_of(const PreparedModel& prepared);

/// The same motion, whatever is made of the model: its files, the values of parameters and inputs, and the start.
std::string identity_of_problem(const PreparedModel& prepared);

}  // namespace gausssim
