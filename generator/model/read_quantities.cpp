// quantities: `height: tip.z`, `tip: [tip.x, tip.y, tip.z]` or `height: {value: tip.z, unit: m, about: …}`.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"

namespace gaussgen::model {

using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

std::vector<Ast> read_values(const Node& node, support::Span owner, const std::string& where, Reading& reading) {
  std::vector<Ast> values;
  if (node.kind != NodeKind::sequence) {
    values.push_back(read_expression(node, owner, reading));
    return values;
  }
  for (Ast& component : read_vector(node, owner, where, reading)) values.push_back(std::move(component));
  return values;
}

void read_quantity(const Entry& entry, Reading& reading) {
  NamedQuantity quantity;
  quantity.name = name_of(entry.key);
  check_name(quantity.name, reading);
  const std::string where = fmt::format("quantity '{}'", entry.key.text);
  const Node* value = &entry.value;
  if (entry.value.kind == NodeKind::map) {
    check_keys(entry.value, where, format::keys_of(format::quantity()), reading);
    value = required(entry.value, "value", entry.key.span, where, reading);
    read_unit(entry.value, quantity, reading);
    quantity.about = text_field(entry.value, "about", reading);
  }
  if (value == nullptr) {
    quantity.values.push_back(broken_expression());
  } else {
    quantity.values = read_values(*value, entry.key.span, where, reading);
  }
  reading.model.quantities.push_back(std::move(quantity));
}

}  // namespace

void read_quantities(const Node& root, Reading& reading) {
  // A vector that grows would copy all expressions: numbers of CLN have no move that cannot throw.
  if (const Node* section = spec::find(root, "quantities")) reading.model.quantities.reserve(section->entries.size());
  read_section(root, "quantities", reading, [&](const Entry& entry) { read_quantity(entry, reading); });
}

}  // namespace gaussgen::model
