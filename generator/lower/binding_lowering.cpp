#include "lower/binding_lowering.hpp"

#include "lower/factorise.hpp"
#include "support/assert.hpp"

namespace gaussgen::lower {

using ir::Expr;
using ir::NodeId;
using nonholonomic::PaperSystem;
using symbolic::Definition;
using symbolic::OpaqueInverse;

PaperLowering::PaperLowering(const PaperSystem& paper, ir::Graph& graph, const SymbolMap& symbols, LoweringStyle style)
    : paper_(paper),
      graph_(graph),
      symbols_(symbols),
      style_(style),
      lowering_(graph, symbols.ids.at("pi"), [this](const GiNaC::symbol& symbol) { return resolve(symbol); }) {
  collect_bindings();
  collect_motion();
  if (style_.computed) settle_names();
}

// The graph gives a value the first name that it gets. GiNaC's order of terms must not decide which one that is, so
// everything with a name is lowered here, in the order of the derivation, the held coordinates first.
void PaperLowering::settle_names() {
  const symbolic::Chart& chart = paper_.chart();
  for (const symbolic::HeldIndex i : style_.hold ? chart.held() : std::vector<symbolic::HeldIndex>{}) {
    for (const GiNaC::realsymbol& symbol : {chart[i].y, chart[i].rate, chart[i].acceleration}) lowering_(symbol);
  }
  std::vector<const Definition*> after_motion;
  for (const symbolic::Binding& binding : paper_.system.bindings.all()) {
    const auto* definition = std::get_if<Definition>(&binding);
    if (definition == nullptr) {
      lowering_(std::get<OpaqueInverse>(binding).entries[0][0]);
    } else if (style_.solved && mentions_motion(definition->value)) {
      after_motion.push_back(definition);
    } else {
      lowering_(definition->symbol);
    }
  }
  if (style_.solved) {
    for (const symbolic::FreeIndex a : paper_.partition.independent) lowering_(chart[a].acceleration);
    for (const symbolic::FreeIndex a : paper_.partition.dependent) lowering_(chart[a].acceleration);
  }
  for (const Definition* definition : after_motion) lowering_(definition->symbol);
}

bool PaperLowering::mentions_motion(const GiNaC::ex& f) const {
  for (const symbolic::FreeIndex a : paper_.chart().free()) {
    if (f.has(paper_.chart()[a].acceleration)) return true;
  }
  return false;
}

void PaperLowering::collect_bindings() {
  for (const symbolic::Binding& binding : paper_.system.bindings.all()) {
    if (const auto* definition = std::get_if<Definition>(&binding)) {
      definitions_.emplace(definition->symbol, definition);
    } else {
      const auto& inverse = std::get<OpaqueInverse>(binding);
      for (std::size_t i = 0; i < inverse.entries.size(); ++i) {
        for (std::size_t j = 0; j < inverse.entries.size(); ++j) {
          entries_.emplace(inverse.entries[i][j], InverseEntry{&inverse, i, j});
        }
      }
    }
  }
}

void PaperLowering::collect_motion() {
  const symbolic::Chart& chart = paper_.chart();
  if (style_.hold) {
    for (const symbolic::HeldIndex i : chart.held()) {
      const GiNaC::ex& c = *chart[i].held_at;
      motion_.emplace(chart[i].y, c);
      motion_.emplace(chart[i].rate, c.diff(chart.time()));
      motion_.emplace(chart[i].acceleration, c.diff(chart.time(), 2));
    }
  }
  if (style_.solved) {
    for (const symbolic::FreeIndex a : chart.free()) motion_.emplace(chart[a].acceleration, paper_.accelerations[a]);
  }
}

NodeId PaperLowering::resolve(const GiNaC::symbol& symbol) {
  if (const auto motion = motion_.find(symbol); motion != motion_.end()) {
    const NodeId node = lowering_(motion->second);
    return style_.computed ? graph_.named(node, symbol.get_name()) : node;
  }
  if (const auto definition = definitions_.find(symbol); definition != definitions_.end()) {
    const NodeId node = lowering_(definition->second->value);
    return style_.computed ? graph_.named(node, definition->second->name) : node;
  }
  if (const auto entry = entries_.find(symbol); entry != entries_.end()) return inverse_entry(entry->second);
  return chart_symbol(symbol.get_name());
}

NodeId PaperLowering::chart_symbol(const std::string& name) {
  if (const auto known = symbols_.values.find(name); known != symbols_.values.end()) return known->second;
  if (const auto known = symbols_.ids.find(name); known != symbols_.ids.end()) return graph_.use(known->second);
  const auto formula = paper_.chart().formulas().find(name);
  GAUSS_ASSERT(formula != paper_.chart().formulas().end(), "no symbol for {}", name);
  return graph_.named(lowering_(formula->second), name);
}

NodeId PaperLowering::inverse_entry(const InverseEntry& entry) {
  auto known = inverses_.find(entry.inverse);
  if (known == inverses_.end()) known = inverses_.emplace(entry.inverse, factorised(*entry.inverse)).first;
  return known->second[entry.row][entry.column];
}

std::vector<std::vector<NodeId>> PaperLowering::factorised(const OpaqueInverse& inverse) {
  const std::size_t n = inverse.matrix.size();
  const MatrixNames names{inverse.name, inverse.rows, inverse.columns};
  std::vector<std::vector<NodeId>> result(n, std::vector<NodeId>(n));
  if (!style_.computed) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = inverse.is_symmetric ? i : 0; j < n; ++j) {
        const ir::SymbolId symbol = graph_.declare(ir::SymbolClass::opaque, names(i, j));
        opaque_entries_.push_back({symbol, &inverse, i, j});
        result[i][j] = graph_.use(symbol);
        if (inverse.is_symmetric) result[j][i] = result[i][j];
      }
    }
    return result;
  }
  ExprMatrix matrix;
  for (const std::vector<GiNaC::ex>& row : inverse.matrix) {
    std::vector<Expr> lowered;
    for (const GiNaC::ex& entry : row) lowered.emplace_back(graph_, lowering_(entry));
    matrix.push_back(std::move(lowered));
  }
  const ExprMatrix entries =
      inverse.is_symmetric ? inverse_by_ldlt(matrix, names) : inverse_by_elimination(matrix, names, style_.vanishes);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) result[i][j] = entries[i][j].id();
  }
  return result;
}

}  // namespace gaussgen::lower
