// Energy and residuals against bare points.

#include "catch_shim.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_state_tolerance = 1e-15;  // difference quotients: 1e-24 of the derivatives

}  // namespace

TEST_CASE("energies are the sums over bare points, uniform fields and potentials included") {
  for (const BareModel& model : bare_models()) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case c = model.at(seed);
      EmittedNumbers emitted(c);
      const Real T = kinetic_energy(c.bare);
      const Real V = potential_energy(c.bare);
      auto energy = emitted.fields("energy");
      INFO(model.name << ", seed " << seed);
      CHECK(deviation(energy.at("kinetic"), {T}) < k_state_tolerance);
      CHECK(deviation(energy.at("potential"), {V}) < k_state_tolerance);
      CHECK(deviation(energy.at("total"), {T + V}) < k_state_tolerance);
    }
  }
}

TEST_CASE("residuals are phi and its difference quotient along any candidate acceleration") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(4);
    if (!c.bare.constraints) continue;
    EmittedNumbers emitted(c);
    const Probe p = probe(c.bare);
    Vec all;
    for (std::size_t i = 0; i < c.bare.free_count; ++i) all.push_back(Real(i + 1) / 7);
    emitted.bind_accelerations(all);
    all.insert(all.end(), c.bare.held_acceleration.begin(), c.bare.held_acceleration.end());
    Vec phi_dot = p.drift;
    for (std::size_t mu = 0; mu < phi_dot.size(); ++mu) {
      for (std::size_t A = 0; A < all.size(); ++A) phi_dot[mu] += p.beta[mu][A] * all[A];
    }
    auto residuals = emitted.fields("residuals");
    INFO(model.name);
    CHECK(deviation(residuals.at("velocity"), c.bare.constraints(c.bare.y, c.bare.rate, c.bare.t)) < k_state_tolerance);
    CHECK(deviation(residuals.at("acceleration"), phi_dot) < k_state_tolerance);
  }
}

TEST_CASE("the residual of a quaternion is the squared norm of the quaternion, less 1") {
  for (const char* name : {"sphere_in_cylinder_quaternion", "released_top"}) {
    Case c = case_of(name, 5);
    for (const auto& component : c.model.orientations[0].quaternion) c.values.at(component.text) *= Real("1.5");
    EmittedNumbers emitted(c);
    emitted.bind_accelerations(Vec(c.bare.free_count, 0));
    CHECK(deviation(emitted.fields("residuals").at("quaternion"), {Real("1.25")}) < k_state_tolerance);
  }
}
