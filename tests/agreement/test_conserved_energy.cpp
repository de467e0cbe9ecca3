// What the generator says of the energy of a model, against the rate of that energy along its motion.

#include <cmath>
#include <map>

#include "artefacts.hpp"
#include "catch_shim.hpp"
#include "ir/differentiate.hpp"
#include "model_files.hpp"
#include "model_values.hpp"
#include "models.hpp"

namespace {

using gaussgen::ir::Expr;

struct Finding {
  bool is_said = false;  ///< to be conserved
  double relative_rate =
      0;  ///< of the total, along the motion at the initial state, of the terms that it is the sum of
};

const gaussgen::emit::Artefact& energy_of(const std::vector<gaussgen::emit::Artefact>& made) {
  REQUIRE(made.size() == 1);
  REQUIRE(made.front().constants.size() == 1);
  return made.front();
}

Expr total_of(const gaussgen::emit::Artefact& energy, gaussgen::ir::Graph& graph) {
  for (const auto& field : energy.groups.front().fields) {
    if (field.name == "total") return {graph, field.values.front()};
  }
  throw std::logic_error("no total energy");
}

Finding examine(gaussgen::Mechanics& mechanics) {
  const auto made = build_artefact("energy", mechanics);
  const gaussgen::emit::Artefact& energy = energy_of(made);
  Finding found;
  found.is_said = energy.constants.front().value;
  const Expr total = total_of(energy, mechanics.graph);
  Expr rate = partial(total, mechanics.symbols.time);
  for (const auto i : mechanics.symbols.configuration.indices())
    rate += partial(total, mechanics.symbols.configuration[i].symbol) * mechanics.kinematics.configuration_rates[i];
  for (const auto i : mechanics.symbols.speeds.indices())
    rate += partial(total, mechanics.symbols.speeds[i].symbol) * mechanics.solution.accelerations[i.value];
  gaussgen::ModelValues values(mechanics, gaussgen::support::Rational(0), 17);
  if (!bind_initial_values(mechanics, initial_values(mechanics, values), values)) return found;
  const auto value = values.relative_residual(rate.id());
  if (value) found.relative_rate = std::abs(cln::double_approx(*value));
  return found;
}

Finding of_text(const std::string& rest) {
  gaussgen::support::Source source("model.yaml", "gauss: 1\nname: model\nparameters: {k: 2, c: 0.3, v: 0.7}\n" + rest);
  gaussgen::support::Diagnostics diagnostics;
  const auto model = gaussgen::read_model(source, diagnostics);
  INFO(gaussgen::support::render(diagnostics, source));
  REQUIRE(model);
  gaussgen::Mechanics mechanics(*model, {});
  return examine(mechanics);
}

const std::string k_plane =
    "coordinates: {x: {initial: 1, initial_rate: 0.5}, y: {initial: 0.3, initial_rate: 0.4}}\n"
    "particles: {p: {mass: 1, position: [x, y, 0]}}\npoints: {o: {at: [0, 0, 0]}}\n";

}  // namespace

TEST_CASE("an energy that is said to be conserved has no rate along the motion of any model") {
  int conserved = 0;
  for (const std::string& name : agreement::model_files()) {
    INFO(name);
    const auto model = agreement::load(name);
    gaussgen::Mechanics mechanics(model, {});
    const Finding found = examine(mechanics);
    if (!found.is_said) continue;
    ++conserved;
    CHECK(found.relative_rate <= 1e-14);
  }
  CHECK(conserved >= 5);
}

TEST_CASE("an energy that changes is not said to be conserved") {
  const std::map<std::string, std::string> changing{
      {"a damper in a spring", k_plane + "forces: {s: {spring: [p, o], stiffness: k, damping: c}}\n"},
      {"a damper along a coordinate", k_plane + "forces: {s: {spring: x, stiffness: k, damping: c}}\n"},
      {"an input", "inputs: {u: {value: 1}}\n" + k_plane + "forces: {f: {force: [u, 0, 0], on: p}}\n"},
      {"a force", k_plane + "forces: {f: {generalized: {x: -c*dot(x)}}}\n"},
      {"a potential that is a law in time", k_plane + "forces: {w: {potential: k*x^2*(1 + t)}}\n"},
      {"a stiffness that is a law in time", k_plane + "forces: {s: {spring: [p, o], stiffness: k*(2 + t)}}\n"},
      {"a driven pivot",
       "coordinates: {a: {initial: 0.4, initial_rate: 1}}\n"
       "particles: {p: {mass: 1, position: [v*t + t^2 + sin(a), -cos(a), 0]}}\n"},
      {"a held coordinate that moves",
       "coordinates: {a: {initial: 0.4, initial_rate: 1}, s: {held_at: v*t + t^2}}\n"
       "particles: {p: {mass: 1, position: [s + sin(a), -cos(a), 0]}}\n"},
      {"a constraint that moves",
       "coordinates: {x: {initial: 1}, y: {initial: 0.3, initial_rate: 0.4}}\n"
       "particles: {p: {mass: 1, position: [x, y, 0]}}\nconstraints: {c: {velocity: dot(x) - v*y}}\n"}};
  for (const auto& [what, text] : changing) {
    INFO(what);
    const Finding found = of_text(text);
    CHECK_FALSE(found.is_said);
    CHECK(found.relative_rate > 1e-6);
  }
}

TEST_CASE("energies that are conserved by the form of a model are said to be") {
  for (const std::string& text :
       {k_plane + "forces: {s: {spring: [p, o], stiffness: k, length: c}, g: {uniform: [0, -9, 0]}}\n",
        k_plane +
            "forces: {w: {potential: k*x^4 + x*y}}\nconstraints: {c: {velocity: dot(x)*sin(y) - dot(y)*cos(x)}}\n",
        std::string(
            "coordinates: {a: {initial: 0.4, initial_rate: 1}, s: {held_at: 2*v}}\n"
            "particles: {p: {mass: 1, position: [s + sin(a), -cos(a), 0]}}\nforces: {g: {uniform: [0, -9, 0]}}\n")}) {
    INFO(text);
    CHECK(of_text(text).is_said);
  }
}
