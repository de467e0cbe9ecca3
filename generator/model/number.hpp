#pragma once
// Decimal literals as exact rationals: 0.1 is 1/10, so that exact cancellation stays exact.

#include <string>
#include <string_view>

#include "support/rational.hpp"

namespace gaussgen::model {

struct NumberScan {
  std::size_t size = 0;  ///< bytes that belong to the literal, also when it is refused
  support::Rational value = 0;
  std::string problem;  ///< empty when the literal is good
  std::string hint;
};

/// The literal at the start of `text`, which begins with a digit or with a point and a digit.
NumberScan scan_number(std::string_view text);

}  // namespace gaussgen::model
