#pragma once
// The other two ways to emit a model.

#include "answers.hpp"

namespace headertest {

std::vector<Computed> folded_models();  ///< in double
std::vector<Computed> paper_models();   ///< in double

}  // namespace headertest
