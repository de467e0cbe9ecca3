#include "lower/symbol_map.hpp"

namespace gaussgen::lower {

SymbolMap symbols_of(const ir::Graph& graph) {
  SymbolMap map;
  for (std::uint32_t i = 0; i < graph.symbol_count(); ++i) {
    map.ids.emplace(graph.symbol(ir::SymbolId{i}).name, ir::SymbolId{i});
  }
  return map;
}

}  // namespace gaussgen::lower
