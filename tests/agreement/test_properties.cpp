// Newton, Euler, d'Alembert and the balance of energy, computed from the model by numbers alone (newton/), against what the
// generator finds.

#include <cstdio>

#include "catch_shim.hpp"
#include "model_files.hpp"
#include "newton/checks.hpp"

namespace {

using agreement::newton::Deviations;
using agreement::newton::Specimen;

constexpr int k_states = 1000;

}  // namespace

TEST_CASE("forces on each body, work along each coordinate and energy balance on 1000 states of every model") {
  std::printf("%-30s %9s %9s %9s %9s %9s %9s %9s %9s   (each / 100 kappa eps)\n", "model", "bodies", "links", "work",
              "reactions", "joints", "dphi/dt", "energy", "power");
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    Specimen specimen(agreement::load(file));
    agreement::RandomStates states(specimen.mechanics.symbols, 1986);
    Deviations worst;
    int left_out = 0;
    for (int i = 0; i < k_states; ++i) {
      if (!specimen.at(states.next())) {
        ++left_out;
        continue;
      }
      worst.take(deviations(specimen) / (100 * agreement::k_eps * specimen.condition));
    }
    std::printf("%-30s %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g\n", file.c_str(), worst.on_bodies, worst.links,
                worst.work, worst.reactions, worst.joints, worst.constraints, worst.energy, worst.power);
    CHECK(worst.is_within(1));
    CHECK(left_out <= k_states / 100);
  }
}
