#pragma once
// What is in the structs of an emitted header, number by number.

#include <string>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gausssim {

/// One number of a struct, which is an array of them.
struct ResultNumber {
  std::string name;  ///< as a C++ program writes it: rho.generalized, on_ball.force[2]
  std::string unit;  ///< may be empty
  std::string about;
};

/// Of all numbers in the order in which they lie; nothing where the tree has no such struct.
std::vector<ResultNumber> layout_of(const gaussgen::emit::cpp::File& tree, const std::string& type);

const gaussgen::emit::cpp::Struct* find_struct(const gaussgen::emit::cpp::File& tree, const std::string& type);
const gaussgen::emit::cpp::Function* find_function(const gaussgen::emit::cpp::File& tree, const std::string& name);

}  // namespace gausssim
