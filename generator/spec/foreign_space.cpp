#include "spec/foreign_space.hpp"

#include <fmt/format.h>

#include <string_view>

#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::spec {

namespace {

constexpr char32_t k_no_break_space = 0xA0;
constexpr char32_t k_ideographic_space = 0x3000;

std::string name_of_space(char32_t value) {
  const char* const kind = value == k_no_break_space      ? "a no-break"
                           : value == k_ideographic_space ? "an ideographic"
                                                          : "a";
  return fmt::format("{} space U+{:04X}", kind, static_cast<std::uint32_t>(value));
}

/// Whether only spaces stand before `at` in its line.
bool begins_line(std::string_view text, std::uint32_t at) {
  while (at > 0 && text[at - 1] == ' ') --at;
  return at == 0 || text[at - 1] == '\n';
}

}  // namespace

bool is_foreign_space(char32_t value) {
  return value == k_no_break_space || value == 0x202F || value == k_ideographic_space ||
         (value >= 0x2000 && value <= 0x200A);
}

bool refuse_foreign_space(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  if (at >= text.size() || !begins_line(text, at)) return false;
  const support::CodePoint first = support::code_point_at(text, at);
  if (!is_foreign_space(first.value)) return false;
  diagnostics.error(support::code::k_forbidden_character, {at, at + first.size},
                    name_of_space(first.value) + " in the indentation", "YAML indents with ordinary spaces only");
  return true;
}

bool refuse_space_behind_key(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  while (at < text.size() && (support::is_name_character(text[at]) || text[at] == '$')) ++at;
  if (at + 1 >= text.size() || text[at] != ':') return false;
  ++at;
  const support::CodePoint next = support::code_point_at(text, at);
  if (!is_foreign_space(next.value)) return false;
  diagnostics.error(support::code::k_forbidden_character, {at, at + next.size},
                    name_of_space(next.value) + " behind the ':'",
                    "write an ordinary space: to YAML, this is a letter");
  return true;
}

}  // namespace gaussgen::spec
