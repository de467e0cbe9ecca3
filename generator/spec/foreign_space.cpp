#include "spec/foreign_space.hpp"

#include <fmt/format.h>

#include <string_view>

#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::spec {

namespace {

constexpr char32_t k_no_break_space = 0xA0;
constexpr char32_t k_ideographic_space = 0x3000;

bool is_foreign_space(char32_t value) {
  return value == k_no_break_space || value == 0x202F || value == k_ideographic_space ||
         (value >= 0x2000 && value <= 0x200A);
}

std::string name_of_space(char32_t value) {
  const char* const kind = value == k_no_break_space ? "no-break " : value == k_ideographic_space ? "ideographic " : "";
  return fmt::format("a {}space U+{:04X}", kind, static_cast<std::uint32_t>(value));
}

/// Whether only spaces stand before `at` in its line.
bool begins_line(std::string_view text, std::uint32_t at) {
  while (at > 0 && text[at - 1] == ' ') --at;
  return at == 0 || text[at - 1] == '\n';
}

}  // namespace

bool refuse_foreign_space(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  if (at >= text.size() || !begins_line(text, at)) return false;
  const support::CodePoint first = support::code_point_at(text, at);
  if (!is_foreign_space(first.value)) return false;
  diagnostics.error(support::code::k_forbidden_character, {at, at + first.size},
                    name_of_space(first.value) + " in the indentation", "YAML indents with ordinary spaces only");
  return true;
}

}  // namespace gaussgen::spec
