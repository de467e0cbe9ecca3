#pragma once

#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/plan.hpp"

namespace gaussgen::emit {

/// n_q, n_v and their like.
std::vector<cpp::Item> sizes(const Plan& plan);

/// Names and units for drivers that work with any model; each table ends with an empty entry.
std::vector<cpp::Item> introspection_tables(const Plan& plan);

}  // namespace gaussgen::emit
