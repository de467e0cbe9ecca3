#pragma once
// Partial products that several values have in common are computed once.

#include "passes/program.hpp"

namespace gaussgen::passes {

/// a b c and a b d become p c and p d with p = a b: the pair that most products have goes first, and then the next one
/// (Hosangadi, Fallah, Kastner, IEEE Trans. CAD 25, 2006). Squares count as pairs.
Request share_factors(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
