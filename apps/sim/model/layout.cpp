#include "sim/model/layout.hpp"

#include <variant>

#include "description.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

/// What stands behind a name for each entry of an array: [0][0], [0][1], …; one empty text for a scalar.
std::vector<std::string> indices_of(const std::vector<std::string>& shape) {
  std::vector<std::string> indices{""};
  for (const std::string& length : shape) {
    std::vector<std::string> longer;
    for (const std::string& begun : indices) {
      for (int i = 0; i < std::stoi(length); ++i) longer.push_back(begun + "[" + std::to_string(i) + "]");
    }
    indices = std::move(longer);
  }
  return indices;
}

void add(const cpp::Struct& type, const std::string& prefix, std::vector<ResultNumber>& slots) {
  for (const cpp::Struct& nested : type.nested) add(nested, prefix + nested.instance + ".", slots);
  gaussgen::emit::Group group;
  group.about = prefix.empty() ? "" : type.comment;
  for (const cpp::Member& member : type.members) {
    if (member.type != "S") continue;  // what is known when code is generated
    gaussgen::emit::Field field;
    field.about = member.comment;
    const gaussgen::Description description = gaussgen::describe(group, field);
    for (const std::string& index : indices_of(member.shape))
      slots.push_back({prefix + member.name + index, description.unit, description.about});
  }
}

template <class Item>
const Item* find(const cpp::File& tree, const std::string& name) {
  for (const cpp::Item& item : tree.items) {
    const auto* const found = std::get_if<Item>(&item);
    if (found != nullptr && found->name == name) return found;
  }
  return nullptr;
}

}  // namespace

const cpp::Struct* find_struct(const cpp::File& tree, const std::string& type) { return find<cpp::Struct>(tree, type); }

const cpp::Function* find_function(const cpp::File& tree, const std::string& name) {
  return find<cpp::Function>(tree, name);
}

std::vector<ResultNumber> layout_of(const cpp::File& tree, const std::string& type) {
  std::vector<ResultNumber> slots;
  if (const cpp::Struct* const found = find_struct(tree, type)) add(*found, "", slots);
  return slots;
}

}  // namespace gausssim
