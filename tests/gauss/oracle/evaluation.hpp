#pragma once

#include "gauss/oracle/real.hpp"
#include "gauss/oracle/route_symbols.hpp"
#include "lower/binding_lowering.hpp"
#include "model/model.hpp"

namespace gaussgen::oracle {

/// A node with numbers for its symbols, by name.
Real evaluate(const ir::Graph& graph, ir::NodeId node, const Values& values);

/// Objects of a PaperSystem as numbers, with x = c(t) and ÿ of the motion.
class PaperNumbers {
 public:
  PaperNumbers(const model::Model& model, const nonholonomic::PaperSystem& paper, Values values);

  Real operator()(const GiNaC::ex& f) { return evaluate(graph_, lower_(f), values_); }

  template <class Index>
  Vec operator()(const symbolic::Row<Index>& row) {
    Vec result;
    for (const GiNaC::ex& f : row) result.push_back((*this)(f));
    return result;
  }

  template <class RowIndex, class ColumnIndex>
  Mat operator()(const symbolic::Table<RowIndex, ColumnIndex>& table) {
    Mat result;
    for (const auto& row : table) result.push_back((*this)(row));
    return result;
  }

 private:
  ir::Graph graph_;
  lower::SymbolMap symbols_;
  Values values_;
  lower::PaperLowering lower_;
};

/// The checked model of a text; fails the test when it has errors.
model::Model model_of_text(const std::string& text);

/// models/<name>.yaml
model::Model model_of_file(const std::string& name);

/// Values of formula parameters, from the plain ones in `values`.
void add_formulas(const model::Model& model, Values& values);

}  // namespace gaussgen::oracle
