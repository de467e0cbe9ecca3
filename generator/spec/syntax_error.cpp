#include "spec/syntax_error.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "spec/foreign_space.hpp"
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

/// Where the text of a line begins.
std::uint32_t text_begin(const support::Source& source, std::uint32_t offset) {
  const std::string_view line = source.line_at(offset);
  return begin_of(source, line) + static_cast<std::uint32_t>(std::min(line.find_first_not_of(' '), line.size()));
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

/// Walks over the brackets of the file, past comments and quoted texts.
class BracketWalk {
 public:
  explicit BracketWalk(const support::Source& source) : source_(source), text_(source.text()) {}

  /// If some bracket before `end` is never closed: the one that is open where a line begins that is indented no deeper
  /// than its own, or else the last.
  std::optional<std::uint32_t> never_closed(std::uint32_t end) {
    std::optional<std::uint32_t> found;
    while (at_ < text_.size()) {
      if (is_at_line_start() && !found && !open_.empty() && is_dedented()) found = open_.back();
      step();
    }
    if (open_.empty() || is_mixed_up_) return std::nullopt;
    if (found) return *found < end ? found : std::nullopt;
    const auto behind = std::lower_bound(open_.begin(), open_.end(), end);
    return behind == open_.begin() ? std::nullopt : std::optional(*std::prev(behind));
  }

 private:
  void step() {
    const char c = text_[at_];
    const char before = at_ == 0 ? '\n' : text_[at_ - 1];
    const bool begins_word = std::string_view(" \n[{,:").find(before) != std::string_view::npos;
    if (c == '#' && (before == ' ' || before == '\n')) return skip_to('\n');
    if ((c == '"' || c == '\'') && begins_word) return skip_quoted(c);
    const bool opens = c == '{' || c == '[';
    if (opens && (begins_word || !open_.empty())) open_.push_back(static_cast<std::uint32_t>(at_));
    if ((c == '}' || c == ']') && !open_.empty()) close(c);
    ++at_;
  }

  void close(char c) {
    is_mixed_up_ = is_mixed_up_ || (text_[open_.back()] == '{') != (c == '}');
    open_.pop_back();
  }

  void skip_to(char end) { at_ = std::min(text_.find(end, at_ + 1), text_.size()); }

  void skip_quoted(char quote) {
    do {
      skip_to(quote);
    } while (quote == '"' && at_ < text_.size() && text_[at_ - 1] == '\\');
    if (at_ < text_.size()) ++at_;
  }

  bool is_at_line_start() const { return at_ == 0 || text_[at_ - 1] == '\n'; }

  static std::size_t indentation(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

  bool is_dedented() const {
    const std::string_view line = source_.line_at(static_cast<std::uint32_t>(at_));
    const std::size_t first = indentation(line);
    if (first == line.size() || std::string_view("#\r}]").find(line[first]) != std::string_view::npos) return false;
    return first <= indentation(source_.line_at(open_.back()));
  }

  const support::Source& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::uint32_t> open_;
  bool is_mixed_up_ = false;  ///< a '}' stands where ']' is due, or the other way round
};

/// a: {mass: 1, position: [x, 0, 0] and then the next line: YAML notices it there.
std::optional<Finding> open_bracket(const support::Source& source, std::uint32_t offset) {
  const auto bracket = BracketWalk(source).never_closed(offset);
  if (!bracket) return std::nullopt;
  const bool is_map = source.text()[*bracket] == '{';
  return Finding{{*bracket, *bracket + 1},
                 is_map ? "this '{' is never closed" : "this '[' is never closed",
                 is_map ? "add the missing '}'" : "add the missing ']'"};
}

/// What people mean where YAML says something else.
std::optional<Finding> likely_slip(const support::Source& source, std::uint32_t offset, const std::string& text) {
  if (offset >= source.text().size()) return std::nullopt;
  if (text.find("end of map not found") != std::string::npos) return text_behind_end(source, offset);
  if (text.find("end of map flow") != std::string::npos) return key_without_comma(source, offset);
  if (text.find("illegal map value") != std::string::npos) return line_without_colon(source, offset);
  return std::nullopt;
}

/// In the line of the error, or in the one before it, which YAML read without its ':'.
bool refuse_space_behind_key_near(const support::Source& source, std::uint32_t offset,
                                  support::Diagnostics& diagnostics) {
  const std::uint32_t line = begin_of(source, source.line_at(offset));
  return refuse_space_behind_key(source, text_begin(source, offset), diagnostics) ||
         (line > 0 && refuse_space_behind_key(source, text_begin(source, line - 1), diagnostics));
}

}  // namespace

bool report_open_bracket(const support::Source& source, std::uint32_t offset, support::Diagnostics& diagnostics) {
  const auto bracket = open_bracket(source, offset);
  if (bracket) diagnostics.error(code::k_yaml_syntax, bracket->span, bracket->message, bracket->hint);
  return bracket.has_value();
}

void report_syntax_error(const support::Source& source, std::uint32_t offset, const std::string& text,
                         support::Diagnostics& diagnostics) {
  const Span here{offset, offset + 1};
  if (const auto tab = tab_near(source, offset)) {
    diagnostics.error(code::k_tab_indentation, {*tab, *tab + 1}, "a tab in the indentation",
                      "YAML indents with spaces only");
    return;
  }
  if (refuse_foreign_space(source, text_begin(source, offset), diagnostics)) return;
  if (refuse_space_behind_key_near(source, offset, diagnostics)) return;
  if (report_open_bracket(source, offset, diagnostics)) return;
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
