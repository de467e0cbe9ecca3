#pragma once
// Identities of sines and cosines that save operations and lose no digits.

#include "passes/program.hpp"

namespace gaussgen::passes {

/// sin a cos b + cos a sin b becomes sin(a + b), and its like, where the program has that sine anyway, or its argument is a number.
Request join_angles(Graph& graph, const Request& request);

/// What is turned by an angle and then back again: s (c x + s y) + c (c y - s x) becomes y, for the sine s and the cosine c of
/// one angle, where that takes fewer operations with all that others use left as it is.
Request turn_back(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
