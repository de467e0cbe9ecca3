// How far from the constraints `project` may begin, and what it leaves of them: the loop of the four-bar linkage, closed by hand here, and a disc that rolls.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "headers_plain/four_bar.hpp"
#include "headers_plain/rolling_disc.hpp"

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

namespace {

namespace disc = gauss::rolling_disc;

/// States near rolling, in metres of which the disc has 2^-binary: components that are lengths or their rates are so many times as large.
struct Rolled {
  Status status;
  disc::State<double> state;
};

void scale_lengths(disc::State<double>& state, int binary) {
  for (double* length : {&state.x(), &state.y(), &state.x_dot(), &state.y_dot()}) *length = std::ldexp(*length, binary);
}

std::vector<Rolled> rolled(int binary) {
  disc::Parameters<double> p;
  p.R = std::ldexp(p.R, binary);
  p.g = std::ldexp(p.g, binary);
  const auto prepared = prepare(p);
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  std::vector<Rolled> result;
  for (int k = 0; k < 300; ++k) {
    disc::State<double> at;
    for (double& value : at.values) value = up_to_one(engine);
    at.psi() = k % 3 == 0 ? std::acos(0.0) : 3 * at.psi();  // across: of a constraint, what is along x is rounding
    at.theta() = 1.2;
    scale_lengths(at, binary);
    Rolled one{};
    one.status = project(0.0, at, prepared, one.state);
    scale_lengths(one.state, -binary);
    result.push_back(one);
  }
  return result;
}

}  // namespace

TEST_CASE("project says and does the same in any unit of length") {
  const std::vector<Rolled> in_metres = rolled(0);
  for (const int binary : {-60, -30, 30, 60}) {
    const std::vector<Rolled> in_others = rolled(binary);
    for (std::size_t k = 0; k < in_metres.size(); ++k) {
      INFO("2^" << binary << ", state " << k);
      CHECK(in_metres[k].status == Status::ok);
      CHECK(in_others[k].status == in_metres[k].status);
      CHECK(std::equal(std::begin(in_others[k].state.values), std::end(in_others[k].state.values),
                       in_metres[k].state.values));
    }
  }
}
