#include "emit/result_types.hpp"

#include <algorithm>

#include "emit/identifiers.hpp"
#include "emit/names.hpp"
#include "emit/text.hpp"
#include "support/assert.hpp"

namespace gaussgen::emit {

namespace {

template <class Named>
auto find_named(std::vector<Named>& list, const std::string& name) {
  return std::find_if(list.begin(), list.end(), [&](const Named& item) { return item.name == name; });
}

std::string key(const std::string& group, const std::string& field) { return group + "/" + field; }

}  // namespace

ResultTypes::ResultTypes(const Unit& unit) {
  for (const Artefact& artefact : unit.artefacts) {
    if (artefact.result_type.empty()) continue;
    auto type = find_named(types_, artefact.result_type);
    if (type == types_.end()) type = types_.insert(type, Type{artefact.result_type, {}, artefact.constants, {}});
    for (const Group& group : artefact.groups) merge(*type, group);
  }
  for (Type& type : types_) name_members(type);
}

void ResultTypes::merge(Type& type, const Group& group) {
  auto known = find_named(type.groups, group.name);
  if (known == type.groups.end()) {
    type.groups.push_back(group);
    return;
  }
  for (const Field& field : group.fields) {
    const auto same = find_named(known->fields, field.name);
    if (same == known->fields.end()) {
      known->fields.push_back(field);
    } else {
      GAUSS_ASSERT(same->shape == field.shape, "{}.{} has two shapes", group.name, field.name);
    }
  }
}

// Members first, so that the nested types give way.
void ResultTypes::name_members(Type& type) {
  NameScope outer;
  outer.reserve(type.name);
  for (const Constant& constant : type.constants) outer.reserve(constant.name);
  for (const Group& group : type.groups) {
    NameScope inner;
    if (!group.name.empty()) type.texts[group.name] = outer.allocate(group.name);
    NameScope& scope = group.name.empty() ? outer : inner;
    for (const Field& field : group.fields) type.texts[key(group.name, field.name)] = scope.allocate(field.name);
  }
  for (Group& group : type.groups) {
    if (!group.name.empty()) group.type_name = outer.allocate(group.type_name);
  }
}

cpp::Struct ResultTypes::printed(const Type& type) {
  cpp::Struct result;
  result.name = type.name;
  for (const Constant& constant : type.constants)
    result.members.push_back({"static constexpr bool",
                              constant.name,
                              {},
                              cpp::atom(constant.value ? "true" : "false"),
                              comment_text(constant.about)});
  for (const Group& group : type.groups) {
    cpp::Struct nested;
    nested.comment = wrapped(group.about, 100);
    nested.is_template = false;
    nested.name = group.type_name;
    std::vector<cpp::Member>& members = group.name.empty() ? result.members : nested.members;
    for (const Field& field : group.fields) {
      std::vector<std::string> shape;
      for (const int size : field.shape) shape.push_back(std::to_string(size));
      members.push_back(
          {"S", type.texts.at(key(group.name, field.name)), shape, std::nullopt, comment_text(field.about)});
    }
    if (group.name.empty()) continue;
    nested.instance = type.texts.at(group.name);
    result.nested.push_back(std::move(nested));
  }
  return result;
}

std::vector<cpp::Struct> ResultTypes::structs() const {
  std::vector<cpp::Struct> result;
  for (const Type& type : types_) result.push_back(printed(type));
  return result;
}

std::string ResultTypes::path(const std::string& result_type, const std::string& group,
                              const std::string& field) const {
  const auto type =
      std::find_if(types_.begin(), types_.end(), [&](const Type& item) { return item.name == result_type; });
  std::string text = snake_case(result_type);
  if (!group.empty()) text += "." + type->texts.at(group);
  return text + "." + type->texts.at(key(group, field));
}

}  // namespace gaussgen::emit
