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

}  // namespace

void report_syntax_error(const support::Source& source, std::uint32_t offset, const std::string& text,
                         support::Diagnostics& diagnostics) {
  const Span here{offset, offset + 1};
  if (const auto tab = tab_near(source, offset)) {
    diagnostics.error(code::k_tab_indentation, {*tab, *tab + 1}, "a tab in the indentation",
                      "YAML indents with spaces only");
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
