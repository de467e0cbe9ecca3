#pragma once
// Objects of a PaperSystem as formulas.

#include "ir/substitute.hpp"
#include "lower/decimal_style.hpp"
#include "lower/derivation.hpp"
#include "lower/reading_symbols.hpp"

namespace gaussgen::lower {

/// What stands left of the equals sign: a letter with lower and upper indices.
struct Left {
  std::string letter;
  std::vector<std::string> lower;
  std::vector<std::string> upper;

  std::string latex() const;
  std::string plain() const;
};

class FormulaWriter {
 public:
  FormulaWriter(const model::Model& model, const nonholonomic::PaperSystem& paper);
  FormulaWriter(const FormulaWriter&) = delete;
  FormulaWriter& operator=(const FormulaWriter&) = delete;

  bool is_zero(const GiNaC::ex& f) { return graph_.is_zero(lower_(f)); }

  /// `left` = f with x free.
  Formula operator()(const Left& left, const GiNaC::ex& f) { return formula(left, lower_(f)); }

  /// `left` = f with x = c(t): how it is used.
  Formula held(const Left& left, const GiNaC::ex& f);

  /// f = 0, with x = c(t).
  Formula equation(const std::string& name, const GiNaC::ex& f);

 private:
  Formula formula(const Left& left, ir::NodeId right);
  std::vector<std::string> terms(ir::NodeId node);
  ir::NodeId with_held(const GiNaC::ex& f);

  DecimalStyle decimals_;
  ir::Graph graph_;
  ReadingSymbols symbols_;
  PaperLowering lower_;
  ir::Substitution hold_;
};

}  // namespace gaussgen::lower
