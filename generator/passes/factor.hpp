#pragma once

#include "passes/program.hpp"

namespace gaussgen::passes {

/// a b + a c + d becomes a (b + c) + d where the products have no other use. The factor that saves most goes first.
Request factor_out(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
