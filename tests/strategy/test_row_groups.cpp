// Which constraints may follow from each other (strategy/row_groups.hpp), against what pencil and paper say of small mechanisms.

#include <map>
#include <set>
#include <string>

#include "catch_shim.hpp"
#include "mechanics.hpp"
#include "read_model.hpp"
#include "strategy/row_groups.hpp"
#include "support/files.hpp"

namespace {

using Names = std::set<std::string>;

/// Groups by the names of their constraints; those with a coordinate of their own are in none.
std::set<Names> groups_of(const std::string& text) {
  gaussgen::support::Source source("groups.yaml", text, gaussgen::support::read_regular_file);
  gaussgen::support::Diagnostics diagnostics;
  const auto model = gaussgen::read_model(source, diagnostics);
  INFO(gaussgen::support::render(diagnostics, source));
  REQUIRE(model.has_value());
  gaussgen::Mechanics mechanics(*model, {});
  const auto groups = gaussgen::strategy::row_groups(mechanics.dynamics);
  std::map<std::size_t, Names> by_number;
  for (std::size_t mu = 0; mu < groups.size(); ++mu) {
    if (groups[mu]) by_number[*groups[mu]].insert(mechanics.dynamics.constraints[mu]);
  }
  std::set<Names> result;
  for (const auto& [number, names] : by_number) result.insert(names);
  return result;
}

const std::string k_plane = R"(gauss: 1
name: groups
coordinates: {x: {initial: 0}, y: {initial: 1}, u: {initial: 0}, w: {initial: 0.5}}
particles: {a: {mass: 1, position: [x, y, 0]}, b: {mass: 1, position: [u, w, 0]}}
constraints:
)";

}  // namespace

TEST_CASE("constraints of the same coordinates are one group, those of others another") {
  CHECK(groups_of(k_plane + "  one: {equation: x^2 + y^2 - 1}\n  two: {equation: (x - 1)^2 + y^2 - 2}\n"
                            "  three: {equation: (x + 1)^2 + y^2 - 2}\n"
                            "  other: {equation: u^2 + w^2 - 1/4}\n  same: {equation: 2*u^2 + 2*w^2 - 1/2}\n  also: "
                            "{equation: w - 1/2}\n") ==
        std::set<Names>{{"one", "two", "three"}, {"other", "same", "also"}});
}

TEST_CASE("a constraint with a coordinate of its own is in no group, and what hangs from it neither") {
  CHECK(groups_of(k_plane + "  one: {equation: x^2 + y^2 - 1}\n").empty());
  CHECK(groups_of(k_plane + "  one: {equation: x^2 + y^2 - 1}\n  two: {equation: x^2 + (y - 3)^2 - 4}\n"
                            "  string: {equation: (u - x)^2 + (w - y)^2 - 1/4}\n") == std::set<Names>{{"one", "two"}});
  // A chain of them: each has one coordinate as soon as the next is out.
  CHECK(groups_of(k_plane +
                  "  one: {equation: x - y + 1}\n  two: {equation: y - u - 1}\n  three: {equation: u - w + 1/2}\n")
            .empty());
}

TEST_CASE("speeds count as their coordinates do, and entries as what they depend on") {
  // (two) has a speed alone, but (one) turns with the coordinate.
  CHECK(groups_of(
            k_plane +
            "  one: {velocity: cos(u)*dot(x) + sin(u)*dot(y)}\n  again: {velocity: 2*cos(u)*dot(x) + 2*sin(u)*dot(y)}\n"
            "  two: {velocity: dot(u) - dot(x)}\n") == std::set<Names>{{"one", "again", "two"}});
  CHECK(groups_of(k_plane + "  one: {velocity: dot(x) + dot(y)}\n  again: {velocity: 2*dot(x) + 2*dot(y)}\n"
                            "  two: {velocity: dot(u) - dot(x)}\n") == std::set<Names>{{"one", "again"}});
}

TEST_CASE("a quaternion is one motion with its angular velocity") {
  const std::string door = R"(gauss: 1
name: groups
joints: {ball: {type: spherical, child: door}}
bodies: {leaf: {frame: door, mass: 1, inertia: [1, 2, 3], centre: [1, 0, 0]}}
points:
  A: {on: door, at: [0, 0, 1]}
  B: {at: [0, 0, 1]}
constraints:
  hinge: {coincide: [A, B]}
)";
  const std::set<Names> groups = groups_of(door);
  REQUIRE(groups.size() == 1);
  CHECK(groups.begin()->size() >= 2);
}
