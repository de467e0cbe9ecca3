#pragma once

#include "ir/node.hpp"

namespace gaussgen::ir {

/// The rational c for which sum / c has coprime integer coefficients, most of them positive (on a tie: the leading one). Where these
/// would be long, the largest coefficient is between 1 and 2 instead. Of sum / c it is 1.
Rational signed_content(const Node& sum);

}  // namespace gaussgen::ir
