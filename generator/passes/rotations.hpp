#pragma once
// Sines and cosines of sums of angles by rotation, where those of the parts are there.

#include "passes/program.hpp"

namespace gaussgen::passes {

/// sin(a + b), cos(a + b) become sin a cos b + cos a sin b, cos a cos b - sin a sin b where the program has the sines and cosines of a
/// and b anyway (or b is of parameters): more operations and fewer instructions, since one call takes as many as some eighty operations.
/// So do sums of three parts, and differences. No value stands behind more than two rotations, whose errors add up. An error is that of
/// a change of a and b in their last digits: |sin a cos b| + |cos a sin b| ≤ |a| + |b|.
Request rotate_angles(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
