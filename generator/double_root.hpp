#pragma once
// Positions at which two roots are one, as where a crank is at its dead centre or a loop is stretched.

#include <vector>

#include "position_equations.hpp"

namespace gaussgen {

/// From a position that satisfies its equations to the double root beside it, if there is one as near as half of the digits. f changes by squares along some way v there, so that searches for f = 0 end half of the
/// digits before; uᵀ J v, the least singular value of the derivatives, changes its sign there, and says in all digits where. `spans`: of displacements along the speeds. The first `plain` coordinates
/// are plain ones: what is left of these beside 0 becomes 0.
void go_to_double_root(PositionEquations& equations, const std::vector<double>& spans, std::size_t plain);

}  // namespace gaussgen
