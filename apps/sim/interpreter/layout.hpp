#pragma once
// Where the members of emitted structs are, in scalars from their beginning: as in C++, where they hold nothing but S.

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "sim/interpreter/integers.hpp"

namespace gausssim {

using Shape = std::vector<std::size_t>;

/// How many scalars an array has; one, where there is no shape.
std::size_t count_of(const Shape& shape);

struct Member {
  std::string name;  ///< with the group that it is in: rolling_around.multiplier
  Shape shape;       ///< {} of a scalar
  std::size_t offset = 0;
  std::string comment;  ///< unit and meaning, as the header has them
};

struct Layout {
  std::string name;
  std::size_t size = 0;
  std::vector<Member> members;
  std::unordered_map<std::string, std::size_t> places;  ///< of members by their names, and
  std::unordered_map<std::string, std::size_t>
      access;  ///< offsets of what a member function without arguments refers to

  void add(const std::string& member, Shape shape, const std::string& comment = {});
};

/// Of a struct of the tree; a struct that holds no scalars, such as a pattern, has no members.
Layout layout_of(const gaussgen::emit::cpp::Struct& type, const Integers& integers);

/// LinearSolution of the prelude, with its conditions as scalars.
Layout layout_of_solution(std::size_t speeds, std::size_t rows);

}  // namespace gausssim
