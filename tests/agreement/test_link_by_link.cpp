// What follows link by link is what follows from the sums over bodies of what all coordinates do to them: in fifty digits, at random states.

#include <algorithm>
#include <map>

#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "ir/cost.hpp"
#include "model_files.hpp"
#include "models.hpp"
#include "strategy/composite_metric.hpp"
#include "strategy/compulsion.hpp"
#include "strategy/joint_reactions.hpp"
#include "strategy/link_compulsion.hpp"
#include "strategy/link_energy.hpp"
#include "strategy/tree_motion.hpp"

namespace {

using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::Strategy;
using gaussgen::evaluate::Arithmetic;
using gaussgen::ir::Expr;
using gaussgen::ir::NodeId;
using gaussgen::strategy::JointReaction;
using gaussgen::strategy::Steps;
using gaussgen::strategy::Vector;

/// Forces along its coordinates, which no body feels, and a constraint.
constexpr const char* k_sprung_arm = "../tests/agreement/sprung_arm";

constexpr int k_states = 3;
constexpr double k_tolerance = 1e-35;  ///< of fifty digits
constexpr double k_tolerance_of_quaternions =
    1e-13;  ///< their length is 1 to double precision, which both use where they like

/// Two ways to the same values.
struct Pair {
  std::string what;
  std::vector<NodeId> links, bodies;
};

Vector candidate_of(Mechanics& mechanics) {
  Vector result;
  for (const auto& speed : mechanics.symbols.speeds) result.push_back(mechanics.expressions.symbol(speed.acceleration));
  return result;
}

void add(Vector& values, const gaussgen::ir::Vector3& v) { values.insert(values.end(), v.begin(), v.end()); }

std::vector<NodeId> ids(const Vector& values) {
  std::vector<NodeId> result;
  for (const Expr value : values) result.push_back(value.id());
  return result;
}

Pair metric(Mechanics& mechanics) {
  Steps steps;
  const auto& dynamics = mechanics.dynamics;
  const auto g = gaussgen::strategy::composite_metric(*mechanics.linkage, dynamics.labels, mechanics.graph, steps);
  Vector links, bodies;
  for (std::size_t i = 0; i < dynamics.n(); ++i) {
    links.insert(links.end(), g[i].begin(), g[i].end());
    const auto row = mechanics.symbols.full(gaussgen::kinematics::FreeIndex{i});
    for (const auto j : mechanics.symbols.speeds.indices())
      bodies.push_back(mechanics.covariant->G[row][mechanics.symbols.full(j)]);
  }
  return {"mass matrix", ids(links), ids(bodies)};
}

// Bodies that do not move have a potential, too: its rate has none of it.
Pair energy(Mechanics& mechanics) {
  Steps steps;
  const auto found = gaussgen::strategy::energy_of_links(*mechanics.linkage, mechanics.kinematics.field, steps);
  const Expr of_field = *mechanics.kinematics.potential - *mechanics.kinematics.other_potential;
  return {"energy", ids({found.kinetic, mechanics.expressions.rate(found.of_field)}),
          ids({mechanics.covariant->kinetic_energy, mechanics.expressions.rate(of_field)})};
}

std::optional<Pair> compulsion(Mechanics& mechanics) {
  Steps steps;
  const Vector candidate = candidate_of(mechanics);
  const auto links = gaussgen::strategy::compulsion_of_links(mechanics.dynamics, *mechanics.linkage, candidate,
                                                             mechanics.epsilon(), steps);
  if (!links) return std::nullopt;
  const auto bodies = gaussgen::strategy::compulsion(mechanics.dynamics, candidate, mechanics.epsilon(), steps);
  return Pair{"compulsion", ids({links->Z}), ids({bodies->Z})};
}

std::vector<NodeId> wrenches(Mechanics& mechanics, const gaussgen::strategy::Solution& solution) {
  Steps steps;
  Vector values;
  for (const JointReaction& reaction :
       gaussgen::strategy::joint_reactions(mechanics.model, mechanics.dynamics, solution, steps)) {
    add(values, reaction.force);
    add(values, reaction.moment);
  }
  return ids(values);
}

std::optional<Pair> joints(Mechanics& mechanics) {
  if (!mechanics.solution.motion || mechanics.model.joints.empty()) return std::nullopt;
  gaussgen::strategy::Solution without_links = mechanics.solution;
  without_links.motion.reset();
  return Pair{"joint reactions", wrenches(mechanics, mechanics.solution), wrenches(mechanics, without_links)};
}

class Comparison {
 public:
  explicit Comparison(Mechanics& mechanics)
      : mechanics_(mechanics), evaluator_(mechanics.graph, Arithmetic<cl_F>(50)), states_(mechanics.symbols, 7) {
    gaussgen::bind_parameters(mechanics, evaluator_);
  }

  void run(const Pair& pair) {
    REQUIRE(pair.links.size() == pair.bodies.size());
    for (int k = 0; k < k_states; ++k) {
      agreement::bind(mechanics_.symbols, states_.next(), evaluator_);
      for (const auto& speed : mechanics_.symbols.speeds)
        evaluator_.bind(speed.acceleration, agreement::as(evaluator_.arithmetic(), states_.uniform(-3, 3)));
      INFO(pair.what);
      const bool has_quaternions = !mechanics_.symbols.first_quaternion_component.empty();
      CHECK(deviation(pair) < (has_quaternions ? k_tolerance_of_quaternions : k_tolerance));
    }
  }

 private:
  /// Relative to the largest of the values; none where the state has none, as at a pole.
  double deviation(const Pair& pair) {
    double worst = 0, scale = 1e-3;
    for (std::size_t i = 0; i < pair.links.size(); ++i) {
      const auto a = evaluator_(pair.links[i]), b = evaluator_(pair.bodies[i]);
      if (!a || !b) return 0;
      worst = std::max(worst, gaussgen::evaluate::to_double(cln::abs(*a - *b)));
      scale = std::max(scale, gaussgen::evaluate::to_double(cln::abs(*b)));
    }
    return worst / scale;
  }

  Mechanics& mechanics_;
  gaussgen::evaluate::Evaluator<cl_F> evaluator_;
  agreement::RandomStates states_;
};

/// How many of them a model has.
std::vector<std::string> compared(const std::string& file, bool is_folded) {
  INFO(file);
  const gaussgen::model::Model model = agreement::load(file);
  Mechanics mechanics(model, {is_folded, Strategy::tree});
  std::vector<std::string> done;
  if (mechanics.dynamics.n() == 0) return done;
  std::vector<Pair> pairs{metric(mechanics), energy(mechanics)};
  if (auto pair = compulsion(mechanics)) pairs.push_back(std::move(*pair));
  if (auto pair = joints(mechanics)) pairs.push_back(std::move(*pair));
  Comparison comparison(mechanics);
  for (const Pair& pair : pairs) {
    comparison.run(pair);
    done.push_back(pair.what);
  }
  return done;
}

/// Of the compulsion of a chain with a spring along each hinge.
int operations_of_sprung_chain(int n) {
  const std::string count = std::to_string(n);
  gaussgen::support::Source source("chain.yaml", "gauss: 1\nname: chain\ncounts: {n: " + count + "}\n" +
                                                     R"(
parameters: {m: 1.3, L: 0.7, J: 0.05, g: 9.81, k: 9}
joints:
  hinge_1: {type: revolute, child: link_1, axis: y, coordinates: q_1, initial: 0.3}
  hinge_$(i+1): {count: $(n-1), type: revolute, parent: link_$i, child: link_$(i+1), at: [0, 0, -L], axis: y, coordinates: q_$(i+1), initial: 0.1}
bodies:
  body_$i: {count: n, frame: link_$i, mass: m, inertia: J, centre: [0, 0, -L/2]}
forces:
  gravity: {uniform: [0, 0, -g]}
  spring_$i: {count: n, spring: q_$i, stiffness: k}
)");
  gaussgen::support::Diagnostics diagnostics;
  const auto model = gaussgen::read_model(source, diagnostics);
  REQUIRE(model);
  Mechanics mechanics(*model, {true, Strategy::tree});
  Steps steps;
  const auto found = gaussgen::strategy::compulsion_of_links(mechanics.dynamics, *mechanics.linkage,
                                                             candidate_of(mechanics), mechanics.epsilon(), steps);
  REQUIRE(found);
  return gaussgen::ir::operations(mechanics.graph, {found->Z.id(), found->singular_metric.id()});
}

std::vector<std::string> all_files() {
  std::vector<std::string> files = agreement::model_files();
  for (const char* family : {"floating_chain", "n_four_bar", "planar_chain_absolute", "planar_chain_maximal", "planar_pendulum",
                             "planar_chain_relative", "quadruped", "road_train", "spatial_chain", "tree"}) {
    files.push_back(std::string("families/") + family);
  }
  files.emplace_back(k_sprung_arm);
  for (const char* own : {"uneven_bars", "slanted_arm", "loops_on_arm"}) files.push_back(std::string("../tests/agreement/") + own);
  return files;
}

}  // namespace

TEST_CASE("what follows link by link is what follows from sums over bodies") {
  for (const bool is_folded : {false, true}) {
    std::map<std::string, int> count;
    for (const std::string& file : all_files()) {
      const std::vector<std::string> done = compared(file, is_folded);
      for (const std::string& what : done) ++count[what];
      if (file == k_sprung_arm) CHECK(std::count(done.begin(), done.end(), "compulsion") == 1);
    }
    CHECK(count["mass matrix"] > 40);
    CHECK(count["compulsion"] > 20);
    CHECK(count["joint reactions"] > 15);
  }
}

TEST_CASE(
    "the compulsion of a chain with springs along its hinges takes operations that grow with the number of links") {
  const int ten = operations_of_sprung_chain(10), twenty = operations_of_sprung_chain(20),
            forty = operations_of_sprung_chain(40);
  CHECK(forty - twenty <= 2.05 * (twenty - ten));
}
