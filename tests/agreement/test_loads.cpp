// Forces at places on the links that carry them: accelerations and multipliers are those of the metric, which knows them along the speeds, in
// fifty digits.

#include <algorithm>

#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "models.hpp"

namespace {

using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::Strategy;
using gaussgen::evaluate::Arithmetic;
using gaussgen::ir::Expr;

constexpr double k_tolerance = 1e-35;
constexpr double k_tolerance_of_quaternions = 1e-13;  ///< their length is 1 to double precision
constexpr int k_states = 3;

struct Named {
  const char* name;
  const char* text;  ///< of the model, but for what all have
};

constexpr const char* k_common = R"(gauss: 1
name: loaded
counts: {n: 5}
parameters: {m: 1.3, L: 0.7, J: 0.05, g: 9.81, k: 9, c: 0.4}
)";

constexpr const char* k_arm = R"(
frames: {link_0: {position: [0, 0.2, L]}}
joints:
  joint_$i: {count: n, type: universal, parent: link_$(i-1), child: link_$i, at: [0, 0, -L], coordinates: [a_$i, b_$i]}
bodies:
  link_$i: {count: n, mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.1, 0, -L/2]}
  lamp_$i: {count: n, frame: link_$i, mass: 0.3, inertia: [[0.03, 0.002, -0.001], [0.002, 0.04, 0.003], [-0.001, 0.003, 0.02]], centre: [0, 0.2, -L]}
points:
  tip: {on: link_$n, at: [0.1, 0, -L]}
  side_$i: {count: n, on: link_$i, at: [0, 0.3, -L/3]}
)";

constexpr const char* k_rods = R"(
joints:
  hinge_1: {type: revolute, child: rod_1, axis: y, coordinates: q_1}
  hinge_$(i+1): {count: 8, type: revolute, parent: rod_$i, child: rod_$(i+1), at: [0, 0, -L], axis: y, coordinates: q_$(i+1)}
bodies: {rod_$i: {count: 9, mass: m, inertia: [J, J, 0.001], centre: [0, 0, -L/2]}}
)";

const Named k_on_arm[] = {
    {"force in space at the tip",
     "forces: {gravity: {uniform: [0.3, 0, -g]}, push: {on: tip, force: [1, 2*dot(a_1), 3]}}\n"},
    {"springs between neighbours, and a torque",
     "forces:\n  muscle_$i: {count: n-1, spring: [side_$i, side_$(i+1)], stiffness: k, length: 0.2, damping: c}\n"
     "  twist: {on: link_3, torque: [0.3, k, c*b_2]}\n"},
    {"drag of every link",
     "forces: {drag_$i: {count: n, on: side_$i, force: [-c*dot(side_$i.x), 0, -k*dot(side_$i.z)]}}\n"},
};

const Named k_whole[] = {
    {"rods with the last one pulled, masses at the ends of bars",
     "particles: {bob: {frame: rod_9, mass: 2, centre: [0, 0, -L]}}\npoints: {tip: {on: rod_9, at: [0, 0, -L]}}\n"
     "forces: {gravity: {uniform: [0, 0, -g]}, pull: {on: tip, force: [4, 0, 1]}, push: {on: bob, force: [k, 0, "
     "c*q_2]}}\n"},
    {"rods that a constraint holds at the tip",
     "points: {tip: {on: rod_9, at: [0, 0, -L]}, nail: {on: space, at: [1, 0, 0]}, middle: {on: rod_5, at: [0.1, 0, "
     "0]}}\n"
     "constraints: {string: {distance: [tip, nail], is: 3}}\n"
     "forces: {gravity: {uniform: [0, 0, -g]}, pull: {on: middle, force: [4, 0, dot(q_3)]}, drag: {on: tip, force: "
     "[-c*dot(tip.x), 0, 0]}}\n"},
};

/// The second link has nothing but a particle.
constexpr const char* k_beside_a_particle = R"(
frames: {link_0: {position: [0, 0.2, L]}}
joints:
  joint_$i: {count: n, type: universal, parent: link_$(i-1), child: link_$i, at: [0, 0, -L], coordinates: [a_$i, b_$i]}
bodies:
  link_1: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.1, 0, -L/2]}
  link_$(i+2): {count: n-2, mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.1, 0, -L/2]}
particles: {bob: {frame: link_2, mass: 0.4, centre: [0.3, 0.1, -0.2]}}
points:
  beside: {on: link_2, at: [-0.1, 0.2, 0.1]}
  tip: {on: link_5, at: [0.1, 0, -L]}
forces: {pull: {on: beside, force: [4, 0, k]}, muscle: {spring: [beside, tip], stiffness: k, damping: c}}
)";

constexpr const char* k_ship = R"(
joints:
  free: {type: free, child: hull}
  mast: {type: spherical, parent: hull, child: mast, at: [0.2, 0, 0.5]}
  wheel: {type: revolute, parent: mast, child: wheel, at: [0, 0, L], axis: y, coordinates: w}
bodies:
  hull: {mass: 7, inertia: [1, 2, 3], centre: [0.1, 0, 0]}
  mast: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0, 0, L/2]}
  wheel: {mass: 0.5, inertia: [0.01, 0.02, 0.01]}
points: {top: {on: mast, at: [0, 0, L]}, rim: {on: wheel, at: [0.2, 0, 0]}, bow: {on: hull, at: [1, 0, 0.1]}}
forces:
  gravity: {uniform: [0, 0, -g]}
  wind: {on: top, force: [2, -c*dot(top.y), 0.1]}
  jet: {on: rim, force: [0, 0.3, 1]}
  thrust: {on: bow, force: [5, 0, 0]}
)";

gaussgen::model::Model model_of(const std::string& text) {
  gaussgen::support::Source source("loaded.yaml", k_common + text);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  INFO(gaussgen::support::render(diagnostics, source));
  REQUIRE(model);
  return *model;
}

class Side {
 public:
  Side(const gaussgen::model::Model& model, Strategy strategy)
      : mechanics(model, {false, strategy}),
        evaluator_(mechanics.graph, Arithmetic<cl_F>(50)),
        states_(mechanics.symbols, 5) {
    gaussgen::bind_parameters(mechanics, evaluator_);
  }

  /// Accelerations and multipliers at the next state.
  std::vector<cl_F> next() {
    agreement::bind(mechanics.symbols, states_.next(), evaluator_);
    std::vector<cl_F> values;
    for (const auto* list : {&mechanics.solution.accelerations, &mechanics.solution.multipliers}) {
      for (const Expr e : *list) {
        const auto value = evaluator_(e.id());
        REQUIRE(value);
        values.push_back(*value);
      }
    }
    return values;
  }

  Mechanics mechanics;

 private:
  gaussgen::evaluate::Evaluator<cl_F> evaluator_;
  agreement::RandomStates states_;
};

void compare(const std::string& text) {
  const auto model = model_of(text);
  Side tree(model, Strategy::tree), metric(model, Strategy::metric);
  CHECK(tree.mechanics.solution.description.find("forces at places on the links") != std::string::npos);
  const bool has_quaternions = !tree.mechanics.symbols.first_quaternion_component.empty();
  for (int k = 0; k < k_states; ++k) {
    const auto found = tree.next(), expected = metric.next();
    double worst = 0, scale = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      worst = std::max(worst, gaussgen::evaluate::to_double(cln::abs(found[i] - expected[i])));
      scale = std::max(scale, gaussgen::evaluate::to_double(cln::abs(expected[i])));
    }
    CHECK(worst < (has_quaternions ? k_tolerance_of_quaternions : k_tolerance) * scale);
  }
}

}  // namespace

TEST_CASE("forces at places of a deep tree go down its links") {
  for (const Named& each : k_on_arm) {
    INFO(each.name);
    compare(std::string(k_arm) + each.text);
  }
  for (const Named& each : k_whole) {
    INFO(each.name);
    compare(std::string(k_rods) + each.text);
  }
}

TEST_CASE("a force beside a particle turns what carries the particle") { compare(k_beside_a_particle); }

TEST_CASE("they do so where something floats, spins or turns freely") { compare(k_ship); }
