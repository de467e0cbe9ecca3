#include "mutation.hpp"

#include <algorithm>
#include <cctype>

namespace fuzz {

namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

/// Values that numbers and expressions trip over.
const std::vector<std::string> k_values = {
    "0",     "-1",   "1e308",    "1e-308",    "1e999",   "x",    "dot(x)",    "t",
    "pi",    "1/0",  "sqrt(-1)", "x/(y - y)", "x^(1/2)", "x^64", "min(x, y)", "piecewise(x > 0, x, 0)",
    "[]",    "{}",   "[x, y]",   "[0, 0, 0]", "~",       "\"\"", "abs(x)",    "log(x)",
    "space", "body", "tip.x"};

}  // namespace

std::vector<Mutation::Range> Mutation::lines(const std::string& text) {
  std::vector<Range> found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    found.push_back({begin, end});
    begin = end;
  }
  return found;
}

/// What stands behind a colon and a blank, or between commas or brackets.
std::vector<Mutation::Range> Mutation::values(const std::string& text) {
  std::vector<Range> found;
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool begins = (text[at] == ':' && text[at + 1] == ' ') || text[at] == '[' || text[at] == ',';
    if (!begins) continue;
    const std::size_t begin = std::min(text.find_first_not_of(": [,", at), text.size());
    int depth = 0;
    std::size_t end = begin;
    for (; end < text.size() && text[end] != '\n'; ++end) {
      const char c = text[end];
      depth += c == '(' || c == '[' || c == '{' ? 1 : 0;
      const bool closes = c == ')' || c == ']' || c == '}';
      if (depth == 0 && (closes || c == ',')) break;
      depth -= closes ? 1 : 0;
    }
    if (end > begin) found.push_back({begin, end});
  }
  return found;
}

/// Names, numbers and single other characters.
std::vector<Mutation::Range> Mutation::tokens(const std::string& text) {
  std::vector<Range> found;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin + 1;
    while (is_of_name(text[begin]) && end < text.size() && is_of_name(text[end])) ++end;
    if (text[begin] != ' ' && text[begin] != '\n') found.push_back({begin, end});
    begin = end;
  }
  return found;
}

Mutation& Mutation::with(const std::string& donor) {
  const std::string unchanged = donor;
  for (std::size_t i = below(3) + 1; i > 0; --i) change(unchanged);
  return *this;
}

void Mutation::change(const std::string& donor) {
  const auto piece = [&](const std::vector<Range>& ranges) {
    const Range range = any_of(ranges);
    return donor.substr(range.begin, range.end - range.begin);
  };
  const Range line = any_of(lines(text_));
  switch (below(8)) {
    case 0: return put(line, "");
    case 1: return put({line.begin, line.begin}, piece(lines(donor)));
    case 2: return put(line, piece(lines(donor)));
    case 3: return put(any_of(values(text_)), k_values[below(k_values.size())]);
    case 4:
    case 5: return put(any_of(values(text_)), piece(values(donor)));
    default: return put(any_of(tokens(text_)), piece(tokens(donor)));
  }
}

std::size_t Mutation::copied_to(std::uint8_t* out, std::size_t most) const {
  const std::size_t size = std::min(text_.size(), most);
  std::copy_n(text_.begin(), size, out);
  return size;
}

}  // namespace fuzz
