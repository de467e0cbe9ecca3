#pragma once
// An expression to tokens. Only a whitelist of ASCII is accepted.

#include <string>
#include <vector>

#include "spec/node.hpp"
#include "support/diagnostics.hpp"
#include "support/rational.hpp"

namespace gaussgen::model {

inline constexpr std::size_t k_longest_expression = 64U << 10U;
inline constexpr std::size_t k_most_tokens = 20'000;
inline constexpr std::size_t k_most_digits = 40;
inline constexpr int k_largest_decimal_exponent = 400;  ///< beyond it no mantissa brings a number back into range

enum class TokenKind {
  number,
  name,
  plus,
  minus,
  times,
  divide,
  power,
  open,
  close,
  comma,
  less,
  at_most,
  greater,
  at_least,
  end
};

/// `begin` and `end` are bytes of the decoded text.
struct Token {
  TokenKind kind = TokenKind::end;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string name;
  support::Rational number = 0;
};

struct Tokens {
  std::vector<Token> all;  ///< with an `end` at the end
  bool is_cut = false;     ///< by a mistake that is reported; a name or number that it stands in is left out
};

Tokens tokenize(const spec::LocatedText& text, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
