#pragma once

#include <map>
#include <string>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit {

/// Operations on values of type S, as written. Changes of sign, comparisons and quotients of two numbers are free.
struct Operations {
  int additions = 0;  ///< and subtractions
  int multiplications = 0;
  int divisions = 0;
  int square_roots = 0;
  int functions = 0;  ///< sin, pow, …; a sine and a cosine together are two
};

int total(const Operations& operations);

/// `callees`: what calls of functions of the same header cost.
Operations operations_of(const cpp::Function& function, const std::map<std::string, Operations>& callees = {});

Operations operations_of(const std::vector<cpp::Statement>& statements,
                         const std::map<std::string, Operations>& callees = {});

/// Of each; functions come after those that they call.
std::vector<Operations> operations_of_all(const std::vector<cpp::Function>& functions,
                                          std::map<std::string, Operations> callees);

}  // namespace gaussgen::emit
