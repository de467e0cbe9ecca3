#pragma once

#include <string>

namespace gaussgen::ir {

/// Order of names in which digits count as numbers: link2 before link10.
int compare_natural(const std::string& a, const std::string& b);

}  // namespace gaussgen::ir
