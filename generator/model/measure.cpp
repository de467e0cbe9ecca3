#include "model/measure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gaussgen::model {

namespace {

constexpr std::size_t k_most_names = 5;

Dimension time() { return {{0, 0, 1}}; }

template <class Entry>
Measure stated(const Entry& entry) {
  if (!entry.dimension) return {};
  return {Measure::Kind::known, *entry.dimension, entry.unit};
}

Measure measure_of_values(const std::vector<Table>& tables, const std::string& name) {
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&](const Table& table) { return table.name.text == name; });
  return found == tables.end() ? Measure{} : stated(*found);
}

Dimension angular_velocity() {
  Dimension rate = power(time(), -1);
  rate.angle = 1;
  return rate;
}

void collect_names(const Ast& ast, std::vector<std::string>& names) {
  for (const Ast& child : ast.children) collect_names(child, names);
  const bool is_name = ast.kind == AstKind::symbol || ast.table != nullptr;
  if (!is_name || ast.name == "pi" || ast.name.empty()) return;
  if (std::find(names.begin(), names.end(), ast.name) == names.end()) names.push_back(ast.name);
}

std::string short_phrase(const Measure& measure, bool is_first) {
  const std::string verb = is_first ? "is " : "";
  return measure.kind == Measure::Kind::known ? verb + phrase(measure) : "has no unit";
}

}  // namespace

Measure known(const Dimension& dimension) { return {Measure::Kind::known, dimension, ""}; }

Measure measure_of(const Model& model, const std::string& symbol) {
  const auto found = model.symbols.find(symbol);
  if (found == model.symbols.end()) return measure_of_values(model.tables, symbol);
  const std::size_t index = found->second.index;
  switch (found->second.kind) {
    case SymbolKind::time: return known(time());
    case SymbolKind::pi: return {Measure::Kind::literal};
    case SymbolKind::parameter: return stated(model.parameters.at(index));
    case SymbolKind::input: return stated(model.inputs.at(index));
    case SymbolKind::coordinate: return stated(model.coordinates.at(index));
    case SymbolKind::quaternion_component: return known({});
    case SymbolKind::angular_velocity: return known(angular_velocity());
    case SymbolKind::speed: return stated(model.speeds.at(index));
    case SymbolKind::place: return {Measure::Kind::known, {{1}}, "m"};
    case SymbolKind::spin: return known(angular_velocity());
    case SymbolKind::slip: return {};
    case SymbolKind::axis: return known({});
    case SymbolKind::reaction: {
      const std::optional<Dimension>& dimension = model.reactions.at(index).dimension;
      return dimension ? known(*dimension) : Measure{};
    }
  }
  return {};
}

Measure measure_of_argument(const Table& table) {
  if (!table.of_dimension) return {};
  return {Measure::Kind::known, *table.of_dimension, table.of_unit};
}

std::string unit_of(const Measure& measure) {
  return measure.written.empty() ? text(measure.dimension) : measure.written;
}

std::string phrase(const Measure& measure) {
  const std::string unit = unit_of(measure);
  return unit == "1" ? "a plain number" : "in " + unit;
}

std::string units_of_names(const Model& model, const std::vector<const Ast*>& expressions) {
  std::vector<std::string> names;
  for (const Ast* ast : expressions) collect_names(*ast, names);
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), k_most_names); ++i) {
    list += fmt::format("{}'{}' {}", i == 0 ? "" : ", ", names[i], short_phrase(measure_of(model, names[i]), i == 0));
  }
  return names.size() > k_most_names ? list + ", ..." : list;
}

}  // namespace gaussgen::model
