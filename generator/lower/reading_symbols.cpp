#include "lower/reading_symbols.hpp"

#include "lower/latex_name.hpp"

namespace gaussgen::lower {

using ir::SymbolClass;

namespace {

/// How the inverses of the paper's route are written.
std::string letter_of(const symbolic::OpaqueInverse& inverse) {
  if (inverse.name == "g_up") return "g";
  if (inverse.name == "G_up") return "G";
  if (inverse.name == "b_inv") return "(b^{-1})";
  return "\\mathit{" + latex_text(inverse.name) + "}";
}

}  // namespace

ReadingSymbols::ReadingSymbols(const model::Model& model, ir::Graph& graph) : graph_(graph) {
  for (const model::Table& table : model.tables) graph_.declare(table.function);
  declare(SymbolClass::pi, "pi", "\\pi");
  for (const auto& parameter : model.parameters) {
    declare(SymbolClass::parameter, parameter.name.text, latex_name(parameter.name.text));
  }
  declare(SymbolClass::time, "t", "t");
  for (const auto& coordinate : model.coordinates) declare_coordinate(coordinate);
  for (const auto& orientation : model.orientations) declare_orientation(orientation);
  for (const auto& input : model.inputs) declare(SymbolClass::input, input.name.text, latex_name(input.name.text));
  declare_compulsion_variables(model);
}

// a^α, a_i and R_i in Z, by the names that gauss/compulsion.cpp gives them, Q^α and F_i by those of derivation.cpp.
void ReadingSymbols::declare_compulsion_variables(const model::Model& model) {
  const auto declare_up = [&](const std::string& label) {
    declare(SymbolClass::acceleration, "a__up_" + label, "a^{" + latex_name(label) + "}");
    declare(SymbolClass::acceleration, "Q__up_" + label, "Q^{" + latex_name(label) + "}");
  };
  for (const auto& coordinate : model.coordinates) {
    const std::string& label = coordinate.name.text;
    if (coordinate.held_at) {
      declare(SymbolClass::held_acceleration, "a__" + label, "a_{" + latex_name(label) + "}");
      declare(SymbolClass::held_acceleration, "F__" + label, "F_{" + latex_name(label) + "}");
      declare(SymbolClass::held_acceleration, "R__" + label, "R_{" + latex_name(label) + "}");
    } else {
      declare_up(label);
    }
  }
  for (const auto& orientation : model.orientations) {
    for (const auto& component : orientation.angular_velocity) declare_up(component.text);
  }
}

void ReadingSymbols::declare(SymbolClass symbol_class, const std::string& name, const std::string& latex) {
  const ir::SymbolId symbol = graph_.declare(symbol_class, name);
  map_.ids.emplace(name, symbol);
  latex_.emplace(symbol.index, latex);
}

void ReadingSymbols::declare_coordinate(const model::Coordinate& coordinate) {
  const std::string& name = coordinate.name.text;
  const std::string symbol = latex_name(name);
  const bool is_held = coordinate.held_at.has_value();
  declare(is_held ? SymbolClass::held : SymbolClass::configuration, name, symbol);
  declare(is_held ? SymbolClass::held_rate : SymbolClass::speed, name + "_dot", "\\dot{" + symbol + "}");
  declare(is_held ? SymbolClass::held_acceleration : SymbolClass::acceleration, name + "_ddot",
          "\\ddot{" + symbol + "}");
}

void ReadingSymbols::declare_orientation(const model::Orientation& orientation) {
  for (const auto& component : orientation.quaternion) {
    declare(SymbolClass::configuration, component.text, latex_name(component.text));
  }
  for (const auto& component : orientation.angular_velocity) {
    const std::string symbol = latex_name(component.text);
    declare(SymbolClass::speed, component.text, symbol);
    declare(SymbolClass::acceleration, component.text + "_dot", "\\dot{" + symbol + "}");
  }
}

std::string ReadingSymbols::latex(ir::SymbolId symbol) const {
  const auto known = latex_.find(symbol.index);
  return known == latex_.end() ? latex_name(graph_.symbol(symbol).name) : known->second;
}

void ReadingSymbols::add(const std::vector<PaperLowering::OpaqueEntry>& entries) {
  for (const PaperLowering::OpaqueEntry& entry : entries) {
    const std::string indices = latex_indices({entry.inverse->rows[entry.row], entry.inverse->columns[entry.column]});
    latex_[entry.symbol.index] = letter_of(*entry.inverse) + "^{" + indices + "}";
  }
}

std::string latex_indices(const std::vector<std::string>& labels) {
  std::string result;
  for (const std::string& label : labels) result += (result.empty() ? "" : " ") + latex_name(label);
  return result;
}

}  // namespace gaussgen::lower
