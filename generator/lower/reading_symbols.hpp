#pragma once
// Symbols for formulas that people read: accelerations and held coordinates are symbols there.

#include <unordered_map>

#include "lower/binding_lowering.hpp"

namespace gaussgen::lower {

class ReadingSymbols {
 public:
  /// Declares everything in the order of the model, which is the canonical order of the graph.
  ReadingSymbols(const model::Model& model, ir::Graph& graph);

  const SymbolMap& map() const { return map_; }
  std::string latex(ir::SymbolId symbol) const;

  /// Opaque inverses that `lowering` has declared: g^{αβ} and so on.
  void add(const std::vector<PaperLowering::OpaqueEntry>& entries);

 private:
  void declare(ir::SymbolClass symbol_class, const std::string& name, const std::string& latex);
  void declare_coordinate(const model::Coordinate& coordinate);
  void declare_orientation(const model::Orientation& orientation);
  void declare_compulsion_variables(const model::Model& model);

  ir::Graph& graph_;
  SymbolMap map_;
  std::unordered_map<std::uint32_t, std::string> latex_;
};

/// "\chi \zeta": labels side by side, as indices.
std::string latex_indices(const std::vector<std::string>& labels);

}  // namespace gaussgen::lower
