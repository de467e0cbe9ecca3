#pragma once
// Decimal literals as exact rationals: 0.1 is 1/10, so that exact cancellation stays exact.

#include <string>
#include <string_view>

#include "support/error_codes.hpp"
#include "support/rational.hpp"

namespace gaussgen::model {

struct NumberScan {
  std::size_t size = 0;  ///< bytes that belong to the literal, also when it is refused
  support::Rational value = 0;
  std::string problem;  ///< empty when the literal is good
  const support::ErrorCode* code = &support::code::k_malformed_number;
  std::string hint;
};

// What a number is that double does not hold in full precision, whether it is written or computed from numbers.
inline constexpr const char* k_too_large = "this number is too large for the arithmetic of a computer";
inline constexpr const char* k_too_small = "this number is too small for the arithmetic of a computer";
inline constexpr const char* k_hint_for_range =
    "choose units in which numbers are of moderate size: from 2.3e-308 to 1.79e308, or 0";

/// The literal at the start of `text`, which begins with a digit or with a point and a digit.
NumberScan scan_number(std::string_view text);

}  // namespace gaussgen::model
