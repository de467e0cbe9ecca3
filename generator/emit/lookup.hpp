#pragma once
// Tables as functions of emitted code.

#include <map>
#include <vector>

#include "emit/operations.hpp"
#include "emit/plan.hpp"

namespace gaussgen::emit {

/// Of each table that is used: the function that finds a piece, then the derivatives that are used.
std::vector<cpp::Function> table_functions(const Plan& plan);

/// What a call of each of them costs.
std::map<std::string, Operations> costs_of(const std::vector<cpp::Function>& tables);

}  // namespace gaussgen::emit
