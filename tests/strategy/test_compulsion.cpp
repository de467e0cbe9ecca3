// Gauss's function Z_w as emitted: its shape, and its value, which the equations of motion do not feel.

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_compulsion_tolerance = 1e-14;

Real Z_at(EmittedNumbers& emitted, const Vec& free) {
  emitted.bind_accelerations(free);
  return emitted.fields("compulsion").at("Z")[0];
}

/// Of the bare points, up to a term free of accelerations.
Real bare_Z(const BareSystem& bare, const Probe& p, Vec all) {
  all.insert(all.end(), bare.held_acceleration.begin(), bare.held_acceleration.end());
  Real Z = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Z += p.linear[i] * all[i];
    for (std::size_t j = 0; j < all.size(); ++j) Z += p.G[i][j] * all[i] * all[j] / 2;
  }
  return Z;
}

}  // namespace

TEST_CASE("from one candidate acceleration to another, the emitted Z changes as that of bare points") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(8);
    EmittedNumbers emitted(c);
    const Probe p = probe(c.bare);
    const Vec still(c.bare.free_count, 0);
    INFO(model.name);
    for (std::size_t i = 0; i < c.bare.free_count; ++i) {
      Vec moved = still;
      for (std::size_t j = 0; j <= i; ++j) moved[j] = Real(j + 2) / (i + 3);
      CHECK(deviation(Z_at(emitted, moved) - Z_at(emitted, still),
                      bare_Z(c.bare, p, moved) - bare_Z(c.bare, p, still)) < k_compulsion_tolerance);
    }
  }
}

TEST_CASE("where coordinates span all of space, 2 Z_w is the square of the reactions, R_i R_j over the dual basis") {
  const Case c = case_of("skew_chart", 9);
  EmittedNumbers emitted(c);
  const Probe p = probe(c.bare);
  const Motion motion = minimise(c.bare, p);
  const Mat inverse_metric = inverse(p.G);
  const std::size_t n = c.bare.free_count;
  Real twice = 0;
  for (std::size_t i = 0; i < motion.R_x.size(); ++i) {
    for (std::size_t j = 0; j < motion.R_x.size(); ++j)
      twice += inverse_metric[n + i][n + j] * motion.R_x[i] * motion.R_x[j];
  }
  REQUIRE(twice > 0.1);
  CHECK(deviation(Z_at(emitted, motion.accelerations), twice / 2) < k_compulsion_tolerance);
}

// A spinning body with products of inertia, under a field, a potential and a torque: it departs from free motion by nothing.
TEST_CASE("Z of an unconstrained body vanishes along its motion") {
  for (const char* frame : {"body", "space"}) {
    Case c{model_of_text(std::string("gauss: 1\nname: m\n"
                                     "coordinates: {x: {}, y: {}, z: {}}\n"
                                     "orientations:\n"
                                     "  attitude:\n"
                                     "    quaternion: [e0, e1, e2, e3]\n"
                                     "    angular_velocity: [wx, wy, wz]\n"
                                     "    frame: ") +
                         frame +
                         "\n"
                         "    initial: [1, 0, 0, 0]\n"
                         "bodies:\n"
                         "  top: {mass: 2, inertia: [[2, 0.1, 0.2], [0.1, 2.2, 0.3], [0.2, 0.3, 1.4]],"
                         " position: [x + y/2, y, z], orientation: attitude}\n"
                         "forces:\n"
                         "  gravity: {uniform: [1, 0, -9.81]}\n"
                         "  spring: {potential: 3*x^2 + e1*x}\n"
                         "  motor: {generalized: {wy: 4, z: -dot(x)}}\n"),
           {},
           {}};
    for (const char* name : {"x", "y", "z", "x_dot", "y_dot", "z_dot", "wx", "wy", "wz"}) {
      c.values[name] = Real(1 + static_cast<int>(c.values.size())) / 3;
    }
    for (const char* name : {"e0", "e1", "e2", "e3"}) c.values[name] = Real(1) / 2;
    c.values["t"] = 0;
    EmittedNumbers emitted(c);
    const Vec motion = emitted(emitted.mechanics().solution.accelerations);
    INFO(frame);
    CHECK(abs(Z_at(emitted, motion)) < k_compulsion_tolerance);
    CHECK(Z_at(emitted, Vec(6, 0)) > 1);
  }
}

// Then G has no inverse, and forces along held coordinates stay out of Z.
TEST_CASE("Z has its shape where two held coordinates do the same") {
  Case c{model_of_text("gauss: 1\nname: m\n"
                       "coordinates: {x: {}, u: {held_at: 0.1}, w: {held_at: t}}\n"
                       "particles: {bead: {mass: 2, position: [x, u + w, 0]}}\n"
                       "forces: {push: {generalized: {x: 4, u: 3}}}\n"),
         {{"x", 1}, {"x_dot", 2}, {"t", 0}},
         {}};
  EmittedNumbers emitted(c);
  // Z = (2/2) (a - 4/2)²
  CHECK(deviation(Z_at(emitted, {Real(2)}), Real(0)) < k_compulsion_tolerance);
  CHECK(deviation(Z_at(emitted, {Real(5)}), Real(9)) < k_compulsion_tolerance);
}

namespace {

/// A bead on a table that turns, x and y along the table: the angle moves it as they do. How the table is tilted decides whether any
/// form of the expressions shows that.
Case bead_on_table(const std::string& turn, const std::string& more, const char* tilt) {
  return {model_of_text("gauss: 1\nname: m\ncoordinates: {turn: {" + turn + "}, x: {}, y: {}}\n" +
                        "frames:\n  plane: {orientation: {axis: " + tilt + ", angle: 0.7}}\n" +
                        "  table: {parent: plane, orientation: {axis: z, angle: turn}}\n"
                        "particles: {bead: {mass: 2, frame: table, centre: [x, y, 0]}}\n"
                        "forces: {motor: {generalized: {turn: 3}}}\n" +
                        more),
          {{"t", 0},
           {"turn", Real(1) / 5},
           {"turn_dot", Real(7) / 10},
           {"x", Real(3) / 10},
           {"y", Real(1) / 10},
           {"x_dot", Real(1) / 5},
           {"y_dot", Real(1) / 5}},
          {}};
}

// Where only the table is driven: what Coriolis and centrifugal forces say.
const Vec k_relative_motion{Real(49) / 100 * 3 / 10 + Real(14) / 10 / 5, Real(49) / 100 / 10 - Real(14) / 10 / 5};

}  // namespace

// A drive of the table does nothing to the bead, which departs from free motion by nothing.
TEST_CASE("forces along a held coordinate stay out of Z where free ones describe the same motion") {
  for (const char* tilt : {"z", "[1, 2, 3]"}) {
    const Case c = bead_on_table("held_at: 0.7*t + 0.2", "", tilt);
    EmittedNumbers emitted(c);
    INFO(tilt);
    CHECK(deviation(emitted(emitted.mechanics().solution.accelerations), k_relative_motion) < k_compulsion_tolerance);
    CHECK(abs(Z_at(emitted, k_relative_motion)) < k_compulsion_tolerance);
    CHECK(deviation(Z_at(emitted, {k_relative_motion[0] + 1, k_relative_motion[1]}), Real(1)) < k_compulsion_tolerance);
    CHECK(emitted.fields("reaction_forces").count("turn.force_on_bead") == 0);
  }
}

TEST_CASE(
    "accelerations are found where only a constraint tells coordinates apart, and there is no Z for a force along "
    "them") {
  for (const char* tilt : {"z", "[1, 2, 3]"}) {
    for (const bool multipliers : {false, true}) {
      MechanicsOptions options;
      if (multipliers) options.strategy = Strategy::multipliers;
      const Case c = bead_on_table("initial: 0.2", "constraints: {drive: {velocity: dot(turn) - 0.7}}\n", tilt);
      EmittedNumbers emitted(c, options);
      INFO(tilt << ", multipliers " << multipliers);
      Vec found = emitted(emitted.mechanics().solution.accelerations);
      CHECK(deviation(found, {Real(0), k_relative_motion[0], k_relative_motion[1]}) < k_compulsion_tolerance);
      CHECK(deviation(emitted(emitted.mechanics().solution.multipliers), {Real(-3)}) < k_compulsion_tolerance);
      CHECK(emitted.troubles("rhs").empty());
      CHECK(emitted.troubles("project").empty());
      CHECK(build_artefact("compulsion", emitted.mechanics()).empty());
    }
  }
}
