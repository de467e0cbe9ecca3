// Accelerations, multipliers and reactions of the emitted route are those of the least Z of bare points.

#include "catch_shim.hpp"
#include "gauss/oracle/bare_body.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

// Difference quotients of 1e-12 leave an error of 1e-24 of the derivatives; solving multiplies it by the condition of the
// random states, at most 1e8 here.
constexpr double k_motion_tolerance = 1e-14;

Mat numbers(EmittedNumbers& emitted, const strategy::Matrix& matrix) {
  Mat result;
  for (const strategy::Vector& row : matrix) result.push_back(emitted(row));
  return result;
}

/// ė of a quaternion, q̇ of the others.
Vec configuration_rates(const Case& c, const kinematics::Symbols& symbols) {
  Vec rates;
  for (const auto& coordinate : c.model.coordinates) {
    if (!coordinate.held_at) rates.push_back(c.values.at(coordinate.name.text + "_dot"));
  }
  for (const auto& orientation : c.model.orientations) {
    Quaternion e;
    Vec3 omega;
    for (std::size_t i = 0; i < 4; ++i) e[i] = c.values.at(orientation.quaternion[i].text);
    for (std::size_t i = 0; i < 3; ++i) omega[i] = c.values.at(orientation.angular_velocity[i].text);
    const Quaternion rate = quaternion_rate(e, omega, orientation.axes == model::Axes::space);
    rates.insert(rates.end(), rate.begin(), rate.end());
  }
  REQUIRE(rates.size() == symbols.configuration.size());
  return rates;
}

void check_motion(const Case& c, Strategy strategy) {
  EmittedNumbers emitted(c, {false, strategy});
  const Motion motion = minimise(c.bare, probe(c.bare));
  Vec derivative = configuration_rates(c, emitted.mechanics().symbols);
  derivative.insert(derivative.end(), motion.accelerations.begin(), motion.accelerations.end());
  CHECK(deviation(emitted.derivative("rhs"), derivative) < k_motion_tolerance);
  CHECK(emitted.troubles("rhs").empty());
  CHECK(deviation(emitted.derivative("rhs_and_reactions"), derivative) < k_motion_tolerance);
  CHECK(deviation(emitted(emitted.mechanics().solution.multipliers), motion.lambda) < k_motion_tolerance);
  CHECK(deviation(emitted(emitted.mechanics().held_reactions), motion.R_x) < k_motion_tolerance);
}

}  // namespace

TEST_CASE("metric and constraint rows are the second and first difference quotients of bare points") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(1);
    EmittedNumbers emitted(c);
    const strategy::Dynamics& dynamics = emitted.mechanics().dynamics;
    const Probe p = probe(c.bare);
    const Mat g = numbers(emitted, dynamics.g);
    const Mat b = numbers(emitted, dynamics.b);
    const Vec drift = emitted(dynamics.b_drift);
    const Vec flat = emitted.fields("mass_matrix").at("g");
    INFO(model.name);
    for (std::size_t i = 0; i < dynamics.n(); ++i) {
      for (std::size_t j = 0; j < dynamics.n(); ++j) {
        CHECK(deviation(g[i][j], p.G[i][j]) < k_motion_tolerance);
        CHECK(flat.at(i * dynamics.n() + j) == g[i][j]);
      }
    }
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
      Real expected = p.drift[mu];
      for (std::size_t j = dynamics.n(); j < c.bare.y.size(); ++j) {
        expected += p.beta[mu][j] * c.bare.held_acceleration[j - dynamics.n()];
      }
      CHECK(deviation(drift[mu], expected) < k_motion_tolerance);
      for (std::size_t i = 0; i < dynamics.n(); ++i) CHECK(deviation(b[mu][i], p.beta[mu][i]) < k_motion_tolerance);
    }
  }
}

TEST_CASE(
    "the emitted accelerations, multipliers and reactions are those of the least Z of bare points, by each strategy") {
  for (const BareModel& model : bare_models()) {
    for (const Strategy strategy : {Strategy::automatic, Strategy::tree, Strategy::metric, Strategy::multipliers}) {
      for (unsigned seed = 1; seed <= 5; ++seed) {
        INFO(model.name << ", " << name_of(strategy) << ", seed " << seed);
        check_motion(model.at(seed), strategy);
      }
    }
  }
}

TEST_CASE("each function of reactions states lambda, lambda b of every speed and R of every held coordinate") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(6);
    EmittedNumbers emitted(c);
    const Probe p = probe(c.bare);
    const Motion motion = minimise(c.bare, p);
    const Mechanics& mechanics = emitted.mechanics();
    INFO(model.name);
    for (const char* function : {"reactions", "rhs_and_reactions"}) {
      auto fields = emitted.fields(function);
      for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
        const std::string& name = mechanics.dynamics.constraints[mu];
        CHECK(deviation(fields.at(name + ".multiplier"), {motion.lambda[mu]}) < k_motion_tolerance);
        Vec generalized;
        for (std::size_t i = 0; i < mechanics.dynamics.n(); ++i)
          generalized.push_back(motion.lambda[mu] * p.beta[mu][i]);
        CHECK(deviation(fields.at(name + ".generalized"), generalized) < k_motion_tolerance);
      }
      for (const auto i : mechanics.symbols.held.indices()) {
        CHECK(deviation(fields.at(mechanics.symbols.held[i].name + ".generalized"), {motion.R_x[i.value]}) <
              k_motion_tolerance);
      }
    }
  }
}

TEST_CASE("the models contain every way to solve: no constraints, elimination of three coupled speeds, multipliers") {
  const auto description = [](const char* name, Strategy strategy) {
    const Case c = case_of(name, 1);
    EmittedNumbers emitted(c, {false, strategy});
    return emitted.mechanics().solution.description;
  };
  for (const char* name : {"skew_chart", "driven_gyroscope"}) {
    CHECK_THAT(description(name, Strategy::automatic), Catch::StartsWith("Z minimised body by body"));
  }
  CHECK_THAT(description("coupled_drives", Strategy::automatic), Catch::StartsWith("elimination (3.6)-(3.7)"));
  CHECK_THAT(description("driven_gyroscope", Strategy::metric), Catch::StartsWith("multiplier form (3.4)"));
  const Case c = case_of("coupled_drives", 1);
  const Probe p = probe(c.bare);
  // Each row has all three dependent speeds, and an accelerating held coordinate.
  for (const Vec& row : p.beta) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(abs(row[i]) > 0.5);
    CHECK(abs(row[5] * c.bare.held_acceleration[0] + row[6] * c.bare.held_acceleration[1]) > 1e-4);
  }
}

TEST_CASE("dependent speeds are those that the model names, and the motion is the same with any") {
  const std::string text =
      "gauss: 1\nname: m\n"
      "coordinates: {a: {}, b: {}, c: {}}\n"
      "particles: {one: {mass: 2, position: [a, b, c]}}\n"
      "constraints: {plane: {velocity: dot(a) + 2*dot(b) - 3*dot(c) + a*b}}\n"
      "forces: {field: {uniform: [1, 2, 3]}}\n";
  std::vector<Vec> motions;
  for (const std::string speed : {"a", "b", "c"}) {
    Case c{model_of_text(text + "elimination: {dependent: [" + speed + "]}\n"), {}, {}};
    for (const char* name : {"a", "b", "c", "a_dot", "b_dot", "c_dot"})
      c.values[name] = Real(static_cast<int>(c.values.size()) + 1) / 3;
    c.values["t"] = 0;
    EmittedNumbers emitted(c);
    INFO(speed);
    CHECK_THAT(emitted.mechanics().solution.description, Catch::Contains("dependent speeds " + speed + ";"));
    motions.push_back(emitted.derivative("rhs"));
    CHECK(deviation(motions.back(), motions.front()) < k_motion_tolerance);
  }
}

TEST_CASE("a product of parameters is a safe pivot, a difference of them is not: it can vanish without a trace") {
  const auto description = [](const std::string& pivot) {
    Case c{model_of_text("gauss: 1\nname: m\n"
                         "parameters: {p: 3, q: 2}\n"
                         "coordinates: {a: {}, b: {}}\n"
                         "particles: {one: {mass: 2, position: [a, b, 0]}}\n"
                         "constraints: {edge: {velocity: " +
                         pivot + "*dot(a) + sin(b)*dot(b)}}\n"),
           {{"p", 3}, {"q", 2}, {"a", 1}, {"b", 1}, {"a_dot", 1}, {"b_dot", 1}, {"t", 0}},
           {}};
    EmittedNumbers emitted(c, {false, Strategy::metric});
    return emitted.mechanics().solution.description;
  };
  CHECK_THAT(description("p*q"), Catch::StartsWith("elimination (3.6)-(3.7) with dependent speeds a;"));
  CHECK_THAT(description("(p - q)"), Catch::StartsWith("multiplier form (3.4)"));
}
