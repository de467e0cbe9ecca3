#include "sim/interpreter/layout.hpp"

#include <stdexcept>
#include <utility>

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

std::size_t count_of(const Shape& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  return count;
}

void Layout::add(const std::string& member, Shape shape, const std::string& comment) {
  const std::size_t count = count_of(shape);
  places.emplace(member, members.size());
  members.push_back({member, std::move(shape), size, comment});
  size += count;
}

namespace {

bool is_scalar(const std::string& type) { return type == "S" || type == "typename Math<S>::Bool"; }

void add_members(const std::vector<cpp::Member>& members, const std::string& group, const Integers& integers,
                 Layout& layout) {
  for (const cpp::Member& member : members) {
    if (member.type.rfind("static ", 0) == 0) continue;
    if (!is_scalar(member.type)) throw std::invalid_argument("a member of type '" + member.type + "'");
    Shape shape;
    for (const std::string& extent : member.shape) shape.push_back(static_cast<std::size_t>(integers(extent)));
    layout.add(group + member.name, std::move(shape), member.comment);
  }
}

/// `return values[3];`
std::size_t place_of(const cpp::Function& accessor, const Integers& integers, const Layout& layout) {
  const auto* result = accessor.body.size() == 1 ? std::get_if<cpp::Return>(&accessor.body[0]) : nullptr;
  const std::string text = result == nullptr ? std::string() : result->value.text;
  const std::size_t bracket = text.find('[');
  const auto member = layout.places.find(text.substr(0, bracket));
  if (bracket == std::string::npos || member == layout.places.end() || text.back() != ']')
    throw std::invalid_argument("the member function '" + accessor.name + "'");
  const std::string index = text.substr(bracket + 1, text.size() - bracket - 2);
  return layout.members[member->second].offset + static_cast<std::size_t>(integers(index));
}

}  // namespace

Layout layout_of(const cpp::Struct& type, const Integers& integers) {
  Layout layout;
  layout.name = type.name;
  for (const cpp::Struct& nested : type.nested) add_members(nested.members, nested.instance + ".", integers, layout);
  add_members(type.members, "", integers, layout);
  for (const cpp::Function& accessor : type.functions)
    layout.access.emplace(accessor.name, place_of(accessor, integers, layout));
  return layout;
}

Layout layout_of_solution(std::size_t speeds, std::size_t rows) {
  Layout layout;
  layout.name = "LinearSolution";
  layout.add("accelerations", {speeds});
  layout.add("multipliers", {rows});
  layout.add("is_shared", {rows});
  for (const char* const member : {"rank", "motion", "step", "reactions"}) layout.add(member, {});
  return layout;
}

}  // namespace gausssim
