#include "emit/names.hpp"

#include "emit/identifiers.hpp"
#include "emit/taylor.hpp"

namespace gaussgen::emit {

std::string NameScope::allocate(const std::string& wanted) {
  std::string safe = mangled(wanted);
  if (taken_.insert(safe).second) return safe;
  const std::string stem = safe.back() == '_' ? safe : safe + "_";
  for (int number = 2;; ++number) {
    std::string text = stem + std::to_string(number);
    if (taken_.insert(text).second) return text;
  }
}

std::string NameScope::allocate_anonymous(const std::string& prefix) {
  for (int& number = last_number_[prefix];;) {
    std::string text = prefix + std::to_string(++number);
    if (taken_.insert(text).second) return text;
  }
}

UnitNames::UnitNames(const ir::Graph& graph, const Unit& unit) {
  for (const Artefact& artefact : unit.artefacts) {
    if (artefact.is_series) reserve_names_of_series(scope_);
    scope_.reserve(artefact.name);
    scope_.reserve(artefact.result_type);
    scope_.reserve(snake_case(artefact.result_type));
  }
  for (const ParameterEntry& parameter : unit.parameters) add(parameter.entry);
  for (const InputEntry& input : unit.inputs) add(input.entry);
  for (const Entry& entry : unit.configuration) add(entry);
  for (const Entry& entry : unit.speeds) add(entry);
  for (const Entry& entry : unit.start) bind(entry.symbol, scope_.allocate(entry.name + "_at_start"));
  for (const Entry& entry : unit.accelerations) add(entry);
  for (const Entry& entry : unit.multipliers) bind(entry.symbol, scope_.allocate(entry.name));
  for (const std::string& rate : unit.configuration_rates) add(rate);
  for (std::uint32_t i = 0; i < graph.table_count(); ++i) add(graph.table(ir::TableId{i}));
  bind(unit.time, "t");
  bind(unit.epsilon, "Math<S>::epsilon()");
  for (std::uint32_t i = 0; i < graph.symbol_count(); ++i) {
    if (graph.symbol(SymbolId{i}).symbol_class == ir::SymbolClass::pi) bind(SymbolId{i}, "Math<S>::pi()");
  }
}

// A configuration rate is often a speed as well (chi_dot), and then has the same text.
void UnitNames::add(const std::string& name) {
  if (texts_.count(name) != 0) return;
  const bool is_free = scope_.is_free(mangled(name));
  texts_.emplace(name, scope_.allocate(is_free ? name : name + "_"));
}

void UnitNames::add(const support::Table& table) {
  std::vector<std::string> names{scope_.allocate(table.name)};
  for (std::size_t order = 1; order <= table.degree(); ++order) {
    names.push_back(scope_.allocate(table.name + "_d" + std::to_string(order)));
  }
  names.push_back(scope_.allocate(table.name + "_piece"));
  tables_.push_back(std::move(names));
}

void UnitNames::add(const Entry& entry) {
  add(entry.name);
  bind(entry.symbol, of(entry.name));
}

std::string UnitNames::of_symbol(SymbolId symbol) const {
  const auto it = symbols_.find(symbol.index);
  return it == symbols_.end() ? std::string() : it->second;
}

}  // namespace gaussgen::emit
