#include "spec/align.hpp"

#include <utility>

#include "support/utf8.hpp"

namespace gaussgen::spec {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Walks the source beside the decoded text. Letters must match one by one; white space is only
/// followed loosely, because folding and indentation change it and no error ever points at it.
class Walker {
 public:
  Walker(std::string_view source, std::uint32_t begin, ScalarStyle style) : source_(source), at_(begin), style_(style) {
    if (style_ == ScalarStyle::single_quoted || style_ == ScalarStyle::double_quoted) ++at_;
    if (style_ == ScalarStyle::block) skip_header();
  }

  std::uint32_t at() const { return at_; }

  /// The origin of the decoded character that begins with `c`.
  std::uint32_t step(char c) {
    if (style_ == ScalarStyle::double_quoted) skip_joined_lines();
    if (!is_blank(c)) skip_blanks();
    const std::uint32_t here = at_;
    if (at_ >= source_.size()) return here;
    if (style_ == ScalarStyle::double_quoted && source_[at_] == '\\') {
      skip_escape();
    } else if (is_blank(c)) {
      if (is_blank(source_[at_])) ++at_;
    } else {
      at_ += support::code_point_at(source_, at_).size;
      if (style_ == ScalarStyle::single_quoted && c == '\'') ++at_;
    }
    return here;
  }

  void close_quote() {
    const char quote = style_ == ScalarStyle::double_quoted ? '"' : '\'';
    while (at_ < source_.size() && source_[at_] != quote) ++at_;
    if (at_ < source_.size()) ++at_;
  }

 private:
  void skip_header() {
    while (at_ < source_.size() && source_[at_] != '\n') ++at_;
  }

  void skip_blanks() {
    while (at_ < source_.size() && is_blank(source_[at_])) ++at_;
    if (style_ == ScalarStyle::double_quoted) skip_joined_lines();
  }

  /// A backslash at the end of a line joins it to the next one and leaves nothing in the text.
  void skip_joined_lines() {
    while (at_ + 1 < source_.size() && source_[at_] == '\\' && (source_[at_ + 1] == '\n' || source_[at_ + 1] == '\r')) {
      ++at_;
      while (at_ < source_.size() && is_blank(source_[at_])) ++at_;
    }
  }

  void skip_escape() {
    const char kind = at_ + 1 < source_.size() ? source_[at_ + 1] : '\0';
    at_ += kind == 'x' ? 4 : kind == 'u' ? 6 : kind == 'U' ? 10 : 2;
  }

  std::string_view source_;
  std::uint32_t at_;
  ScalarStyle style_;
};

}  // namespace

ScalarStyle style_at(std::string_view source, std::uint32_t begin, bool quoted) {
  if (!quoted || begin >= source.size()) return ScalarStyle::plain;
  switch (source[begin]) {
    case '\'': return ScalarStyle::single_quoted;
    case '"': return ScalarStyle::double_quoted;
    case '|':
    case '>': return ScalarStyle::block;
    default: return ScalarStyle::plain;
  }
}

LocatedText align(std::string value, std::string_view source, std::uint32_t begin, ScalarStyle style) {
  LocatedText result;
  Walker walker(source, begin, style);
  for (std::size_t i = 0; i < value.size();) {
    const std::uint32_t origin = walker.step(value[i]);
    const std::uint32_t size = support::code_point_at(value, i).size;
    result.origin.insert(result.origin.end(), size, origin);
    i += size;
  }
  if (style == ScalarStyle::single_quoted || style == ScalarStyle::double_quoted) walker.close_quote();
  result.span = {begin, walker.at()};
  result.text = std::move(value);
  return result;
}

bool quote_is_closed(std::string_view source, std::uint32_t begin, ScalarStyle style) {
  const char quote = style == ScalarStyle::double_quoted ? '"' : '\'';
  for (std::size_t i = begin + 1; i < source.size(); ++i) {
    if (style == ScalarStyle::double_quoted && source[i] == '\\') {
      ++i;
    } else if (source[i] == quote) {
      const bool doubled = style == ScalarStyle::single_quoted && i + 1 < source.size() && source[i + 1] == quote;
      if (!doubled) return true;
      ++i;
    }
  }
  return false;
}

}  // namespace gaussgen::spec
