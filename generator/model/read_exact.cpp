// exact: `x: x_0*cos(w*t)`, `x_dot: -x_0*w*sin(w*t)`.

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "model/fields.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;

namespace {

constexpr std::string_view k_rate = "_dot";

bool is_of_kind(const std::string& name, SymbolKind kind, const Reading& reading) {
  const auto symbol = reading.model.symbols.find(name);
  return symbol != reading.model.symbols.end() && symbol->second.kind == kind;
}

/// A table has the speeds that stand in the state, and the rates of all other coordinates.
std::vector<std::string> names_of_columns(const Reading& reading) {
  std::vector<std::string> names;
  for (const Coordinate& coordinate : reading.model.coordinates) {
    names.push_back(coordinate.name.text);
    names.push_back(coordinate.name.text + std::string(k_rate));
  }
  for (const Speed& speed : reading.model.speeds) names.push_back(speed.name.text);
  return names;
}

/// The coordinate of a rate `x_dot`; empty: the name is none of a rate.
std::string coordinate_of(const std::string& rate, const Reading& reading) {
  const std::size_t end = rate.size() - std::min(rate.size(), k_rate.size());
  if (rate.compare(end, std::string::npos, k_rate) != 0) return "";
  const std::string name = rate.substr(0, end);
  return is_of_kind(name, SymbolKind::coordinate, reading) || reading.unread.may_declare(name) ? name : "";
}

void read_form(const Entry& entry, Reading& reading) {
  ClosedForm form;
  form.name = form.of = name_of(entry.key);
  form.value = read_expression(entry.value, entry.key.span, reading);
  const std::string& name = form.name.text;
  const auto is_moving = [&](SymbolKind kind) { return is_of_kind(name, kind, reading); };
  const std::string coordinate = coordinate_of(name, reading);
  if (!coordinate.empty()) {
    form.of.text = coordinate;
    form.is_rate = true;
  } else if (!is_moving(SymbolKind::coordinate) && !is_moving(SymbolKind::speed) && !reading.unread.may_declare(name)) {
    const std::string near = did_you_mean_one_of(
        form.name, [&] { return names_of_columns(reading); }, reading);
    reading.diagnostics.error(
        code::k_wrong_reference, form.name.span, fmt::format("'{}' is no coordinate, rate or speed", name),
        near.empty() ? "a closed form is of a coordinate x, of its rate x_dot, or of a speed" : near);
  }
  reading.model.exact.push_back(std::move(form));
}

}  // namespace

void read_exact(const spec::Node& root, Reading& reading) {
  // With other effects it is another motion.
  const auto& effects = reading.model.effects;
  if (std::any_of(effects.begin(), effects.end(), [](const Effect& one) { return one.acts != one.by_default; })) return;
  read_section(root, "exact", reading, [&](const Entry& entry) { read_form(entry, reading); });
}

}  // namespace gaussgen::model
