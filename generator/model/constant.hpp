#pragma once
// Exact values of expressions that hold numbers only.

#include <map>
#include <optional>
#include <string>

#include "model/ast.hpp"

namespace gaussgen::model {

/// The value when the expression is made of numbers, + - * / ^ and choices (abs to piecewise, tables) alone and is rational; nothing
/// otherwise, and nothing for 1/0. The expression must have passed `growth`.
std::optional<support::Rational> exact_value(const Ast& ast);

/// 0, or a number that double has with all its digits.
bool is_in_range_of_double(const support::Rational& value);

/// A rational number for pi in the points of tables, to more than 300 digits.
support::Rational pi_of_table();

inline constexpr double k_largest_growth = 1 << 16;

/// An upper estimate, in bits, of what exact arithmetic makes of the numbers in the expression:
/// ((9^64)^64)^64 is short to write.
double growth(const Ast& ast);

/// The same, with names that stand for numbers of so many bits.
using BitsOfNames = std::map<std::string, double>;
double growth(const Ast& ast, const BitsOfNames& names);

}  // namespace gaussgen::model
