#pragma once

#include "passes/program.hpp"

namespace gaussgen::passes {

/// X - X x/D with D = x + c becomes X c/D: fewer operations, and the digits that the difference would lose stay. This is how
/// the inertia of bodies in series comes out of a Schur complement.
Request join_quotients(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
