#pragma once
// A model text with positions: every later stage refers to it by byte spans only.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gaussgen::support {

/// Half-open byte range [begin, end) in one Source.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(Span a, Span b) { return a.begin == b.begin && a.end == b.end; }
};

/// Line and column as people count them: both from 1, columns in code points.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// The text of a model file and its name as the user typed it.
class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  std::string_view text(Span span) const;

  Position position(std::uint32_t offset) const;

  /// Cheaper than `position` where a line is very long.
  std::uint32_t line(std::uint32_t offset) const;

  /// The line that holds `offset`, without its line break.
  std::string_view line_at(std::uint32_t offset) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

}  // namespace gaussgen::support
