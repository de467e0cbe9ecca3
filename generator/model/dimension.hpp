#pragma once
// The dimension of a quantity: exact powers of the base units of SI.

#include <array>
#include <cstddef>
#include <string>

#include "support/rational.hpp"

namespace gaussgen::model {

/// Angles are plain numbers in the algebra, as SI has it: rad/s is 1/s, and N*m/rad is N*m. Their power is remembered all the same, so
/// that a message can say rad/s.
struct Dimension {
  std::array<support::Rational, 7> powers = {0, 0, 0, 0, 0, 0, 0};  ///< of m, kg, s, A, K, mol, cd
  support::Rational angle = 0;                                      ///< of rad; no part of a comparison
};

inline constexpr std::array<const char*, 7> k_base_units = {"m", "kg", "s", "A", "K", "mol", "cd"};

Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);
Dimension power(const Dimension& base, const support::Rational& exponent);

/// Whether both can be added; angles and plain numbers can.
bool agree(const Dimension& a, const Dimension& b);

/// m^0 kg^0 ..., angles included.
bool is_number(const Dimension& dimension);

/// In units that people know: "N*m" for kg*m^2/s^2, "rad/s", "m^(1/2)"; "1" for a plain number.
std::string text(const Dimension& dimension);

}  // namespace gaussgen::model
