#include "description.hpp"

#include <algorithm>

namespace gaussgen {

namespace {

/// "R of (3.8) [N], positive along x" → "N", "R of (3.8), positive along x"
Description taken_apart(const std::string& text) {
  const std::size_t begin = text.find('[');
  const std::size_t end = text.find(']', begin);
  if (begin == std::string::npos || end == std::string::npos) return {"", text};
  const std::string unit = text.substr(begin + 1, end - begin - 1);
  const std::string after = text.substr(end + 1);
  // The blank before the unit goes with it; at the beginning, the comma behind it.
  if (begin > 0) return {unit, text.substr(0, begin - 1) + after};
  return {unit, after.substr(std::min(after.find_first_not_of(", "), after.size()))};
}

}  // namespace

Description describe(const emit::Group& group, const emit::Field& field) {
  Description result = taken_apart(field.about);
  const bool are_both = !group.about.empty() && !result.about.empty();
  result.about = group.about + (are_both ? "; " : "") + result.about;
  return result;
}

std::string generalized_unit(const std::string& unit) {
  if (unit == "m" || unit == "m/s") return "N";
  for (const char* const turn : {"rad", "1", "rad/s", "1/s"}) {
    if (unit == turn) return "N*m";
  }
  return "";
}

std::string on_one_line(std::string about) {
  std::replace(about.begin(), about.end(), '\n', ' ');
  return about;
}

}  // namespace gaussgen
