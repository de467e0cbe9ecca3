#include "support/source.hpp"

#include <algorithm>
#include <utility>

namespace gaussgen::support {

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

std::string_view Source::text(Span span) const {
  const std::size_t begin = std::min<std::size_t>(span.begin, text_.size());
  const std::size_t end = std::min<std::size_t>(span.end, text_.size());
  return std::string_view(text_).substr(begin, end > begin ? end - begin : 0);
}

std::uint32_t Source::line(std::uint32_t offset) const {
  return static_cast<std::uint32_t>(std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) -
                                    line_starts_.begin());
}

Position Source::position(std::uint32_t offset) const {
  const std::uint32_t number = line(offset);
  const std::string_view before = text({line_starts_[number - 1], offset});
  // Continuation bytes of UTF-8 (10xxxxxx) do not start a column.
  const auto column = std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return {number, static_cast<std::uint32_t>(column) + 1};
}

std::string_view Source::line_at(std::uint32_t offset) const {
  const std::uint32_t start = line_starts_[line(offset) - 1];
  std::string_view line = std::string_view(text_).substr(std::min<std::size_t>(start, text_.size()));
  line = line.substr(0, line.find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

}  // namespace gaussgen::support
