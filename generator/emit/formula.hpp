#pragma once

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit {

/// The same for a reader, in comments: r^2 for r * r, 2 for S(2), min(a, b) and abs(a) for a selection. No C++ any more.
cpp::Expression as_formula(const cpp::Expression& expression);

}  // namespace gaussgen::emit
