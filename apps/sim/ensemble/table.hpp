#pragma once
// The table of an ensemble, as text.

#include <string>
#include <vector>

#include "sim/ensemble/trajectory.hpp"

namespace gausssim {

/// `trajectory,status,parameters.m [kg],…,t [s],chi [rad],…`.
std::string ensemble_header(const PreparedModel& prepared, const std::vector<Varied>& varied);

/// Cells of numbers that there are none of are empty.
template <class S>
void append_rows(std::string& text, long trajectory, const std::vector<double>& values, const Track<S>& track,
                 std::size_t width);

}  // namespace gausssim
