// parameters and inputs: `m: 1.3` or `m: {value: 1.3, unit: kg, about: …}`.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"

namespace gaussgen::model {

using spec::Entry;
using spec::NodeKind;

namespace {

Ast read_value(const Entry& entry, const std::string& where, Reading& reading) {
  const spec::Node* value = required(entry.value, "value", entry.key.span, where, reading);
  return value == nullptr ? broken_expression() : read_expression(*value, entry.key.span, reading);
}

void read_parameter(const Entry& entry, Reading& reading) {
  Parameter parameter;
  parameter.name = name_of(entry.key);
  const std::string where = fmt::format("parameter '{}'", entry.key.text);
  if (entry.value.kind == NodeKind::map) {
    check_keys(entry.value, where, format::keys_of(format::parameter()), reading);
    parameter.value = read_value(entry, where, reading);
    read_unit(entry.value, parameter, reading);
    parameter.about = text_field(entry.value, "about", reading);
  } else {
    parameter.value = read_expression(entry.value, entry.key.span, reading);
  }
  declare(parameter.name, SymbolKind::parameter, reading.model.parameters.size(), "the parameter", reading);
  reading.model.parameters.push_back(std::move(parameter));
}

void read_input(const Entry& entry, Reading& reading) {
  Input input;
  input.name = name_of(entry.key);
  if (entry.value.kind == NodeKind::map) {
    check_keys(entry.value, fmt::format("input '{}'", entry.key.text), format::keys_of(format::input()), reading);
    input.value = expression_field(entry.value, "value", reading).value_or(number(0));
    read_unit(entry.value, input, reading);
    input.about = text_field(entry.value, "about", reading);
  } else if (entry.value.kind != NodeKind::empty) {
    input.value = read_expression(entry.value, entry.key.span, reading);
  }
  declare(input.name, SymbolKind::input, reading.model.inputs.size(), "the input", reading);
  reading.model.inputs.push_back(std::move(input));
}

}  // namespace

void read_parameters(const spec::Node& root, Reading& reading) {
  read_section(root, "parameters", reading, [&](const Entry& entry) { read_parameter(entry, reading); });
}

void read_inputs(const spec::Node& root, Reading& reading) {
  read_section(root, "inputs", reading, [&](const Entry& entry) { read_input(entry, reading); });
}

}  // namespace gaussgen::model
