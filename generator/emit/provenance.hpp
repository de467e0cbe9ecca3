#pragma once

#include <string>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/operations.hpp"
#include "emit/plan.hpp"

namespace gaussgen::emit {

/// The text on top of the header: what it is, where it comes from, what each of `functions` costs, by its count. No date, path or host.
std::string provenance_text(const Plan& plan, const std::vector<cpp::Function>& functions,
                            const std::vector<Operations>& counts);

}  // namespace gaussgen::emit
