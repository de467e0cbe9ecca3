#pragma once
// The symbols that a caller of the paper's route declares, without the emitted route.

#include "lower/symbol_map.hpp"
#include "model/model.hpp"

namespace gaussgen::oracle {

inline lower::SymbolMap declare_symbols(const model::Model& model, ir::Graph& graph) {
  using ir::SymbolClass;
  graph.declare(SymbolClass::pi, "pi");
  for (const auto& parameter : model.parameters) graph.declare(SymbolClass::parameter, parameter.name.text);
  graph.declare(SymbolClass::time, "t");
  for (const auto& coordinate : model.coordinates) {
    const std::string& name = coordinate.name.text;
    if (coordinate.held_at) continue;
    graph.declare(SymbolClass::configuration, name);
    graph.declare(SymbolClass::speed, name + "_dot");
  }
  for (const auto& orientation : model.orientations) {
    for (const auto& name : orientation.quaternion) graph.declare(SymbolClass::configuration, name.text);
    for (const auto& name : orientation.angular_velocity) graph.declare(SymbolClass::speed, name.text);
  }
  for (const auto& input : model.inputs) graph.declare(SymbolClass::input, input.name.text);
  return lower::symbols_of(graph);
}

}  // namespace gaussgen::oracle
