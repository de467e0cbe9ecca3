#pragma once

#include <optional>
#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// A sum after one use of sin² x + cos² x = 1.
struct Replacement {
  Rational constant;
  std::vector<Term> terms;
};

/// Looks for c P sin² x + c P cos² x (becomes c P) and c P - c P cos² x (becomes c P sin² x, which also keeps the
/// digits that the difference loses near x = 0; likewise with sin and cos exchanged). P may be 1.
std::optional<Replacement> find_pythagorean_pair(Graph& graph, const Rational& constant,
                                                 const std::vector<Term>& terms);

}  // namespace gaussgen::ir
