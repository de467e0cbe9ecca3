#pragma once

#include "emit/cpp_tree.hpp"
#include "support/rational.hpp"

namespace gaussgen::emit {

/// A rational as an expression of type S that loses nothing in a type with more digits than double: S(2) / S(5), S(0.5).
/// Beyond the whole numbers of double: a sum of three doubles, good for about 150 bits.
cpp::Expression literal(const support::Rational& value);

/// True where a literal is one constant and not a quotient.
bool is_single_literal(const support::Rational& value);

/// As a person would write it, for comments: "9.81", "2/5".
std::string decimal_text(const support::Rational& value);

}  // namespace gaussgen::emit
