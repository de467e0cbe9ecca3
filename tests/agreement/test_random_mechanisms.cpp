// The laws of test_properties.cpp on mechanisms that nobody chose. GAUSS_SEED in the environment begins elsewhere.

#include <cstdio>
#include <cstdlib>

#include "catch_shim.hpp"
#include "early_check.hpp"
#include "newton/checks.hpp"
#include "newton/random_mechanism.hpp"
#include "structure_check.hpp"

namespace {

using agreement::newton::Deviations;
using agreement::newton::Specimen;

constexpr unsigned k_mechanisms = 200;
constexpr int k_states = 5;

unsigned first_seed() {
  const char* given = std::getenv("GAUSS_SEED");
  return given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 20261121U;
}

/// Nothing where the front end refuses it, with its reason.
std::optional<gaussgen::model::Model> parsed(const std::string& text, std::string& why) {
  gaussgen::support::Source source("model.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  if (model) gaussgen::check_early(*model, {}, diagnostics);
  if (!diagnostics.has_errors()) return model;
  why = gaussgen::support::render(diagnostics, source);
  return std::nullopt;
}

/// Whether some constraint says nothing, as a rod between two places of one body: `gauss-gen` refuses it.
bool has_idle_constraint(Specimen& specimen) {
  gaussgen::support::Diagnostics diagnostics;
  gaussgen::check_structure(specimen.mechanics, diagnostics);
  return diagnostics.has_errors();
}

struct Count {
  int refused = 0;
  int states = 0;
  int ill_conditioned = 0;
  int with_joint_work = 0;
};

Deviations examine(const gaussgen::model::Model& model, unsigned seed, Count& count) {
  Specimen specimen(model);
  Deviations worst;
  if (has_idle_constraint(specimen)) {
    ++count.refused;
    return worst;
  }
  agreement::RandomStates states(specimen.mechanics.symbols, seed);
  for (int i = 0; i < k_states; ++i) {
    ++count.states;
    if (!specimen.at(states.next())) {
      ++count.ill_conditioned;
      continue;
    }
    worst.take(deviations(specimen) / (100 * agreement::k_eps * specimen.condition));
  }
  count.with_joint_work += worst.has_joint_work ? 1 : 0;
  return worst;
}

}  // namespace

TEST_CASE("the same laws hold on 200 random mechanisms") {
  const unsigned seed = first_seed();
  std::printf("random mechanisms: seeds %u to %u\n", seed, seed + k_mechanisms - 1);
  Deviations worst;
  Count count;
  for (unsigned i = 0; i < k_mechanisms; ++i) {
    const std::string text = agreement::newton::random_mechanism(seed + i);
    INFO("seed " << seed + i << "\n" << text);
    std::string why;
    const auto model = parsed(text, why);
    if (!model) {
      ++count.refused;
      if (std::getenv("GAUSS_VERBOSE")) std::printf("seed %u:\n%s\n", seed + i, why.c_str());
      continue;
    }
    const Deviations now = examine(*model, seed + i, count);
    if (std::getenv("GAUSS_VERBOSE")) std::printf("seed %u: worst %g\n", seed + i, now.worst()), std::fflush(stdout);
    CHECK(now.is_within(1));
    worst.take(now);
  }
  std::printf("%9s %9s %9s %9s %9s %9s %9s %9s   (each / 100 kappa eps)\n", "bodies", "links", "work", "reactions",
              "joints", "dphi/dt", "energy", "power");
  std::printf("%9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g\n", worst.on_bodies, worst.links, worst.work,
              worst.reactions, worst.joints, worst.constraints, worst.energy, worst.power);
  std::printf("%d refused by the front end, %d of %d states with kappa > 1e8, work of joints on %d\n", count.refused,
              count.ill_conditioned, count.states, count.with_joint_work);
  CHECK(count.refused <= static_cast<int>(k_mechanisms) / 5);
  CHECK(count.ill_conditioned <= count.states / 4);
}
