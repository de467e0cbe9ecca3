#pragma once
// abs, sign, min, max, piecewise and tables as GiNaC carries them: functions that it can differentiate and does nothing
// else to. GiNaC's own abs and csgn would be simplified by rules of its own.

#include <ginac/ginac.h>

namespace gaussgen::symbolic {

DECLARE_FUNCTION_1P(abs_of)
DECLARE_FUNCTION_1P(sign_of)
DECLARE_FUNCTION_2P(min_of)
DECLARE_FUNCTION_2P(max_of)
DECLARE_FUNCTION_4P(case_less)     ///< a < b ? c : d
DECLARE_FUNCTION_4P(case_at_most)  ///< a <= b ? c : d
DECLARE_FUNCTION_3P(table_at)      ///< index of the table in the model, order of the derivative, argument

}  // namespace gaussgen::symbolic
