#pragma once
// The words and signs of a unit.

#include <string>
#include <vector>

#include "support/rational.hpp"

namespace gaussgen::model {

enum class UnitTokenKind { name, number, times, divide, power, raised, minus, open, close, other, end };

struct UnitToken {
  UnitTokenKind kind = UnitTokenKind::end;
  std::size_t begin = 0;  ///< bytes of the unit's text
  std::size_t end = 0;
  support::Rational value = 0;  ///< of a number, and of raised digits with their sign
};

/// Never fails: what no unit holds is `other`. The last one is `end`.
std::vector<UnitToken> unit_tokens(const std::string& text);

}  // namespace gaussgen::model
