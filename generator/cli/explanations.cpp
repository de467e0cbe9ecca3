#include "cli/explanations.hpp"

#include <algorithm>
#include <iterator>

#include "support/assert.hpp"

namespace gaussgen::cli {

namespace {

constexpr std::string_view k_example = "\nexample:";

/// Bytes for \xHH.
std::string unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const bool is_escape = text.size() >= 4 && text.substr(0, 2) == "\\x";
    result += is_escape ? static_cast<char>(std::stoi(std::string(text.substr(2, 2)), nullptr, 16)) : text[0];
    text.remove_prefix(is_escape ? 4 : 1);
  }
  return result;
}

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

/// The lines without the marks; those that begin with `other` are left out.
std::string version_of(std::string_view example, char other) {
  std::string text;
  while (!example.empty()) {
    const std::string_view line = first_line(example);
    if (!line.empty() && line[0] != other) text += unescaped(line.substr(2)) + "\n";
    example.remove_prefix(std::min(line.size() + 1, example.size()));
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\n')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

}  // namespace

std::vector<support::ErrorCode> all_codes() {
  std::vector<support::ErrorCode> codes(std::begin(support::k_all_codes), std::end(support::k_all_codes));
  codes.insert(codes.end(), std::begin(support::k_stage_codes), std::end(support::k_stage_codes));
  std::sort(codes.begin(), codes.end(),
            [](const auto& a, const auto& b) { return std::string_view(a.id) < std::string_view(b.id); });
  return codes;
}

Explanation explanation_of(const Page& page) {
  const std::string_view text = page.text;
  const std::size_t mark = text.find(k_example);
  GAUSS_ASSERT(mark != std::string_view::npos, page.code);
  const std::string_view after = text.substr(mark + k_example.size());
  const std::string_view options = first_line(after);
  const std::string_view example = after.substr(options.size() + 1);
  return {std::string(trimmed(text.substr(0, mark))), std::string(trimmed(options)), std::string(example),
          version_of(example, '+'), version_of(example, '-')};
}

}  // namespace gaussgen::cli
