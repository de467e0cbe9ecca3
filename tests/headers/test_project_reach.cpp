// How far from the constraints `project` may begin, and what it leaves of them: the loop of the four-bar linkage, closed by hand here.

#include <algorithm>
#include <cmath>
#include <random>

#include "catch_shim.hpp"
#include "headers_plain/four_bar.hpp"

namespace four_bar = gauss::four_bar;
using gauss::Status;

namespace {

/// B of the coupler and D of the rocker meet, and so do their velocities.
template <class S>
S gap(const four_bar::State<S>& at) {
  const four_bar::Parameters<S> p;
  const S crank = at.alpha(), coupler = crank + at.beta(), rocker = at.gamma();
  const S w1 = at.alpha_dot(), w2 = w1 + at.beta_dot(), w3 = at.gamma_dot();
  const S x = p.L1 * std::cos(crank) + p.L2 * std::cos(coupler) - p.L4 - p.L3 * std::cos(rocker);
  const S y = p.L1 * std::sin(crank) + p.L2 * std::sin(coupler) - p.L3 * std::sin(rocker);
  const S u = p.L1 * w1 * std::sin(crank) + p.L2 * w2 * std::sin(coupler) - p.L3 * w3 * std::sin(rocker);
  const S v = p.L1 * w1 * std::cos(crank) + p.L2 * w2 * std::cos(coupler) - p.L3 * w3 * std::cos(rocker);
  return std::max({std::abs(x), std::abs(y), std::abs(u) / 10, std::abs(v) / 10});  // at some 10 rad/s
}

struct Reach {
  int arrived = 0;
  double widest = 0;  ///< gap where the status is ok
};

/// From 300 states around that of the file, each component up to `off` away.
template <class S>
Reach reach(S off) {
  const auto prepared = prepare(four_bar::Parameters<S>{});
  four_bar::State<S> start;
  REQUIRE(initial_state(prepared, start) == Status::ok);
  std::mt19937 engine(20261123);
  std::uniform_real_distribution<S> up_to_one(-1, 1);
  Reach result;
  for (int k = 0; k < 300; ++k) {
    four_bar::State<S> shifted = start, projected;
    for (S& value : shifted.values) value += off * up_to_one(engine);
    const Status status = project(S(0), shifted, prepared, projected);
    if (status != Status::ok) {
      CHECK(status == Status::violated_constraints);
      continue;
    }
    ++result.arrived;
    result.widest = std::max(result.widest, static_cast<double>(gap(projected)));
  }
  return result;
}

}  // namespace

TEST_CASE("from a tenth of a radian off, project closes a linkage to rounding") {
  for (const double off : {1e-9, 1e-3, 1e-2, 3e-2, 0.1}) {
    const Reach from = reach(off);
    INFO("off by up to " << off << ": " << from.widest);
    CHECK(from.arrived == 300);
    CHECK(from.widest < 1e-15);
  }
  const Reach single = reach(3e-2F);
  CHECK(single.arrived == 300);
  CHECK(single.widest < 1e-6);
}

TEST_CASE("from farther off, project arrives at rounding or says that it does not") {
  int missed = 0;
  for (const double off : {0.2, 0.3, 0.5, 1.0, 2.0}) {
    const Reach from = reach(off);
    INFO("off by up to " << off << ": " << from.arrived << " arrived, " << from.widest);
    CHECK(from.widest < 1e-12);
    missed += 300 - from.arrived;
  }
  CHECK(missed > 100);
}
