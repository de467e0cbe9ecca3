#pragma once

#include "lower/formula_writer.hpp"

namespace gaussgen::lower {

/// Section 3 of the paper: constraints, elimination, equations (3.7) and (3.8), multipliers.
void add_equation_sections(const nonholonomic::PaperSystem& paper, FormulaWriter& write, Derivation& derivation);

}  // namespace gaussgen::lower
