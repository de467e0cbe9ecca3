#pragma once
// Short notation for filling a Unit.

#include <utility>

#include "emit/unit.hpp"
#include "ir/expr.hpp"
#include "units.hpp"

namespace gausstest {

using gaussgen::emit::Entry;
using gaussgen::ir::Expr;
using gaussgen::ir::Function;
using gaussgen::ir::Rational;
using gaussgen::ir::SymbolClass;

class UnitBuilder {
 public:
  explicit UnitBuilder(Sample& sample);

  Expr number(const Rational& value) { return {graph_, graph_.constant(value)}; }
  Expr parameter(const std::string& name, const Rational& value, const std::string& unit, const std::string& about);
  Expr formula(const std::string& name, Expr value, const std::string& unit);
  Expr input(const std::string& name, const Rational& value, const std::string& unit, const std::string& about);
  /// The coordinate and its speed `name_dot`; declares the acceleration `name_ddot` as well.
  std::pair<Expr, Expr> coordinate(const std::string& name, const std::string& unit, const std::string& about);
  Expr time() { return {graph_, graph_.use(unit_.time)}; }
  Expr epsilon() { return {graph_, graph_.use(unit_.epsilon)}; }
  Expr acceleration(std::size_t index) { return {graph_, graph_.use(unit_.accelerations[index].symbol)}; }

  gaussgen::emit::Artefact& artefact(const std::string& name, const std::string& about);
  static gaussgen::emit::Field field(const std::string& name, const std::string& about, const std::vector<Expr>& values,
                                     std::vector<int> shape = {});
  static void section(gaussgen::emit::Artefact& artefact, const std::string& comment,
                      const std::vector<std::pair<Expr, std::string>>& nodes);
  gaussgen::ir::NodeId not_finite(const std::vector<Expr>& values);

 private:
  Entry entry(SymbolClass symbol_class, const std::string& name, const std::string& unit, const std::string& about);

  gaussgen::ir::Graph& graph_;
  gaussgen::emit::Unit& unit_;
};

}  // namespace gausstest
