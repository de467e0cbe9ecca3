// Prints the paper's route and the derivation of a model: `paper_probe MODEL [UNUSED]`. UNUSED GiNaC symbols are
// created first, which changes GiNaC's serial numbers, and so its order of terms.

#include <ginac/ginac.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "gauss/oracle/route_symbols.hpp"
#include "ir/print.hpp"
#include "lower/derivation.hpp"
#include "lower/paper_route.hpp"
#include "model/build.hpp"
#include "support/files.hpp"

using namespace gaussgen;

namespace {

void print(const ir::Graph& graph, const char* what, const std::vector<std::string>& names,
           const std::vector<ir::NodeId>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::cout << what << ' ' << names[i] << " = " << ir::print(graph, nodes[i]) << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<GiNaC::realsymbol> unused(argc > 2 ? static_cast<std::size_t>(std::atoi(argv[2])) : 0);
  std::string why;
  support::Source source(argv[1], support::read_file(argv[1], why).value(), support::read_regular_file);
  support::Diagnostics diagnostics;
  const auto model = model::build_model(source, diagnostics);
  if (!model) {
    std::cerr << support::render(diagnostics, source);
    return 1;
  }
  ir::Graph graph;
  const lower::SymbolMap symbols = oracle::declare_symbols(*model, graph);
  const lower::PaperRoute route = lower::build_paper_route(*model, graph, symbols);
  print(graph, "acceleration", route.speeds, route.accelerations);
  print(graph, "multiplier", route.constraints, route.lambda);
  print(graph, "reaction", route.held, route.R_x);
  print(graph, "reaction_up", route.held, route.R_x_up);
  std::cout << "Z_w = " << ir::print(graph, route.Z_w) << '\n';
  const lower::Derivation derivation = lower::derive(*model);
  std::cout << lower::as_plain_text(derivation) << lower::as_markdown(derivation) << lower::as_latex(derivation);
  return 0;
}
