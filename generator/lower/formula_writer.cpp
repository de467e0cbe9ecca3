#include "lower/formula_writer.hpp"

#include "ir/print.hpp"
#include "lower/latex.hpp"

namespace gaussgen::lower {

namespace {

std::string joined(const std::string& head, const std::vector<std::string>& labels) {
  std::string result = head;
  for (const std::string& label : labels) result += "_" + label;
  return result;
}

}  // namespace

std::string Left::latex() const {
  std::string result = letter;
  if (!upper.empty()) result += "^{" + latex_indices(upper) + "}";
  if (!lower.empty()) result += (upper.empty() ? "_{" : "{}_{") + latex_indices(lower) + "}";
  return result;
}

std::string Left::plain() const {
  std::string head = letter[0] == '\\' ? letter.substr(1) : letter;
  return joined(joined(head, lower) + (upper.empty() ? "" : "_up"), upper);
}

FormulaWriter::FormulaWriter(const model::Model& model, const nonholonomic::PaperSystem& paper)
    : decimals_(model),
      symbols_(model, graph_),
      lower_(paper, graph_, symbols_.map(), {false, false, false}),
      hold_(graph_) {
  const symbolic::Chart& chart = paper.chart();
  const auto replace = [&](const GiNaC::symbol& symbol, const GiNaC::ex& value) {
    hold_.replace(symbols_.map().ids.at(symbol.get_name()), {graph_, lower_(value)});
  };
  for (const symbolic::HeldIndex i : chart.held()) {
    const GiNaC::ex& c = *chart[i].held_at;
    replace(chart[i].y, c);
    replace(chart[i].rate, c.diff(chart.time()));
    replace(chart[i].acceleration, c.diff(chart.time(), 2));
  }
}

ir::NodeId FormulaWriter::with_held(const GiNaC::ex& f) { return hold_({graph_, lower_(f)}).id(); }

Formula FormulaWriter::held(const Left& left, const GiNaC::ex& f) { return formula(left, with_held(f)); }

Formula FormulaWriter::equation(const std::string& name, const GiNaC::ex& f) {
  const ir::NodeId node = with_held(f);
  return {"", terms(node), name + ": " + ir::print(graph_, node) + " = 0"};
}

Formula FormulaWriter::formula(const Left& left, ir::NodeId right) {
  return {left.latex(), terms(right), left.plain() + " = " + ir::print(graph_, right)};
}

std::vector<std::string> FormulaWriter::terms(ir::NodeId node) {
  symbols_.add(lower_.opaque_entries());
  return latex_terms(
      graph_, node, [this](ir::SymbolId symbol) { return symbols_.latex(symbol); }, decimals_);
}

}  // namespace gaussgen::lower
