#pragma once
// Words of a user inside emitted code: they may say anything and must not do anything.

#include <string>
#include <string_view>
#include <vector>

namespace gaussgen::emit {

/// One line that is safe after `//`: no line break, no control or reordering character, no comment end, no backslash at
/// the end. Readable text stays as it is.
std::string comment_text(std::string_view text);

/// With the quotes.
std::string string_literal(std::string_view text);

/// comment_text of each line, broken at spaces to `width` columns; empty lines stay.
std::string wrapped(std::string_view text, std::size_t width);

/// Columns of a table, padded to the same width. Trailing spaces are cut.
std::string table_text(const std::vector<std::vector<std::string>>& rows, const std::string& indent);

}  // namespace gaussgen::emit
