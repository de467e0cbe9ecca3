// Pivots of the paper's route that are zero in every configuration without a simplification that shows it.
#include "catch_shim.hpp"
#include "conditioning.hpp"
#include "model/build.hpp"
#include "paper.hpp"

namespace {

// Columns of the block b are those of z, y and w; the first entry is cos(2a) less its own expansion.
const char* const k_model = R"(
gauss: 1
name: pivots
coordinates: {x: {}, z: {}, y: {}, w: {}, a: {initial: 0.4}}
particles:
  p: {mass: 1, position: [x, y, z]}
  q: {mass: 2, position: [w, a, 0]}
constraints:
  c1: {velocity: (cos(2*a) - cos(a)^2 + sin(a)^2)*dot(z) + sin(a)*dot(y) + dot(x) + a*dot(w)}
  c2: {velocity: (2 + a^2)*dot(z) + a*dot(w) + dot(x)}
  c3: {velocity: (3 + a)*dot(w) + a*dot(y) + a*dot(z) - dot(x)}
elimination: {dependent: [z, y, w]}
)";

}  // namespace

TEST_CASE("the paper's route takes no pivot that vanishes everywhere") {
  gaussgen::support::Source source("pivots.yaml", k_model);
  gaussgen::support::Diagnostics diagnostics;
  const auto model = gaussgen::model::build_model(source, diagnostics);
  REQUIRE(model);
  gaussgen::Mechanics mechanics(*model, {});
  const auto route = gaussgen::paper_route(mechanics);
  REQUIRE(route.obstacle.empty());
  REQUIRE(route.dependent.size() == 3);

  agreement::Evaluator<double> evaluator(mechanics.graph, gaussgen::evaluate::Arithmetic<double>());
  gaussgen::bind_parameters(mechanics, evaluator);
  agreement::RandomStates random(mechanics.symbols, 7);
  for (int state = 0; state < 20; ++state) {
    agreement::bind(mechanics.symbols, random.next(), evaluator);
    const Eigen::VectorXd ours = agreement::values(evaluator, agreement::nodes(mechanics.solution.accelerations));
    const Eigen::VectorXd papers = agreement::values(evaluator, route.accelerations);
    INFO("state " << state);
    CHECK((ours - papers).norm() <= 1e-9 * ours.norm());
  }
}
