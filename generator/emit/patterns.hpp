#pragma once
// Sparse matrices in results: where their entries are, and the whole matrix.

#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/plan.hpp"

namespace gaussgen::emit {

/// One for each pattern.
std::vector<cpp::Struct> pattern_structs(const Unit& unit);

/// `dense(jacobian, JacobianByState{}, matrix)`, for each likewise.
std::vector<cpp::Function> dense_functions(const Plan& plan);

}  // namespace gaussgen::emit
