#include "spec/text_check.hpp"

#include <fmt/format.h>

#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::spec {

namespace code = support::code;

namespace {

const char* const k_save_as_utf8 = "save the file as UTF-8 without a byte order mark";

bool starts_with(std::string_view text, std::string_view head) { return text.substr(0, head.size()) == head; }

/// UTF-16 and UTF-32, by their mark or by the zero byte that every ASCII letter brings with it.
bool is_wide_encoding(std::string_view text) {
  if (starts_with(text, "\xFF\xFE") || starts_with(text, "\xFE\xFF")) return true;
  return text.substr(0, 4).find('\0') != std::string_view::npos;
}

std::uint32_t offset32(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

std::string describe(char32_t value) {
  if (value == 0) return "a NUL byte";
  return fmt::format("{} U+{:04X}", support::is_control(value) ? "the control character" : "the invisible character",
                     static_cast<std::uint32_t>(value));
}

/// YAML takes a CR alone for the end of a line, yaml-cpp and what counts lines do not.
bool check_line_ends(const support::Source& source, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  for (std::size_t i = text.find('\r'); i != std::string_view::npos; i = text.find('\r', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '\n') continue;
    diagnostics.error(code::k_yaml_syntax, {offset32(i), offset32(i) + 1}, "a line ends with CR alone here",
                      "save the file with LF, or CR and LF, at the end of each line");
    return false;
  }
  return true;
}

bool check_characters(const support::Source& source, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  for (std::size_t i = byte_order_mark(text); i < text.size();) {
    const support::CodePoint point = support::code_point_at(text, i);
    const support::Span span{offset32(i), offset32(i) + point.size};
    if (!point.valid) {
      diagnostics.error(
          code::k_encoding, span,
          fmt::format("the byte 0x{:02X} is not part of UTF-8 text", static_cast<std::uint32_t>(point.value)),
          k_save_as_utf8);
      return false;
    }
    if (support::is_control(point.value) || support::is_invisible(point.value)) {
      diagnostics.error(code::k_forbidden_character, span, describe(point.value) + " may not appear in a model file",
                        "delete it; it is not visible in most editors");
      return false;
    }
    i += point.size;
  }
  return true;
}

}  // namespace

std::size_t byte_order_mark(std::string_view text) { return starts_with(text, "\xEF\xBB\xBF") ? 3 : 0; }

bool check_text(const support::Source& source, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  if (text.size() > k_largest_file) {
    diagnostics.error(code::k_file_too_large, {0, 0},
                      // Of a larger one, no more than the beginning is read.
                      fmt::format("the file has more than {} MiB", k_largest_file >> 20U),
                      "a model file describes one mechanism; split it");
    return false;
  }
  if (is_wide_encoding(text)) {
    diagnostics.error(code::k_encoding, {0, 0}, "the file is encoded in UTF-16 or UTF-32", k_save_as_utf8);
    return false;
  }
  return check_characters(source, diagnostics) && check_line_ends(source, diagnostics);
}

}  // namespace gaussgen::spec
