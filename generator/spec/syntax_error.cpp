#include "spec/syntax_error.hpp"

#include <optional>
#include <string_view>

#include "support/error_codes.hpp"

namespace gaussgen::spec {

namespace code = support::code;
using support::Span;

namespace {

struct Wording {
  const char* theirs;
  const char* ours;
  const char* hint;
};

// The left column is a part of yaml-cpp 0.7's text.
constexpr Wording k_wordings[] = {
    {"anchor is not defined", "aliases (*name) are not part of the model format",
     "write the value itself; a text that begins with '*' needs quotes"},
    {"illegal map value", "a ':' that YAML cannot take for the end of a key here",
     "check the indentation; quote a text that contains ': '"},
    {"illegal block entry", "a '- ' that YAML cannot take for a list item here",
     "write '-x' without a blank, or quote the expression"},
    {"illegal flow end", "a bracket that closes nothing, or the wrong bracket", "check '[' with ']' and '{' with '}'"},
    {"end of sequence flow", "a '[' is never closed", "add the missing ']'"},
    {"end of map flow", "a '{' is never closed", "add the missing '}'"},
    {"end of map not found", "the map ends here, but the text goes on", "check the indentation of this line"},
    {"end of sequence not found", "the list ends here, but the text goes on", "check the indentation of this line"},
    {"unknown token", "a character that cannot begin a value", "quote the text"},
    {"unknown escape", "an escape that YAML does not know", "use single quotes, in which '\\' has no meaning"},
    {"bad character", "a character that does not belong here", "quote the text"},
    {"anchor", "anchors (&name) are not part of the model format", "quote a text that begins with '&'"},
    {"alias", "aliases (*name) are not part of the model format", "quote a text that begins with '*'"},
    {"tag", "tags (!name) are not part of the model format", "quote a text that begins with '!'"},
    {"directive", "directives (%...) are not part of the model format", "remove the line"},
};

bool is_tab_indented(std::string_view line) {
  const std::size_t text = line.find_first_not_of(" \t");
  return text != std::string_view::npos && line.substr(0, text).find('\t') != std::string_view::npos;
}

/// The tab that misled YAML: in the indentation of the line of the error or of one just before it.
std::optional<std::uint32_t> tab_near(const support::Source& source, std::uint32_t offset) {
  std::uint32_t at = offset;
  for (int lines = 0; lines < 3; ++lines) {
    const std::string_view line = source.line_at(at);
    const auto start = static_cast<std::uint32_t>(line.data() - source.text().data());
    if (is_tab_indented(line)) return start + static_cast<std::uint32_t>(line.find('\t'));
    if (start == 0) break;
    at = start - 1;
  }
  return std::nullopt;
}

struct Finding {
  Span span;
  const char* message;
  const char* hint;
};

std::uint32_t begin_of(const support::Source& source, std::string_view line) {
  return static_cast<std::uint32_t>(line.data() - source.text().data());
}

/// about: 'the ball's mass', and x: {} free
std::optional<Finding> text_behind_end(const support::Source& source, std::uint32_t offset) {
  const std::string_view line = source.line_at(offset);
  const std::string_view before = line.substr(0, offset - begin_of(source, line));
  const std::size_t last = before.find_last_not_of(' ');
  const Span here{offset, offset + 1};
  switch (last == std::string_view::npos ? ' ' : before[last]) {
    case '"':
      return Finding{here, "the quoted text ends before this, but the line goes on",
                     "inside \"...\" a quotation mark is written \\\""};
    case '\'':
      return Finding{here, "the quoted text ends before this, but the line goes on",
                     "inside '...' an apostrophe is written twice: ''"};
    case '}':
    case ']':
      return Finding{here, "text behind a closing bracket",
                     "remove it; a text or an expression that begins with '{' or '[' needs quotes"};
    default: return std::nullopt;
  }
}

/// {mass: 1 position: [x, 0, 0]}: what comes before a second ':' is a key.
std::optional<Finding> key_without_comma(const support::Source& source, std::uint32_t offset) {
  const std::string_view line = source.line_at(offset);
  const std::string_view before = line.substr(0, offset - begin_of(source, line));
  if (source.text().substr(offset, 1) != ":" || before.find('{') == std::string_view::npos) return std::nullopt;
  const std::size_t blank = before.find_last_of(" {,");
  const auto key = static_cast<std::uint32_t>(begin_of(source, line) + blank + 1);
  if (key == offset) return std::nullopt;
  return Finding{{key, offset},
                 "a ',' is missing before this key, or a '}'",
                 "commas stand between the entries of {...}; quote a text that contains ': '"};
}

/// "k 3" or "k = 3" before a line that is right: to YAML it belongs to the text before it.
std::optional<Finding> line_without_colon(const support::Source& source, std::uint32_t offset) {
  std::uint32_t at = begin_of(source, source.line_at(offset));
  while (at > 0) {
    const std::string_view line = source.line_at(at - 1);
    at = begin_of(source, line);
    const std::size_t first = line.find_first_not_of(" \r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (line.find_first_of(":[]{}-'\"") != std::string_view::npos) return std::nullopt;
    const std::size_t last = line.find_last_not_of(" \r");
    return Finding{{at + static_cast<std::uint32_t>(first), at + static_cast<std::uint32_t>(last) + 1},
                   "a key without ':'",
                   "write 'key: value'"};
  }
  return std::nullopt;
}

/// What people mean where YAML says something else.
std::optional<Finding> likely_slip(const support::Source& source, std::uint32_t offset, const std::string& text) {
  if (offset >= source.text().size()) return std::nullopt;
  if (text.find("end of map not found") != std::string::npos) return text_behind_end(source, offset);
  if (text.find("end of map flow") != std::string::npos) return key_without_comma(source, offset);
  if (text.find("illegal map value") != std::string::npos) return line_without_colon(source, offset);
  return std::nullopt;
}

}  // namespace

void report_syntax_error(const support::Source& source, std::uint32_t offset, const std::string& text,
                         support::Diagnostics& diagnostics) {
  const Span here{offset, offset + 1};
  if (const auto tab = tab_near(source, offset)) {
    diagnostics.error(code::k_tab_indentation, {*tab, *tab + 1}, "a tab in the indentation",
                      "YAML indents with spaces only");
    return;
  }
  if (const auto slip = likely_slip(source, offset, text)) {
    diagnostics.error(code::k_yaml_syntax, slip->span, slip->message, slip->hint);
    return;
  }
  for (const Wording& wording : k_wordings) {
    if (text.find(wording.theirs) == std::string::npos) continue;
    const bool about_feature = std::string_view(wording.ours).find("not part of") != std::string_view::npos;
    diagnostics.error(about_feature ? code::k_yaml_feature : code::k_yaml_syntax, here, wording.ours, wording.hint);
    return;
  }
  diagnostics.error(code::k_yaml_syntax, here, "the text is not valid YAML (" + text + ")",
                    "check indentation, brackets and quotes");
}

}  // namespace gaussgen::spec
