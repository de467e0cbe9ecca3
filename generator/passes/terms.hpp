#pragma once
// Partial sums that several values have in common are computed once.

#include "passes/program.hpp"

namespace gaussgen::passes {

/// a + b + c and d - 2 a - 2 b become s + c and d - 2 s with s = a + b. Likewise a - b and b - a, which are one value and its
/// negative. The pair that saves most goes first, and then the next one.
Request share_terms(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
