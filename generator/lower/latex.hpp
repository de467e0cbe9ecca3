#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ir/graph.hpp"
#include "lower/decimal_style.hpp"

namespace gaussgen::lower {

/// One expression as a LaTeX formula; `name` says how a symbol is written.
std::string latex(const ir::Graph& graph, ir::NodeId id, const std::function<std::string(ir::SymbolId)>& name,
                  const DecimalStyle& decimals = {});

/// The same, term by term with their signs, so that a long sum can be broken into lines.
std::vector<std::string> latex_terms(const ir::Graph& graph, ir::NodeId id,
                                     const std::function<std::string(ir::SymbolId)>& name,
                                     const DecimalStyle& decimals = {});

}  // namespace gaussgen::lower
