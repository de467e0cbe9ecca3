#pragma once
// Just enough UTF-8 to validate a text, to name a character and to place a caret.

#include <cstdint>
#include <string>
#include <string_view>

namespace gaussgen::support {

struct CodePoint {
  char32_t value = 0;
  std::uint32_t size = 1;  ///< bytes
  bool valid = true;       ///< false: one byte that is no part of a well-formed sequence
};

/// The code point that starts at `offset`, which must lie inside the text.
CodePoint code_point_at(std::string_view text, std::size_t offset);

/// C0 and C1 controls, except tab and line breaks.
bool is_control(char32_t value);

/// Characters that reorder or hide text: bidirectional controls, zero-width characters, a BOM inside.
bool is_invisible(char32_t value);

inline constexpr std::string_view k_replacement = "\xEF\xBF\xBD";  ///< U+FFFD, for what may not be shown

/// False for what a terminal would obey, hide or not understand.
bool may_be_shown(const CodePoint& point);

/// `text` with k_replacement for each code point that may not be shown.
std::string without_controls(std::string_view text);

/// Columns on a terminal: 0 for combining marks, 2 for wide East Asian characters.
int display_width(char32_t value);

}  // namespace gaussgen::support
