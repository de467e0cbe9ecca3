#pragma once
// A model text with positions: every later stage refers to it by byte spans only.

#include <cstdint>
#include <functional>
#include <optional>
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

/// The text of the file at a path; nothing, with the reason in `why`, where it cannot be read.
using ReadFile = std::function<std::optional<std::string>(const std::string& path, std::string& why)>;

/// The text of a model file and its name as the user typed it; files that it includes stand behind it, so that a byte offset
/// says which file it is in.
class Source {
 public:
  /// Without `read` it stays alone.
  Source(std::string name, std::string text, ReadFile read = nullptr);

  /// The text of another file, which `add` puts behind.
  std::optional<std::string> read(const std::string& path, std::string& why) const;

  /// The offset of its first byte; a file that is there already is not put behind again.
  std::uint32_t add(std::string name, const std::string& text);

  const std::string& name() const { return files_.front().name; }
  const std::string& name_at(std::uint32_t offset) const { return file_at(offset).name; }
  std::vector<std::string> names() const;

  /// Of all files.
  std::string_view text() const { return text_; }
  /// The first one alone; its offsets are the same.
  Source first() const;
  std::string_view text(Span span) const;

  /// In its file.
  Position position(std::uint32_t offset) const;
  std::uint32_t offset_in_file(std::uint32_t offset) const { return offset - file_at(offset).begin; }

  /// Cheaper than `position` where a line is very long.
  std::uint32_t line(std::uint32_t offset) const;

  /// "line 7", and of another file than the first "line 7 of leg.yaml".
  std::string line_text(std::uint32_t offset) const;

  /// The line that holds `offset`, without its line break.
  std::string_view line_at(std::uint32_t offset) const;

  /// Where the line that holds `offset` begins for people, to whom a byte order mark is nothing.
  std::uint32_t shown_start(std::uint32_t offset) const;

 private:
  struct File {
    std::string name;
    std::uint32_t begin = 0;
    std::uint32_t first_line = 0;  ///< index into line_starts_
  };

  const File& file_at(std::uint32_t offset) const;
  /// Index into line_starts_.
  std::uint32_t line_index(std::uint32_t offset) const;

  ReadFile read_;
  std::string text_;
  std::vector<File> files_;
  std::vector<std::uint32_t> line_starts_;
};

}  // namespace gaussgen::support
