#include <chrono>

#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "ir/verify.hpp"
#include "lower/paper_route.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

double largest_error(const ir::Graph& graph, const std::vector<ir::NodeId>& nodes, const Values& values,
                     const Vec& expected) {
  REQUIRE(nodes.size() == expected.size());
  double largest = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    largest = std::max(largest, deviation(evaluate(graph, nodes[i], values), expected[i]));
  }
  return largest;
}

std::string many_particles(int count) {
  std::string coordinates;
  std::string particles;
  for (int i = 0; i < count; ++i) {
    const std::string q = "q" + std::to_string(i);
    coordinates += "  " + q + ": {}\n";
    particles += "  p" + std::to_string(i) + ": {mass: m, position: [" + q + ", 0, 0]}\n";
  }
  return "gauss: 1\nname: many\nparameters: {m: {value: 1}}\ncoordinates:\n" + coordinates + "particles:\n" + particles;
}

}  // namespace

TEST_CASE("the route's nodes are the accelerations, multipliers and reactions of least Z", "[lower]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(12);
    ir::Graph graph;
    const lower::SymbolMap symbols = declare_symbols(c.model, graph);
    const lower::PaperRoute route = lower::build_paper_route(c.model, graph, symbols);
    const Motion motion = minimise(c.bare, probe(c.bare));
    INFO(model.name);
    REQUIRE(route.obstacle.empty());
    CHECK(largest_error(graph, route.accelerations, c.values, motion.accelerations) < 1e-14);
    CHECK(largest_error(graph, route.lambda, c.values, motion.lambda) < 1e-14);
    CHECK(largest_error(graph, route.R_x, c.values, motion.R_x) < 1e-14);
    CHECK(ir::violations(graph, route.accelerations).empty());
  }
}

TEST_CASE("a formula parameter without a symbol is replaced by its formula", "[lower]") {
  Case c = case_of("sphere_in_cylinder", 13);
  ir::Graph graph;
  lower::SymbolMap symbols = declare_symbols(c.model, graph);
  symbols.ids.erase("J");
  const lower::PaperRoute route = lower::build_paper_route(c.model, graph, symbols);
  c.values.erase("J");
  CHECK(largest_error(graph, route.accelerations, c.values, minimise(c.bare, probe(c.bare)).accelerations) < 1e-14);
}

TEST_CASE("the route takes twelve coordinates and says so of thirteen", "[lower]") {
  for (const int count : {12, 13}) {
    const model::Model model = model_of_text(many_particles(count));
    ir::Graph graph;
    const lower::SymbolMap symbols = declare_symbols(model, graph);
    const lower::PaperRoute route = lower::build_paper_route(model, graph, symbols);
    CHECK(route.obstacle.empty() == (count == 12));
    CHECK(route.accelerations.size() == (count == 12 ? 12 : 0));
  }
}

TEST_CASE("the ball goes through the route well below a tenth of a second", "[lower]") {
  const model::Model model = model_of_file("sphere_in_cylinder");
  const auto start = std::chrono::steady_clock::now();
  ir::Graph graph;
  const lower::SymbolMap symbols = declare_symbols(model, graph);
  lower::build_paper_route(model, graph, symbols);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CAPTURE(seconds);
  CHECK(seconds < 0.1);
}
