#pragma once

#include <map>
#include <string>

#include "ir/graph.hpp"

namespace gaussgen::lower {

/// Which symbol of a graph a name of the chart is: `pi`, parameters, inputs, `t`, coordinate `chi`, rate `chi_dot`,
/// quaternion component, angular velocity `wx`. A formula parameter may be absent; then its formula is taken.
struct SymbolMap {
  std::map<std::string, ir::SymbolId> ids;
  std::map<std::string, ir::NodeId> values =
      {};  ///< what is no symbol there: rates, where the model has speeds instead
};

/// All symbols of a graph by their names.
SymbolMap symbols_of(const ir::Graph& graph);

}  // namespace gaussgen::lower
