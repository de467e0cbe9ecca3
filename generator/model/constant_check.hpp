#pragma once
// Parts of an expression that hold numbers and pi only and have no real, finite value. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// Reports the innermost such part; false when there was one.
bool check_constants(const Ast& ast, Reading& reading);

}  // namespace gaussgen::model
