#pragma once

#include "ir/node.hpp"

namespace gaussgen::ir {

/// The rational c for which sum / c has coprime integer coefficients, most of them positive (on a tie: the leading one).
Rational signed_content(const Node& sum);

}  // namespace gaussgen::ir
