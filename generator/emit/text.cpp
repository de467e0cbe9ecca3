#include "emit/text.hpp"

#include <algorithm>

#include "support/utf8.hpp"

namespace gaussgen::emit {

namespace {

constexpr char32_t k_line_separator = 0x2028;
constexpr char32_t k_paragraph_separator = 0x2029;

bool breaks_line(char32_t c) {
  return c < 0x20 || support::is_control(c) || c == k_line_separator || c == k_paragraph_separator;
}

bool is_harmless(const support::CodePoint& point) {
  return point.valid && !breaks_line(point.value) && !support::is_invisible(point.value);
}

std::size_t columns(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const support::CodePoint point = support::code_point_at(text, i);
    width += point.valid ? static_cast<std::size_t>(support::display_width(point.value)) : 1;
    i += point.size;
  }
  return width;
}

/// Looks at no more of it than it has to: a text may be of megabytes.
bool is_wider(std::string_view text, std::size_t width) {
  const std::size_t most_bytes = 4 * (width + 1);
  return (text.size() > most_bytes && columns(text.substr(0, most_bytes)) > width) || columns(text) > width;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string comment_text(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const support::CodePoint point = support::code_point_at(text, i);
    if (is_harmless(point)) {
      result += text.substr(i, point.size);
    } else if (!point.valid) {
      result += '?';
    } else if (breaks_line(point.value)) {
      result += ' ';
    }
    i += point.size;
  }
  replace_all(result, "*/", "* /");
  replace_all(result, "/*", "/ *");
  replace_all(result, "?\?/", "? ?/");  // a backslash, once
  while (!result.empty() && result.back() == ' ') result.pop_back();
  if (!result.empty() && result.back() == '\\') result += " .";
  return result;
}

std::string string_literal(std::string_view text) {
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const support::CodePoint point = support::code_point_at(text, i);
    const char c = text[i];
    if (c == '"' || c == '\\' || c == '?') {
      // A question mark could begin a trigraph.
      result += (c != '?' || (i > 0 && text[i - 1] == '?')) ? std::string{'\\', c} : std::string{c};
    } else if (is_harmless(point)) {
      result += text.substr(i, point.size);
    } else {
      for (std::size_t k = 0; k < point.size; ++k) {
        const auto byte = static_cast<unsigned char>(text[i + k]);
        result += {'\\', static_cast<char>('0' + byte / 64), static_cast<char>('0' + byte / 8 % 8),
                   static_cast<char>('0' + byte % 8)};
      }
    }
    i += point.size;
  }
  return result + "\"";
}

std::string wrapped(std::string_view text, std::size_t width) {
  std::string result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = comment_text(text.substr(begin, end - begin));
    std::string_view rest = line;
    while (is_wider(rest, width)) {
      const std::size_t cut = rest.rfind(' ', width);
      if (cut == std::string::npos || cut == 0) break;
      result += comment_text(rest.substr(0, cut)) + "\n";
      rest.remove_prefix(cut + 1);
    }
    result += std::string(rest) + (end < text.size() ? "\n" : "");
    begin = end + 1;
  }
  return result;
}

std::string table_text(const std::vector<std::vector<std::string>>& rows, const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
  }
  std::string result;
  for (const std::vector<std::string>& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - columns(row[i]) + 2, ' ');
    while (!line.empty() && line.back() == ' ') line.pop_back();
    result += (result.empty() ? "" : "\n") + line;
  }
  return result;
}

}  // namespace gaussgen::emit
