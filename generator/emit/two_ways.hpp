#pragma once

#include "emit/split.hpp"
#include "emit/unit.hpp"

namespace gaussgen::emit {

/// A function that tries its own way, and the one that it turns to where that one's status is not ok: it fills the linear system,
/// has it solved whatever its rank (src/gauss/constrained.hpp) and makes results of the solution.
Parts two_ways(const Artefact& artefact);

}  // namespace gaussgen::emit
