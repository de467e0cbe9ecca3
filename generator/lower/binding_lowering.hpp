#pragma once
// Lowers the objects of a PaperSystem: says what its symbols are in the graph.

#include <memory>

#include "lower/factorise.hpp"
#include "lower/lowering.hpp"
#include "lower/symbol_map.hpp"
#include "nonholonomic/reduction.hpp"

namespace gaussgen::lower {

struct LoweringStyle {
  /// x = c(t), ẋ = ċ, ẍ = c̈; else they are symbols of the map.
  bool hold = true;
  /// ÿ of free coordinates is what (3.7) gives; else a symbol of the map.
  bool solved = true;
  /// Inverses are unrolled factorisations and definitions carry their names; else inverses are opaque symbols that are
  /// declared here, and definitions are written out: for reading.
  bool computed = true;
  Vanishes vanishes = nullptr;  ///< for the pivots of these
};

class PaperLowering {
 public:
  PaperLowering(const nonholonomic::PaperSystem& paper, ir::Graph& graph, const SymbolMap& symbols,
                LoweringStyle style);
  PaperLowering(const PaperLowering&) = delete;
  PaperLowering& operator=(const PaperLowering&) = delete;

  ir::NodeId operator()(const GiNaC::ex& expression) { return lowering_(expression); }

  /// Opaque symbols declared on the way, with the inverse and the entry that they are.
  struct OpaqueEntry {
    ir::SymbolId symbol;
    const symbolic::OpaqueInverse* inverse;
    std::size_t row;
    std::size_t column;
  };
  const std::vector<OpaqueEntry>& opaque_entries() const { return opaque_entries_; }

 private:
  struct InverseEntry {
    const symbolic::OpaqueInverse* inverse;
    std::size_t row;
    std::size_t column;
  };

  void collect_bindings();
  void collect_motion();
  void settle_names();
  bool mentions_motion(const GiNaC::ex& f) const;
  ir::NodeId resolve(const GiNaC::symbol& symbol);
  ir::NodeId chart_symbol(const std::string& name);
  ir::NodeId inverse_entry(const InverseEntry& entry);
  std::vector<std::vector<ir::NodeId>> factorised(const symbolic::OpaqueInverse& inverse);

  const nonholonomic::PaperSystem& paper_;
  ir::Graph& graph_;
  const SymbolMap& symbols_;
  LoweringStyle style_;
  Lowering lowering_;
  // Looked up, never walked.
  std::map<GiNaC::ex, const symbolic::Definition*, GiNaC::ex_is_less> definitions_;
  std::map<GiNaC::ex, InverseEntry, GiNaC::ex_is_less> entries_;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> motion_;
  std::map<const symbolic::OpaqueInverse*, std::vector<std::vector<ir::NodeId>>> inverses_;
  std::vector<OpaqueEntry> opaque_entries_;
};

}  // namespace gaussgen::lower
