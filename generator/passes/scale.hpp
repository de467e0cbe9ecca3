#pragma once

#include "passes/program.hpp"

namespace gaussgen::passes {

/// Numbers that multiply values go where they cost nothing: 0.49 A + 0.2 computed as 0.49 (A + 0.2/0.49), where the factor
/// joins those of the products in which the value is used. Values are computed in units of their own, so to speak.
Request choose_units(Graph& graph, const Request& request);

}  // namespace gaussgen::passes
