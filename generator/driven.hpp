#pragma once

#include <string>

#include "mechanics.hpp"

namespace gaussgen {

/// What to do about the held coordinates whose laws move them at this time (in s), each with its rate and acceleration; empty if none moves.
std::string driven_coordinates(Mechanics& mechanics, const support::Rational& time);

}  // namespace gaussgen
