#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "support/diagnostics.hpp"
#include "support/utf8.hpp"

namespace gaussgen::support {

namespace {

constexpr std::size_t k_longest_text = 2000;
constexpr int k_widest_line = 160;
constexpr int k_columns_before_caret = 60;
constexpr std::uint32_t k_bytes_around = 4096;

/// One character as shown, with the terminal columns it takes and the byte it came from.
struct Cell {
  std::string shown;
  int width = 1;
  std::uint32_t offset = 0;
};

/// Nothing that a terminal would obey or hide, and a tab is one column wide.
Cell cell_at(std::string_view text, std::uint32_t offset, const CodePoint& point) {
  const bool break_or_tab = point.value == '\t' || point.value == '\n' || point.value == '\r';
  if (break_or_tab) return {" ", 1, offset};
  if (!may_be_shown(point)) return {std::string(k_replacement), 1, offset};
  return {std::string(text.substr(offset, point.size)), display_width(point.value), offset};
}

std::vector<Cell> cells_of(std::string_view text) {
  std::vector<Cell> cells;
  for (std::uint32_t i = 0; i < text.size();) {
    const CodePoint point = code_point_at(text, i);
    cells.push_back(cell_at(text, i, point));
    i += point.size;
  }
  return cells;
}

std::string harmless(std::string_view text) {
  std::string shown;
  for (const Cell& cell : cells_of(text)) shown += cell.shown;
  return shown;
}

int width_of(const std::vector<Cell>& cells) {
  int width = 0;
  for (const Cell& cell : cells) width += cell.width;
  return width;
}

/// Cuts a long line to a window around byte `begin`; an ellipsis stands for what is left out.
std::vector<Cell> window(std::vector<Cell> cells, std::uint32_t begin) {
  if (width_of(cells) <= k_widest_line) return cells;
  const auto caret = std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.offset >= begin; });
  const auto room = std::min<std::ptrdiff_t>(caret - cells.begin(), k_columns_before_caret);
  auto first = caret - room;
  // Near the end of the line the window shows what precedes instead of empty space.
  if (cells.end() - first < k_widest_line)
    first = cells.end() - std::min<std::ptrdiff_t>(cells.end() - cells.begin(), k_widest_line);
  auto last = first;
  for (int width = 0; last != cells.end() && width + last->width <= k_widest_line; ++last) width += last->width;
  std::vector<Cell> cut(first, last);
  if (first != cells.begin()) cut.insert(cut.begin(), {"...", 3, first->offset});
  if (last != cells.end()) cut.push_back({"...", 3, last->offset});
  return cut;
}

/// The bytes of a line that can come into the window, so that a line of megabytes costs no more than another.
struct Piece {
  std::string_view text;
  std::uint32_t offset = 0;
};

Piece piece_around(std::string_view line, std::uint32_t begin) {
  const auto is_continuation = [&](std::uint32_t i) { return i < line.size() && (line[i] & 0xC0) == 0x80; };
  std::uint32_t first = begin > k_bytes_around ? begin - k_bytes_around : 0;
  while (is_continuation(first)) ++first;
  return {line.substr(first, 2 * k_bytes_around), first};
}

struct Snippet {
  std::string line;
  std::string caret;
};

/// `begin` and `end` are byte offsets inside the line.
Snippet snippet(std::string_view whole, std::uint32_t begin, std::uint32_t end) {
  const Piece piece = piece_around(whole, begin);
  const std::string_view line = piece.text;
  begin -= piece.offset;
  end -= piece.offset;
  Snippet result;
  bool marked = false;
  for (const Cell& cell : window(cells_of(line), begin)) {
    const bool inside = cell.offset >= begin && cell.offset < end && cell.shown != "...";
    const auto width = static_cast<std::size_t>(cell.width);
    result.line += cell.shown;
    if (inside && width > 0) {
      result.caret += marked ? std::string(width, '~') : "^" + std::string(width - 1, '~');
      marked = true;
    } else if (!marked && cell.offset < begin) {
      result.caret += std::string(width, ' ');
    } else if (!marked && cell.shown == "...") {
      result.caret += "   ";
    }
  }
  if (!marked) result.caret += "^";
  while (!result.line.empty() && result.line.back() == ' ') result.line.pop_back();
  return result;
}

/// Escape sequences of a terminal, or nothing.
struct Paint {
  Colour colour = Colour::none;
  const char* severity = "";

  std::string bold(const std::string& text) const { return in("\033[1m", text); }
  std::string strong(const std::string& text) const { return in(severity, text); }

 private:
  std::string in(const char* sequence, const std::string& text) const {
    return colour == Colour::none ? text : sequence + text + "\033[0m";
  }
};

std::string coloured_caret(const std::string& caret, const Paint& paint) {
  const std::size_t begin = caret.find_first_not_of(' ');
  return caret.substr(0, begin) + paint.strong(caret.substr(begin));
}

std::string render_one(const Diagnostic& finding, const Source& source, Colour colour) {
  const bool is_error = finding.severity == Severity::error;
  const Paint paint{colour, is_error ? "\033[1;31m" : "\033[1;35m"};
  const Position at = source.position(finding.span.begin);
  const std::uint32_t line_start = source.shown_start(finding.span.begin);
  std::string_view line = source.line_at(finding.span.begin);
  line.remove_prefix(line_start - static_cast<std::uint32_t>(line.data() - source.text().data()));
  const auto inside = [&](std::uint32_t offset) {
    return std::min(std::max(offset, line_start) - line_start, static_cast<std::uint32_t>(line.size()));
  };
  const std::uint32_t begin = inside(finding.span.begin);
  const std::uint32_t end = inside(std::max(finding.span.end, finding.span.begin));
  const Snippet shown = snippet(line, begin, end);

  const std::string number = std::to_string(at.line);
  const std::string margin(number.size(), ' ');
  const std::string place = fmt::format("{}:{}:{}:", harmless(source.name_at(finding.span.begin)), at.line, at.column);
  const std::string kind = fmt::format("{}[{}]:", is_error ? "error" : "warning", finding.code);
  std::string text =
      fmt::format("{} {} {}\n", paint.bold(place), paint.strong(kind), paint.bold(harmless(finding.message)));
  text += fmt::format(" {} | {}\n {} | {}\n", number, shown.line, margin, coloured_caret(shown.caret, paint));
  if (!finding.hint.empty()) text += fmt::format(" {} = {} {}\n", margin, paint.bold("hint:"), harmless(finding.hint));
  return text;
}

}  // namespace

namespace {

/// A message may quote what stands in the file, and that may be of megabytes: its middle is left out.
void shorten(std::string& text) {
  if (text.size() <= k_longest_text) return;
  const auto is_continuation = [&](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  std::size_t begin = k_longest_text / 2;
  std::size_t end = text.size() - k_longest_text / 2;
  while (begin > 0 && is_continuation(begin)) --begin;
  while (is_continuation(end)) ++end;
  text.replace(begin, end - begin, " ... ");
}

}  // namespace

namespace {

constexpr std::size_t k_most_copies_named = 4;

/// Of what a message is about.
std::string first_quoted(const std::string& message) {
  const std::size_t begin = message.find('\'');
  const std::size_t end = begin == std::string::npos ? begin : message.find('\'', begin + 1);
  return end == std::string::npos ? std::string() : message.substr(begin, end - begin + 1);
}

/// A finding with the names of copies of the same entry that have it, too.
struct Shared {
  Diagnostic finding;
  std::vector<std::string> names;  ///< in their order
  std::set<std::string> known;     ///< likewise: there may be thousands

  void add(const Diagnostic& copy) {
    const std::string name = first_quoted(copy.message);
    if (!name.empty() && name != first_quoted(finding.message) && known.insert(name).second) names.push_back(name);
  }

  Diagnostic whole() const {
    Diagnostic result = finding;
    shorten(result.message);
    shorten(result.hint);
    if (names.empty()) return result;
    const std::size_t count = std::min(names.size(), k_most_copies_named);
    const std::vector<std::string> first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count));
    result.message += fmt::format("; likewise {}", fmt::join(first, ", "));
    if (count < names.size()) result.message += fmt::format(" and {} more", names.size() - count);
    return result;
  }
};

std::string without_numbers(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }), text.end());
  return text;
}

}  // namespace

std::vector<Diagnostic> in_order(const Diagnostics& diagnostics, std::size_t& left_out) {
  std::vector<Diagnostic> sorted = diagnostics.all();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
  // Copies of an entry have the same mistakes, up to the indices in their names.
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>, std::size_t> seen;
  std::vector<Shared> shared;
  for (Diagnostic& finding : sorted) {
    const auto [place, is_new] =
        seen.emplace(std::tuple(finding.span.begin, finding.span.end, finding.code, without_numbers(finding.message)),
                     shared.size());
    if (is_new) {
      shared.push_back({std::move(finding), {}, {}});
    } else {
      shared[place->second].add(finding);
    }
  }
  left_out = shared.size() - std::min(shared.size(), k_most_findings);
  shared.resize(shared.size() - left_out);
  std::vector<Diagnostic> result;
  for (const Shared& one : shared) result.push_back(one.whole());
  return result;
}

std::string render(const Diagnostics& diagnostics, const Source& source, Colour colour) {
  std::string text;
  std::size_t left_out = 0;
  for (const Diagnostic& finding : in_order(diagnostics, left_out)) text += render_one(finding, source, colour);
  if (left_out > 0) text += fmt::format("... and {} more findings\n", left_out);
  return text;
}

}  // namespace gaussgen::support
