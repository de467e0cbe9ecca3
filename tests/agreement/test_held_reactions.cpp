// Reactions of held coordinates: by virtual work where they move frames they are those of the metric over all coordinates, in fifty digits,
// and they are what changes momentum and energy.

#include <algorithm>

#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "ir/contract.hpp"
#include "ir/differentiate.hpp"
#include "models.hpp"
#include "newton/random_mechanism.hpp"
#include "strategy/body_reactions.hpp"
#include "strategy/held_reactions.hpp"
#include "strategy/joint_reactions.hpp"

namespace {

using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::Strategy;
using gaussgen::evaluate::Arithmetic;
using gaussgen::ir::Expr;
using gaussgen::strategy::Steps;
using gaussgen::strategy::Vector;

constexpr double k_tolerance = 1e-35;  ///< of fifty digits
constexpr double k_tolerance_of_quaternions =
    1e-13;  ///< their length is 1 to double precision, which both use where they like
constexpr int k_states = 3;

struct Named {
  const char* name;
  const char* text;  ///< of the model, but for what all have
};

constexpr const char* k_common = R"(gauss: 1
name: held
parameters: {m: 1.3, L: 0.7, J: 0.05, g: 9.81, k: 9, c: 0.4}
)";

/// Two links that hang on the frame `base`.
constexpr const char* k_two_links = R"(
joints:
  h1: {type: revolute, parent: base, child: a, at: [0.1, 0, -0.2], axis: y, coordinates: p, initial: 0.3}
  h2: {type: universal, parent: a, child: b, at: [0, 0.1, -L], axes: [x, [1, 2, 2]], coordinates: [q, r]}
bodies:
  a: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.02, 0, -L/2]}
  b: {mass: 0.6, inertia: [[0.03, 0.002, -0.001], [0.002, 0.04, 0.003], [-0.001, 0.003, 0.02]], centre: [0, 0.1, -L/3]}
points:
  tip: {on: b, at: [0.1, 0.2, 0.3]}
  nail: {on: space, at: [1, 0.5, 0.2]}
)";

const Named k_on_two_links[] = {
    {"translation", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}}
frames: {base: {position: [x, 0.3, 0]}}
forces: {gravity: {uniform: [0.4, 0, -g]}}
)"},
    {"turn about a slanted axis, spring and damper along it", R"(
coordinates: {w: {held_at: t + 0.2*sin(3*t)}}
frames: {base: {position: [0.1, 0, 0], orientation: {axis: [1, 1, 2], angle: w}}}
forces: {gravity: {uniform: [0, 0, -g]}, coil: {spring: w, stiffness: k, rest: 0.3*t, damping: c}}
)"},
    {"translation and turns of one frame, together with each other", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, y: {held_at: 0.3}, w: {held_at: 2*t}}
frames: {base: {position: [x*cos(w), x*y, t*y], orientation: {euler: zxy, angles: [w, x*y, 0.2]}}}
forces: {gravity: {uniform: [0, 0, -g]}, couple: {potential: k*x*p*sin(w)}, motor: {generalized: {w: 3 - c*dot(p), p: 0.3}}}
)"},
    {"several in series, loads at places on all of them, between them and on space", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, w: {held_at: 0.4*t}, z: {held_at: 0}}
frames:
  trolley: {position: [x, 0, 0.1]}
  arm: {parent: trolley, position: [0, L, 0], orientation: {axis: z, angle: w}}
  lift: {parent: arm, position: [0, 0, z]}
  base: {parent: lift, position: [0.3, 0.1, 0], orientation: {axis: x, angle: 0.3}}
forces:
  gravity: {uniform: [0, 0, -g]}
  push: {force: [1, 2*p, dot(q)], on: b, at: [0.1, 0, 0.2], in: arm}
  pull: {force: [2, 0.3, 1], on: a, at: [0, 0.1, 0], from: trolley}
  twist: {torque: [0.3, 1, 2], on: a, in: b, from: arm}
  on_lift: {force: [0.3, 1, 2], on: lift, at: [0.3, 0, 0.1]}
  rope: {spring: [tip, nail], stiffness: k, length: 0.3, damping: c}
)"},
    {"a body on the held frame, free motion in the same frame", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, s: {initial: 0.3}}
frames: {base: {position: [x*cos(s), x*sin(s), 0.1*s], orientation: {axis: z, angle: s + 2*x}}}
particles: {weight: {mass: 2, frame: base, centre: [0.1, 0.2, 0]}}
forces: {gravity: {uniform: [0, 0, -g]}, spring: {spring: s, stiffness: k}}
)"},
    {"constraints on places and on rates", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, w: {held_at: 0.4*t}}
frames:
  trolley: {position: [x, 0, 0.1]}
  base: {parent: trolley, position: [0, 0.2, 0], orientation: {axis: z, angle: w}}
constraints:
  rod: {distance: [tip, nail], is: L + 0.1*sin(t)}
  gear: {velocity: dot(p) - 2*dot(w) + 0.3*dot(x)}
forces: {gravity: {uniform: [0, 0, -g]}}
)"},
    {"a point without mass that wanders over a body as held", R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, w: {held_at: 0.4*t}}
frames:
  base: {orientation: {axis: z, angle: w}}
  slider: {parent: a, position: [0.1, x, -x^2]}
forces:
  gravity: {uniform: [0, 0, -g]}
  push: {force: [1, 2, 3], on: slider, at: [0, 0.1, 0]}
  rope: {spring: [slider, nail], stiffness: k, length: 0.3, damping: c}
)"},
};

const Named k_whole[] = {
    {"a crank that is driven, and closes a loop", R"(
coordinates: {w: {held_at: 5*t + 0.1*sin(t)}}
joints:
  crank: {type: revolute, child: l1, axis: y, coordinates: w}
  pin: {type: revolute, parent: l1, child: l2, at: [0, 0, 0.3], axis: y, coordinates: q2, initial_guess: 1}
  rocker: {type: revolute, child: l3, at: [0.9, 0, 0], axis: y, coordinates: q3, initial_guess: 0.2}
bodies:
  l1: {mass: 1, inertia: J, centre: [0, 0, 0.15]}
  l2: {mass: 2, inertia: J, centre: [0, 0, 0.4]}
  l3: {mass: m, inertia: J, centre: [0, 0, 0.3]}
points: {e: {on: l2, at: [0, 0, 0.8]}, f: {on: l3, at: [0, 0, 0.6]}}
constraints: {loop: {coincide: [e, f]}}
forces: {gravity: {uniform: [0, 0, -g]}}
)"},
    {"held joints between free ones, and a branch", R"(
coordinates: {w: {held_at: sin(t)}, s: {held_at: 0.3*cos(2*t)}}
joints:
  h1: {type: spherical, child: l1, at: [0.1, 0, 0.2]}
  h2: {type: revolute, parent: l1, child: l2, at: [0, 0, -L], axis: [1, 0, 1], coordinates: w}
  h3: {type: revolute, parent: l2, child: l3, at: [0, 0.1, -L], axis: y, coordinates: q3}
  h4: {type: prismatic, parent: l1, child: l4, at: [0.2, 0, 0], axis: [0, 1, 2], coordinates: s}
  h5: {type: spherical, parent: l4, child: l5, at: [0, 0.3, 0]}
bodies:
  l1: {mass: 1, inertia: [J, 1.2*J, 0.4*J], centre: [0, 0, 0.15]}
  l2: {mass: 2, inertia: J, centre: [0, 0, 0.4]}
  l3: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.1, 0, 0.3]}
  l4: {mass: 0.4, inertia: J}
  l5: {mass: 0.7, inertia: [J, 1.2*J, 0.4*J], centre: [0.1, 0, 0.3]}
forces: {gravity: {uniform: [0, 0, -g]}, wind: {force: [1, 2, 3], on: l5, at: [0, 0.2, 0]}}
)"},
    {"a ball on a table without mass that turns and rises", R"(
coordinates: {w: {held_at: 2*t}, h: {held_at: 0.1*sin(t)}, z: {held_at: 0.2 + 0.1*sin(t)}, x: {initial: 0.3}, y: {initial: 0.1}}
joints: {axle: {type: cylindrical, child: table, axis: z, coordinates: [h, w]}}
orientations: {e: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz]}}
bodies: {ball: {mass: m, inertia: J, position: [x, y, z], orientation: e}}
constraints: {contact: {rolls: ball, on: table, at: [x, y, h]}}
forces: {gravity: {uniform: [0.3, 0, -g]}}
)"},
};

/// Of links between which a frame neither moves nor leads anywhere.
constexpr const char* k_weld = R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, z: {held_at: 0}}
frames:
  base: {position: [x, 0, 0]}
  elbow: {parent: a, position: [0, 0.2, -L]}
  shelf: {parent: plate, position: [0, 0, z]}
joints:
  h1: {type: revolute, parent: base, child: a, axis: y, coordinates: p}
  weld: {type: fixed, parent: elbow, child: plate}
  again: {type: fixed, parent: shelf, child: second}
  h2: {type: universal, parent: second, child: b, at: [0.1, 0, -L/2], axes: [x, y], coordinates: [q, r]}
bodies:
  a: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.02, 0, -L/2]}
  b: {mass: 0.6, inertia: [J, 1.2*J, 0.4*J], centre: [0, 0.1, -L/3]}
forces: {gravity: {uniform: [0, 0, -g]}}
)";

std::optional<gaussgen::model::Model> parsed(const std::string& text, std::string& why) {
  gaussgen::support::Source source("held.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  if (!model) why = gaussgen::support::render(diagnostics, source);
  return model;
}

gaussgen::model::Model model_of(const std::string& text) {
  std::string why;
  auto model = parsed(k_common + text, why);
  INFO(why);
  REQUIRE(model);
  return *model;
}

class Numbers {
 public:
  explicit Numbers(Mechanics& mechanics)
      : mechanics_(mechanics), evaluator_(mechanics.graph, Arithmetic<cl_F>(50)), states_(mechanics.symbols, 5) {
    gaussgen::bind_parameters(mechanics, evaluator_);
    for (const auto& input : mechanics.symbols.inputs) evaluator_.bind(input, number(0.7));
  }

  /// Whether accelerations and multipliers are to be trusted there.
  bool next_state() {
    agreement::bind(mechanics_.symbols, states_.next(), evaluator_);
    const auto is_false = [&](Expr condition) {
      const auto value = evaluator_(condition.id());
      return value && cln::zerop(*value);
    };
    return is_false(mechanics_.solution.singular_mass_matrix) && is_false(mechanics_.solution.dependent_constraints);
  }

  /// Relative to the largest of `b`; none where the state has none, as at a pole.
  double deviation(const Vector& a, const Vector& b) {
    REQUIRE(a.size() == b.size());
    double worst = 0, scale = 1e-3;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto x = evaluator_(a[i].id()), y = evaluator_(b[i].id());
      if (!x || !y) return 0;
      worst = std::max(worst, gaussgen::evaluate::to_double(cln::abs(*x - *y)));
      scale = std::max(scale, gaussgen::evaluate::to_double(cln::abs(*y)));
    }
    return worst / scale;
  }

  double tolerance() const {
    return mechanics_.symbols.first_quaternion_component.empty() ? k_tolerance : k_tolerance_of_quaternions;
  }

 private:
  cl_F number(double value) const { return agreement::as(evaluator_.arithmetic(), value); }

  Mechanics& mechanics_;
  gaussgen::evaluate::Evaluator<cl_F> evaluator_;
  agreement::RandomStates states_;
};

/// In how many states.
int compared(Mechanics& mechanics, const Vector& links, const Vector& bodies) {
  Numbers numbers(mechanics);
  int states = 0;
  for (int k = 0; k < k_states; ++k) {
    if (!numbers.next_state()) continue;
    CHECK(numbers.deviation(links, bodies) < numbers.tolerance());
    ++states;
  }
  return states;
}

/// In how many states both forms are there.
int agreeing(const gaussgen::model::Model& model) {
  Mechanics mechanics(model, {true, Strategy::tree});
  if (mechanics.symbols.held.values().empty()) return 0;
  Steps steps;
  const auto links = held_reactions_by_links(mechanics.model, mechanics.dynamics, mechanics.solution, steps);
  if (!links) return 0;
  return compared(mechanics, *links, held_reactions_by_metric(mechanics.dynamics, mechanics.solution, steps));
}

Vector wrenches(Mechanics& mechanics, const gaussgen::strategy::Solution& solution) {
  Steps steps;
  Vector values;
  for (const auto& joint : joint_reactions(mechanics.model, mechanics.dynamics, solution, steps)) {
    values.insert(values.end(), joint.force.begin(), joint.force.end());
    values.insert(values.end(), joint.moment.begin(), joint.moment.end());
  }
  return values;
}

Vector values_of(const std::vector<gaussgen::strategy::BodyReaction>& reactions) {
  Vector values;
  for (const auto& body : reactions) {
    values.insert(values.end(), body.force.begin(), body.force.end());
    if (body.moment) values.insert(values.end(), body.moment->begin(), body.moment->end());
  }
  return values;
}

/// Of what bodies feel, in how many states both forms are there.
int agreeing_on_bodies(const gaussgen::model::Model& model) {
  Mechanics mechanics(model, {true, Strategy::tree});
  Steps steps;
  const auto links = body_reactions_by_links(mechanics.model, mechanics.dynamics, mechanics.solution, steps);
  if (!links) return 0;
  const auto speeds = body_reactions_by_speeds(mechanics.dynamics, mechanics.solution, steps);
  return compared(mechanics, values_of(*links), values_of(speeds));
}

/// Three links of a chain in space on a pivot that is shaken and turns, without damping.
constexpr const char* k_shaken = R"(
coordinates: {x: {held_at: 0.2*sin(3*t)}, y: {held_at: 0.1*cos(t)}, z: {held_at: 0.3*t}, w: {held_at: 2*t + 0.1*sin(3*t)}}
frames: {base: {position: [x, y, z], orientation: {axis: z, angle: w}}}
joints:
  h1: {type: universal, parent: base, child: a, axes: [x, y], coordinates: [p, q]}
  h2: {type: revolute, parent: a, child: b, at: [0, 0, -L], axis: [1, 1, 2], coordinates: r}
  h3: {type: universal, parent: b, child: d, at: [0, 0, -L], axes: [y, x], coordinates: [s, u]}
bodies:
  a: {mass: m, inertia: [J, 1.2*J, 0.4*J], centre: [0.02, 0, -L/2]}
  b: {mass: 0.6, inertia: [J, 1.2*J, 0.4*J], centre: [0, 0.1, -L/3]}
  d: {mass: 0.9, inertia: [J, 1.2*J, 0.4*J], centre: [0, 0.1, -L/3]}
forces: {gravity: {uniform: [0, 0, -g]}, spring: {spring: r, stiffness: k}}
)";

/// Along the motion.
Expr rate(Mechanics& mechanics, Expr e) {
  Expr result = mechanics.expressions.rate(e);
  for (const auto i : mechanics.symbols.speeds.indices())
    result += gaussgen::ir::partial(e, mechanics.symbols.speeds[i].symbol) * mechanics.solution.accelerations[i.value];
  return result;
}

}  // namespace

TEST_CASE("reactions by virtual work where held coordinates move frames are those by the metric") {
  for (const Named& each : k_on_two_links) {
    INFO(each.name);
    CHECK(agreeing(model_of(std::string(each.text) + k_two_links)) == k_states);
  }
  for (const Named& each : k_whole) {
    INFO(each.name);
    CHECK(agreeing(model_of(each.text)) == k_states);
  }
}

TEST_CASE("they agree on mechanisms that nobody chose") {
  int mechanisms = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    INFO("seed " << seed);
    std::string why;
    const auto model = parsed(agreement::newton::random_mechanism(seed), why);
    if (model && agreeing(*model) > 0) ++mechanisms;
  }
  CHECK(mechanisms > 40);
}

TEST_CASE("what bodies feel by the accelerations of links is what they feel by those along speeds") {
  for (const Named& each : k_on_two_links) {
    INFO(each.name);
    CHECK(agreeing_on_bodies(model_of(std::string(each.text) + k_two_links)) == k_states);
  }
  CHECK(agreeing_on_bodies(model_of(k_weld)) == k_states);
  int mechanisms = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    INFO("seed " << seed);
    std::string why;
    const auto model = parsed(agreement::newton::random_mechanism(seed), why);
    if (model && agreeing_on_bodies(*model) > 0) ++mechanisms;
  }
  CHECK(mechanisms > 60);
}

TEST_CASE("a frame that neither moves nor leads anywhere takes its moment about where the link before ends") {
  const auto model = model_of(k_weld);
  CHECK(agreeing(model) == k_states);
  Mechanics mechanics(model, {true, Strategy::tree});
  REQUIRE(mechanics.solution.motion);
  gaussgen::strategy::Solution without_links = mechanics.solution;
  without_links.motion.reset();
  CHECK(compared(mechanics, wrenches(mechanics, mechanics.solution), wrenches(mechanics, without_links)) == k_states);
}

TEST_CASE("what holds a pivot along x, y, z changes the momentum of a chain on it, less its weight") {
  const auto model = model_of(k_shaken);
  Mechanics mechanics(model, {true, Strategy::tree});
  Steps steps;
  const auto R = held_reactions_by_links(mechanics.model, mechanics.dynamics, mechanics.solution, steps);
  REQUIRE(R);
  Vector forces;
  for (std::size_t i = 0; i < 3; ++i) {
    Expr force = mechanics.expressions.number(0);
    for (const auto& body : *mechanics.kinematics.bodies)
      force += body.mass * (rate(mechanics, body.velocity[i]) - mechanics.kinematics.field[i]);
    forces.push_back(force);
  }
  Numbers numbers(mechanics);
  for (int k = 0; k < k_states; ++k) {
    REQUIRE(numbers.next_state());
    CHECK(numbers.deviation(Vector(R->begin(), R->begin() + 3), forces) < k_tolerance);
  }
}

TEST_CASE("the power of what holds a pivot is the rate of the energy of a chain on it") {
  const auto model = model_of(k_shaken);
  Mechanics mechanics(model, {true, Strategy::tree});
  Steps steps;
  const auto R = held_reactions_by_links(mechanics.model, mechanics.dynamics, mechanics.solution, steps);
  REQUIRE(R);
  Expr power = mechanics.expressions.number(0);
  for (const auto j : mechanics.symbols.held.indices()) {
    const auto& held = mechanics.model.coordinates[mechanics.symbols.held[j].model_index];
    power += (*R)[j.value] * mechanics.expressions.rate(mechanics.expressions(*held.held_at));
  }
  const Expr energy = mechanics.covariant->kinetic_energy + *mechanics.kinematics.potential;
  Numbers numbers(mechanics);
  for (int k = 0; k < k_states; ++k) {
    REQUIRE(numbers.next_state());
    CHECK(numbers.deviation({power}, {rate(mechanics, energy)}) < k_tolerance);
  }
}
