// What more constraints than needed hold stands still to rounding: coordinates and speeds of 1e-17, 1e-50 or 0, which nothing is to be taken for that is
// measured by itself.

#include <cmath>
#include <random>

#include "catch_shim.hpp"
#include "node_on_bars.hpp"
#include "plate_on_brackets.hpp"
#include "two_hinge_door.hpp"

namespace node = gauss::node_on_bars;
namespace plate = gauss::plate_on_brackets;
namespace door = gauss::two_hinge_door;
using gauss::Status;

namespace {

struct Seen {
  int ok = 0;
  double widest = 0;  ///< deviation of what moves from a pendulum
};

/// `project` and `rhs` at 300 states, each component up to `off` from where the model begins; what is `ok` in both is compared.
template <class S, class State, class Prepared, class Derivative, class Deviation>
Seen beside_start(const Prepared& prepared, S off, Deviation deviation) {
  State start{};
  REQUIRE(initial_state(prepared, start) == Status::ok);
  std::mt19937 engine(20261124);
  std::uniform_real_distribution<S> up_to_one(-1, 1);
  Seen seen;
  for (int k = 0; k < 300; ++k) {
    State shifted = start, reached{};
    for (S& value : shifted.values) value += off * up_to_one(engine);
    if (project(S(0), shifted, prepared, reached) != Status::ok) continue;
    Derivative derivative{};
    if (rhs(S(0), reached, {}, prepared, derivative) != Status::ok) continue;
    ++seen.ok;
    seen.widest = std::max(seen.widest, static_cast<double>(deviation(reached, derivative)));
  }
  return seen;
}

/// On a string of 1 m under the node: along it -v², across it -g sin.
template <class S>
Seen of_node(S off) {
  return beside_start<S, node::State<S>, node::Prepared<S>, node::Derivative<S>>(
      prepare(node::Parameters<S>{}), off, [](const auto& at, const auto& found) {
        const S across = at.u() - at.x(), down = at.y() - at.w();
        const S v2 = at.u_dot() * at.u_dot() + at.w_dot() * at.w_dot();
        const S pull = v2 + S(9.81) * down;
        return std::abs(found.u_ddot() + pull * across) + std::abs(found.w_ddot() - pull * down + S(9.81)) +
               std::abs(found.x_ddot()) + std::abs(found.y_ddot());
      });
}

template <class S>
Seen of_plate(S off) {
  return beside_start<S, plate::State<S>, plate::Prepared<S>, plate::Derivative<S>>(
      prepare(plate::Parameters<S>{}), off, [](const auto& at, const auto& found) {
        return std::abs(found.theta_ddot() + S(9.81) * S(0.5) * std::sin(at.theta()) / S(0.27));
      });
}

}  // namespace

TEST_CASE("what is held by more than it needs stands, and what hangs from it swings") {
  for (const double off : {0.0, 1e-9, 1e-3, 1e-2}) {
    INFO("off by " << off);
    const Seen node = of_node(off), plate = of_plate(off);
    CHECK(node.ok == 300);
    CHECK(node.widest <= 1e-13);
    CHECK(plate.ok == 300);
    CHECK(plate.widest <= 1e-13);
  }
  const Seen node = of_node(1e-3F), plate = of_plate(1e-3F);
  CHECK(node.ok == 300);
  CHECK(node.widest <= 1e-4);
  CHECK(plate.ok == 300);
  CHECK(plate.widest <= 1e-4);
}

TEST_CASE("a door on two hinges is projected from wherever a step leaves it") {
  const auto prepared = prepare(door::Parameters<double>{});
  for (const double off : {1e-12, 1e-9, 1e-6, 1e-3}) {
    INFO("off by " << off);
    const Seen seen = beside_start<double, door::State<double>, door::Prepared<double>, door::Derivative<double>>(
        prepared, off, [](const auto&, const auto&) { return 0; });
    CHECK(seen.ok == 300);
  }
}
