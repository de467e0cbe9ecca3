#pragma once

#include <string>

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit::cpp {

/// Longest line; a name that is longer by itself may exceed it.
inline constexpr std::size_t k_line_length = 110;

std::string print(const File& file);

/// On one line; for tests and comments.
std::string print(const Expression& expression);

}  // namespace gaussgen::emit::cpp
