#pragma once
// What names and numbers are written with: ASCII, whatever the locale.

namespace gaussgen::support {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// May stand in a name after its first letter.
constexpr bool is_name_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

}  // namespace gaussgen::support
