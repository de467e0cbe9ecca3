#include "support/utf8.hpp"

namespace gaussgen::support {

namespace {

struct Lead {
  std::uint32_t size;
  char32_t bits;
  char32_t smallest;  // below this the sequence is overlong
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if ((byte & 0xE0) == 0xC0) return {2, static_cast<char32_t>(byte & 0x1F), 0x80};
  if ((byte & 0xF0) == 0xE0) return {3, static_cast<char32_t>(byte & 0x0F), 0x800};
  if ((byte & 0xF8) == 0xF0) return {4, static_cast<char32_t>(byte & 0x07), 0x10000};
  return {0, 0, 0};
}

bool between(char32_t value, char32_t first, char32_t last) { return value >= first && value <= last; }

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t offset) {
  const auto byte = static_cast<unsigned char>(text[offset]);
  const Lead lead = lead_of(byte);
  const CodePoint invalid{byte, 1, false};
  if (lead.size == 0 || offset + lead.size > text.size()) return invalid;
  char32_t value = lead.bits;
  for (std::uint32_t i = 1; i < lead.size; ++i) {
    const auto next = static_cast<unsigned char>(text[offset + i]);
    if ((next & 0xC0) != 0x80) return invalid;
    value = (value << 6) | (next & 0x3F);
  }
  const bool surrogate = between(value, 0xD800, 0xDFFF);
  if (value < lead.smallest || surrogate || value > 0x10FFFF) return invalid;
  return {value, lead.size, true};
}

bool is_control(char32_t value) {
  if (value == '\t' || value == '\n' || value == '\r') return false;
  return value < 0x20 || between(value, 0x7F, 0x9F);
}

bool is_invisible(char32_t value) {
  return between(value, 0x200B, 0x200F) || between(value, 0x2028, 0x202E) || between(value, 0x2060, 0x206F) ||
         value == 0xFEFF || value == 0x061C || value == 0x00AD || between(value, 0xE0000, 0xE007F);
}

bool may_be_shown(const CodePoint& point) {
  return point.valid && point.value != '\r' && !is_control(point.value) && !is_invisible(point.value);
}

std::string without_controls(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = code_point_at(text, i);
    shown += may_be_shown(point) ? text.substr(i, point.size) : k_replacement;
    i += point.size;
  }
  return shown;
}

int display_width(char32_t value) {
  if (between(value, 0x0300, 0x036F) || between(value, 0x1AB0, 0x1AFF) || between(value, 0x20D0, 0x20FF)) return 0;
  const bool wide = between(value, 0x1100, 0x115F) || between(value, 0x2E80, 0xA4CF) ||
                    between(value, 0xAC00, 0xD7A3) || between(value, 0xF900, 0xFAFF) ||
                    between(value, 0xFE30, 0xFE6F) || between(value, 0xFF00, 0xFF60) ||
                    between(value, 0x1F300, 0x1FAFF) || between(value, 0x20000, 0x3FFFD);
  return wide ? 2 : 1;
}

}  // namespace gaussgen::support
