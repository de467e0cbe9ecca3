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

// Eliminating five distances, one after the other, leaves numbers that are made of very much larger ones.
const char* const k_legs = R"(
gauss: 1
name: legs
counts: {n: 5}
parameters: {R: 0.8, rho: 0.4, L: 1}
joints: {fly: {type: free, child: plate, initial_guess: [0, 0, 0.8]}}
bodies: {plate: {mass: 12, inertia: 0.4}}
points:
  foot_$i: {count: n, at: [R*cos($i), R*sin($i), 0]}
  top_$i: {count: n, on: plate, at: [rho*cos($i + 0.3), rho*sin($i + 0.3), 0]}
constraints:
  leg_$i: {count: n, distance: [top_$i, foot_$i], is: L}
)";

/// The largest difference of accelerations between the emitted and the paper's route, relative, over random states.
double difference_of_routes(const char* text, std::size_t dependent) {
  gaussgen::support::Source source("pivots.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  const auto model = gaussgen::model::build_model(source, diagnostics);
  REQUIRE(model);
  gaussgen::Mechanics mechanics(*model, {});
  const auto route = gaussgen::paper_route(mechanics);
  REQUIRE(route.obstacle.empty());
  REQUIRE(route.dependent.size() == dependent);

  agreement::Evaluator<double> evaluator(mechanics.graph, gaussgen::evaluate::Arithmetic<double>());
  gaussgen::bind_parameters(mechanics, evaluator);
  agreement::RandomStates random(mechanics.symbols, 7);
  double worst = 0;
  for (int state = 0; state < 20; ++state) {
    agreement::bind(mechanics.symbols, random.next(), evaluator);
    const Eigen::VectorXd ours = agreement::values(evaluator, agreement::nodes(mechanics.solution.accelerations));
    const Eigen::VectorXd papers = agreement::values(evaluator, route.accelerations);
    agreement::take(worst, (ours - papers).norm() / ours.norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("the paper's route takes no pivot that vanishes everywhere, and takes those that do not") {
  CHECK(difference_of_routes(k_model, 3) <= 1e-9);
  CHECK(difference_of_routes(k_legs, 5) <= 1e-6);
}
