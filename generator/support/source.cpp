#include "support/source.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gaussgen::support {

Source::Source(std::string name, std::string text, ReadFile read) : read_(std::move(read)) {
  add(std::move(name), text);
}

std::optional<std::string> Source::read(const std::string& path, std::string& why) const {
  if (read_) return read_(path, why);
  why = "no other files are read here";
  return std::nullopt;
}

std::uint32_t Source::add(std::string name, const std::string& text) {
  for (const File& file : files_) {
    if (file.name == name) return file.begin;
  }
  // A file begins on a line of its own, whatever the one before ends with.
  if (!files_.empty()) text_ += '\n';
  const auto begin = static_cast<std::uint32_t>(text_.size());
  files_.push_back({std::move(name), begin, static_cast<std::uint32_t>(line_starts_.size())});
  line_starts_.push_back(begin);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(begin + static_cast<std::uint32_t>(i + 1));
  }
  text_ += text;
  return begin;
}

Source Source::first() const {
  const std::size_t end = files_.size() > 1 ? files_[1].begin - 1 : text_.size();
  return {name(), text_.substr(0, end)};
}

std::vector<std::string> Source::names() const {
  std::vector<std::string> names;
  for (const File& file : files_) names.push_back(file.name);
  return names;
}

std::string_view Source::text(Span span) const {
  const std::size_t begin = std::min<std::size_t>(span.begin, text_.size());
  const std::size_t end = std::min<std::size_t>(span.end, text_.size());
  return std::string_view(text_).substr(begin, end > begin ? end - begin : 0);
}

const Source::File& Source::file_at(std::uint32_t offset) const {
  const auto after = std::upper_bound(files_.begin(), files_.end(), offset,
                                      [](std::uint32_t at, const File& file) { return at < file.begin; });
  return *std::prev(after);
}

std::uint32_t Source::line_index(std::uint32_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return static_cast<std::uint32_t>(after - line_starts_.begin()) - 1;
}

std::uint32_t Source::line(std::uint32_t offset) const { return line_index(offset) - file_at(offset).first_line + 1; }

std::string Source::line_text(std::uint32_t offset) const {
  const File& file = file_at(offset);
  return "line " + std::to_string(line(offset)) + (&file == &files_.front() ? "" : " of " + file.name);
}

Position Source::position(std::uint32_t offset) const {
  const std::string_view before = text({shown_start(offset), offset});
  // Continuation bytes of UTF-8 (10xxxxxx) do not start a column.
  const auto column = std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return {line(offset), static_cast<std::uint32_t>(column) + 1};
}

std::uint32_t Source::shown_start(std::uint32_t offset) const {
  const std::uint32_t start = line_starts_[line_index(offset)];
  const bool has_mark = start == file_at(offset).begin && text({start, start + 3}) == "\xEF\xBB\xBF";
  return has_mark ? start + 3 : start;
}

std::string_view Source::line_at(std::uint32_t offset) const {
  const std::uint32_t start = line_starts_[line_index(offset)];
  std::string_view line = std::string_view(text_).substr(std::min<std::size_t>(start, text_.size()));
  line = line.substr(0, line.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

}  // namespace gaussgen::support
