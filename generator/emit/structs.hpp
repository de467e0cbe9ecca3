#pragma once

#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/plan.hpp"

namespace gaussgen::emit {

cpp::Struct parameters_struct(Plan& plan);
cpp::Struct inputs_struct(Plan& plan);
cpp::Struct prepared_struct(Plan& plan);
cpp::Struct state_struct(const Plan& plan);
cpp::Struct derivative_struct(const Plan& plan);

}  // namespace gaussgen::emit
