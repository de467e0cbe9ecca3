#include "sim/interpreter/place.hpp"

#include <stdexcept>
#include <string>

namespace gausssim {

namespace {

bool is_in_name(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Takes a name off the front.
std::string_view name_at(std::string_view& rest) {
  std::size_t end = 0;
  while (end < rest.size() && is_in_name(rest[end])) ++end;
  const std::string_view name = rest.substr(0, end);
  rest.remove_prefix(end);
  return name;
}

/// Takes [index] off the front.
std::string_view index_at(std::string_view& rest) {
  const std::size_t end = rest.find(']');
  if (end == std::string_view::npos) return {};
  const std::string_view index = rest.substr(1, end - 1);
  rest.remove_prefix(end + 1);
  return index;
}

}  // namespace

Place place_of(std::string_view text) {
  std::string_view rest = text;
  Place place;
  place.object = name_at(rest);
  const std::string_view behind = rest;
  while (!rest.empty() && rest.front() == '.') {
    rest.remove_prefix(1);
    (void)name_at(rest);
  }
  if (behind.size() > rest.size()) place.member = behind.substr(1, behind.size() - rest.size() - 1);
  if (rest == "()") {
    place.is_access = true;
    rest = {};
  }
  while (!rest.empty() && rest.front() == '[') {
    const std::string_view index = index_at(rest);
    if (index.empty()) break;
    place.indices.push_back(index);
  }
  if (place.object.empty() || !rest.empty())
    throw std::invalid_argument("'" + std::string(text) + "' is no name of a value");
  return place;
}

}  // namespace gausssim
