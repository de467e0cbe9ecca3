#pragma once
// What depends on what in x' = A x.

#include <cstddef>
#include <vector>

#include "analysis/matrix.hpp"

namespace gaussgen::analysis {

/// Sums with zeros where nothing but rounding is left of them, beside the sums of the sizes of their terms.
Matrix without_rounding(const Matrix& sums, const Matrix& terms);

/// a b, with zeros where nothing but rounding is left of the sum.
Matrix product(const Matrix& a, const Matrix& b);

/// Variables that depend on each other, also over others; in an order in which each block depends on itself and on earlier ones alone.
/// Eigenvalues of `a` are those of its blocks: what is integrated from others has zeros, whatever the units.
std::vector<std::vector<std::size_t>> blocks(const Matrix& a);

/// Of the variables that are `candidates`, those on which nothing depends except others of them: their columns vanish, and may be left out.
std::vector<std::size_t> without_effect(const Matrix& a, const std::vector<bool>& candidates);

/// Rows and columns of some variables.
Matrix part(const Matrix& a, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns);

}  // namespace gaussgen::analysis
