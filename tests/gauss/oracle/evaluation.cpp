#include "gauss/oracle/evaluation.hpp"

#include <fstream>
#include <sstream>
#include <unordered_map>

#include "catch_shim.hpp"
#include "ir/traverse.hpp"
#include "model/build.hpp"

namespace gaussgen::oracle {

namespace {

Real real(const support::Rational& value) {
  return Real(support::to_text(cln::numerator(value))) / Real(support::to_text(cln::denominator(value)));
}

Real call(ir::Function function, const Real& x) {
  switch (function) {
    case ir::Function::sin: return sin(x);
    case ir::Function::cos: return cos(x);
    case ir::Function::tan: return tan(x);
    case ir::Function::exp: return exp(x);
    case ir::Function::log: return log(x);
    default: FAIL("function " << ir::name_of(function)); return 0;
  }
}

using Memo = std::unordered_map<std::uint32_t, Real>;

Real of_node(const ir::Graph& graph, const ir::Node& node, const Memo& memo, const Values& values) {
  const auto child = [&](std::size_t i) { return memo.at(node.children[i].index); };
  Real result = real(node.value);
  switch (node.kind) {
    case ir::Kind::constant: return result;
    case ir::Kind::symbol: {
      const std::string& name = graph.symbol(node.symbol).name;
      INFO("symbol " << name);
      REQUIRE(values.count(name) == 1);
      return values.at(name);
    }
    case ir::Kind::sum:
      for (std::size_t i = 0; i < node.children.size(); ++i) result += real(node.coefficients[i]) * child(i);
      return result;
    case ir::Kind::product:
      result = 1;
      for (std::size_t i = 0; i < node.children.size(); ++i) result *= child(i);
      return result;
    case ir::Kind::power: return pow(child(0), real(node.value));
    case ir::Kind::function: return call(node.function, child(0));
    case ir::Kind::named: return child(0);
  }
  return 0;
}

}  // namespace

Real evaluate(const ir::Graph& graph, ir::NodeId root, const Values& values) {
  Memo memo;
  for (const ir::NodeId id : ir::post_order(graph, {root})) memo[id.index] = of_node(graph, graph[id], memo, values);
  return memo.at(root.index);
}

PaperNumbers::PaperNumbers(const model::Model& model, const nonholonomic::PaperSystem& paper, Values values)
    : symbols_(declare_symbols(model, graph_)), values_(std::move(values)), lower_(paper, graph_, symbols_, {}) {
  values_["pi"] = acos(Real(-1));
}

model::Model model_of_text(const std::string& text) {
  support::Source source("model.yaml", text);
  support::Diagnostics diagnostics;
  auto model = model::build_model(source, diagnostics);
  INFO(support::render(diagnostics, source));
  REQUIRE(model.has_value());
  return *model;
}

model::Model model_of_file(const std::string& name) {
  std::ifstream file(std::string(GAUSS_SOURCE_DIR) + "/models/" + name + ".yaml");
  REQUIRE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  return model_of_text(text.str());
}

void add_formulas(const model::Model& model, Values& values) {
  ir::Graph graph;
  const lower::SymbolMap symbols = declare_symbols(model, graph);
  const symbolic::Chart chart(model);
  lower::Lowering lower(graph, symbols.ids.at("pi"),
                        [&](const GiNaC::symbol& symbol) { return graph.use(symbols.ids.at(symbol.get_name())); });
  for (const model::Parameter& parameter : model.parameters) {
    if (parameter.is_formula) values[parameter.name.text] = evaluate(graph, lower(chart(parameter.value)), values);
  }
}

}  // namespace gaussgen::oracle
