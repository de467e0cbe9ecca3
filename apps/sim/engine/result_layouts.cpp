#include "sim/engine/result_layouts.hpp"

#include <algorithm>
#include <string>

#include "sim/model/layout.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

/// How many slots there are if there is none of this name.
std::size_t place_of(const std::vector<ResultNumber>& slots, const std::string& name) {
  const auto found =
      std::find_if(slots.begin(), slots.end(), [&](const ResultNumber& slot) { return slot.name == name; });
  return static_cast<std::size_t>(found - slots.begin());
}

const cpp::Member* find_member(const cpp::Struct& type, const std::string& name) {
  const auto found = std::find_if(type.members.begin(), type.members.end(),
                                  [&](const cpp::Member& member) { return member.name == name; });
  return found == type.members.end() || !found->value ? nullptr : &*found;
}

/// The values of a table of whole numbers.
std::vector<std::size_t> table(const cpp::Struct& type, const std::string& name) {
  std::vector<std::size_t> values;
  const cpp::Member* const member = find_member(type, name);
  if (member == nullptr) return values;
  for (const cpp::Expression& item : member->value->operands) values.push_back(std::stoul(item.text));
  return values;
}

}  // namespace

EnergyLayout energy_layout_of(const cpp::File& tree) {
  const std::vector<ResultNumber> slots = layout_of(tree, "Energy");
  EnergyLayout layout;
  layout.kinetic = place_of(slots, "kinetic");
  layout.total = place_of(slots, "total");
  if (layout.kinetic == slots.size() || layout.total == slots.size()) return {};
  layout.size = slots.size();
  const cpp::Member* const constant = find_member(*find_struct(tree, "Energy"), "is_conserved");
  layout.is_conserved = constant != nullptr && constant->value->text == "true";
  return layout;
}

JacobianLayout jacobian_layout_of(const cpp::File& tree) {
  const std::vector<ResultNumber> slots = layout_of(tree, "Jacobian");
  const cpp::Struct* const pattern = find_struct(tree, "JacobianByState");
  JacobianLayout layout;
  layout.first = place_of(slots, "by_state[0]");
  if (pattern == nullptr || layout.first == slots.size()) return {};
  layout.size = slots.size();
  layout.row_begin = table(*pattern, "row_begin");
  layout.column = table(*pattern, "column");
  return layout;
}

}  // namespace gausssim
