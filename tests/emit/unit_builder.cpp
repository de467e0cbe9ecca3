#include "unit_builder.hpp"

namespace gausstest {

using namespace gaussgen;

UnitBuilder::UnitBuilder(Sample& sample) : graph_(sample.graph), unit_(sample.unit) {
  const ir::NodeId never = graph_.constant(0);
  (void)never;
  unit_.artefacts.reserve(16);  // references to artefacts stay valid
  unit_.time = graph_.declare(SymbolClass::time, "t");
  unit_.epsilon = graph_.declare(SymbolClass::epsilon, "eps");
  unit_.provenance = {"0.0", "sample.yaml", "0123456789abcdef", "gauss-gen sample.yaml", "", {}};
}

Entry UnitBuilder::entry(SymbolClass symbol_class, const std::string& name, const std::string& unit,
                         const std::string& about) {
  return {graph_.declare(symbol_class, name), name, unit, about};
}

Expr UnitBuilder::parameter(const std::string& name, const Rational& value, const std::string& unit,
                            const std::string& about) {
  unit_.parameters.push_back({entry(SymbolClass::parameter, name, unit, about), graph_.constant(value), false});
  return {graph_, graph_.use(unit_.parameters.back().entry.symbol)};
}

Expr UnitBuilder::formula(const std::string& name, Expr value, const std::string& unit) {
  unit_.parameters.push_back({entry(SymbolClass::parameter, name, unit, ""), value.id(), true});
  return {graph_, graph_.use(unit_.parameters.back().entry.symbol)};
}

Expr UnitBuilder::input(const std::string& name, const Rational& value, const std::string& unit, const std::string& about) {
  unit_.inputs.push_back({entry(SymbolClass::input, name, unit, about), graph_.constant(value)});
  return {graph_, graph_.use(unit_.inputs.back().entry.symbol)};
}

std::pair<Expr, Expr> UnitBuilder::coordinate(const std::string& name, const std::string& unit, const std::string& about) {
  unit_.configuration.push_back(entry(SymbolClass::configuration, name, unit, about));
  unit_.speeds.push_back(entry(SymbolClass::speed, name + "_dot", unit + "/s", "rate of " + name));
  unit_.accelerations.push_back(entry(SymbolClass::acceleration, name + "_ddot", unit + "/s^2", ""));
  unit_.configuration_rates.push_back(name + "_dot");
  return {Expr(graph_, graph_.use(unit_.configuration.back().symbol)), Expr(graph_, graph_.use(unit_.speeds.back().symbol))};
}

emit::Artefact& UnitBuilder::artefact(const std::string& name, const std::string& about) {
  unit_.artefacts.push_back({});
  emit::Artefact& result = unit_.artefacts.back();
  result.name = name;
  result.about = about;
  const ir::NodeId never = graph_.constant(0);
  result.status = {never, never, never, never};
  return result;
}

emit::Field UnitBuilder::field(const std::string& name, const std::string& about, const std::vector<Expr>& values,
                               std::vector<int> shape) {
  emit::Field result{name, about, std::move(shape), {}};
  for (const Expr& value : values) result.values.push_back(value.id());
  return result;
}

void UnitBuilder::section(emit::Artefact& artefact, const std::string& comment,
                          const std::vector<std::pair<Expr, std::string>>& nodes) {
  artefact.sections.push_back({comment, "", {}});
  for (const auto& [node, name] : nodes) artefact.sections.back().nodes.emplace_back(node.id(), name);
}

ir::NodeId UnitBuilder::not_finite(const std::vector<Expr>& values) {
  std::vector<ir::NodeId> ids;
  for (const Expr& value : values) ids.push_back(value.id());
  return graph_.call(Function::not_finite, ids);
}

}  // namespace gausstest
