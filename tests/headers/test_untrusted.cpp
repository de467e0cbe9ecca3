// What parameters and initial values can spoil is in the status, too: nothing that cannot be trusted looks like a result.

#include <cmath>
#include <limits>

#include "catch_shim.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "gimbals.hpp"
#include "locked_wheel.hpp"
#include "massless.hpp"
#include "speed_limit.hpp"
#include "turned_away.hpp"
#include "two_for_one.hpp"

using gauss::Status;
namespace massless = gauss::massless;
namespace gimbals = gauss::gimbals;
namespace locked_wheel = gauss::locked_wheel;
namespace speed_limit = gauss::speed_limit;
namespace turned_away = gauss::turned_away;
namespace two_for_one = gauss::two_for_one;

namespace {

template <class S>
gauss::StatusOf<S> status_with_mass(const S& mass) {
  massless::Parameters<S> parameters;
  parameters.m = mass;
  massless::Derivative<S> derivative{};
  return rhs(S(0), massless::State<S>{}, {}, prepare(parameters), derivative);
}

Status status_with_radius(double radius) {
  locked_wheel::Parameters<double> parameters;
  parameters.r = radius;
  locked_wheel::Derivative<double> derivative{};
  return rhs(0.0, locked_wheel::State<double>{}, {}, prepare(parameters), derivative);
}

template <class S>
gauss::StatusOf<S> start(const S& v2, const S& rate, speed_limit::State<S>& state) {
  speed_limit::Parameters<S> parameters;
  parameters.v2 = v2;
  parameters.rate = rate;
  return initial_state(prepare(parameters), state);
}

}  // namespace

TEST_CASE("without mass there are no accelerations, not even where no force acts") {
  CHECK(status_with_mass(1.0) == Status::ok);
  CHECK(status_with_mass(0.0) == Status::singular_mass_matrix);
  CHECK(status_with_mass(-0.0F) == Status::singular_mass_matrix);
  CHECK(status_with_mass(-1.0L) == Status::singular_mass_matrix);
  CHECK(status_with_mass(1e-300) == Status::ok);
  CHECK(status_with_mass(std::numeric_limits<double>::quiet_NaN()) != Status::ok);
}

TEST_CASE("a lane without mass is reported alone") {
  using Batch = xsimd::batch<double>;
  alignas(64) double masses[Batch::size];
  for (std::size_t i = 0; i < Batch::size; ++i) masses[i] = i == 1 ? 0 : 1;
  const auto status = status_with_mass(Batch::load_aligned(masses));
  for (std::size_t i = 0; i < Batch::size; ++i) {
    CHECK(status.lane(i) == (i == 1 ? Status::singular_mass_matrix : Status::ok));
  }
}

TEST_CASE("a parameter that switches a constraint off makes it dependent; its sign does not matter") {
  CHECK(status_with_radius(0.5) == Status::ok);
  CHECK(status_with_radius(-0.5) == Status::ok);
  CHECK(status_with_radius(0) == Status::dependent_constraints);
}

// At the pole the drive and the spin turn about one axis, and nothing tells how they share a moment about it.
TEST_CASE("forces that coordinates determine elsewhere are not stated where they do not") {
  const auto prepared = gimbals::prepare(gimbals::Parameters<double>{});
  const auto statuses = [&](double tilt) {
    const gimbals::State<double> state{{tilt, 0.2, 0, 3}};
    gimbals::Derivative<double> derivative{};
    gimbals::ReactionForces<double> forces{};
    gimbals::Compulsion<double> compulsion{};
    REQUIRE(rhs(0.0, state, {}, prepared, derivative) == Status::ok);
    return std::pair(reaction_forces(0.0, state, {}, prepared, forces),
                     gimbals::compulsion(0.0, state, {}, prepared, derivative, compulsion));
  };
  for (const double tilt : {0.3, 1e-5}) CHECK(statuses(tilt) == std::pair(Status::ok, Status::ok));
  for (const double tilt : {1e-7, 1e-9, 1e-17, 0.0}) {
    CHECK(statuses(tilt) == std::pair(Status::singular_mass_matrix, Status::singular_mass_matrix));
  }
}

TEST_CASE("Newton's method arrives at an initial state or says that it has not") {
  speed_limit::State<double> state{};
  CHECK(start(4.0, 0.5, state) == Status::ok);
  CHECK(state.x_dot() * state.x_dot() + state.y_dot() * state.y_dot() == Approx(4).epsilon(1e-14));
  CHECK(start(-4.0, 0.5, state) == Status::violated_constraints);
  speed_limit::State<float> single{};
  CHECK(start(4.0F, 0.5F, single) == Status::ok);
  CHECK(start(-4.0F, 0.5F, single) == Status::violated_constraints);
}

TEST_CASE("an open rate of which rounding alone is in a constraint does not follow from it") {
  const auto status_at = [](double beta) {
    turned_away::Parameters<double> parameters;
    parameters.beta = beta;
    turned_away::State<double> state{};
    return initial_state(prepare(parameters), state);
  };
  CHECK(status_at(1) == Status::ok);
  CHECK(status_at(1.57) == Status::ok);
  CHECK(status_at(std::acos(0.0)) == Status::dependent_constraints);
}

TEST_CASE("a given rate that contradicts a constraint over it alone is reported") {
  speed_limit::State<double> state{};
  CHECK(start(4.0, 0.5000001, state) == Status::violated_constraints);
  CHECK(start(4.0, 0.6, state) == Status::violated_constraints);
  using Batch = xsimd::batch<double>;
  speed_limit::State<Batch> batch{};
  CHECK(xsimd::all(start(Batch(4.0), Batch(0.6), batch).violated_constraints));
}

TEST_CASE("project arrives from what an integrator leaves, and tells a state that it does not reach") {
  const auto prepared = speed_limit::prepare(speed_limit::Parameters<double>{});
  speed_limit::State<double> projected{};
  for (const double off : {1e-9, 1e-6, 1e-4}) {
    const speed_limit::State<double> near{{0, 0, 0, 2 + off, off, 0.5}};
    CHECK(project(0.0, near, prepared, projected) == Status::ok);
    CHECK(std::hypot(projected.x_dot(), projected.y_dot()) == Approx(2).epsilon(1e-14));
  }
  const speed_limit::State<double> far{{0, 0, 0, 500, 300, 0.5}};
  CHECK(project(0.0, far, prepared, projected) == Status::violated_constraints);
}

// s = x + y moves freely, m s_ddot = -m g, and x = 2 y as far as rates go: y_ddot = -g/3.
TEST_CASE("coordinates that only a constraint tells apart are solved for, projected and started with") {
  const auto prepared = two_for_one::prepare(two_for_one::Parameters<double>{});
  two_for_one::State<double> state{};
  REQUIRE(initial_state(prepared, state) == Status::ok);
  CHECK(state.y_dot() == Approx(0.5));
  two_for_one::Derivative<double> derivative{};
  REQUIRE(rhs(0.0, state, {}, prepared, derivative) == Status::ok);
  CHECK(derivative.x_ddot() == Approx(-6));
  CHECK(derivative.y_ddot() == Approx(-3));
  // The least change in the metric m (dx + dy)^2 leaves x_dot + y_dot as it is.
  two_for_one::State<double> projected{};
  REQUIRE(project(0.0, two_for_one::State<double>{{0, 0, 1, 1}}, prepared, projected) == Status::ok);
  CHECK(projected.x_dot() == Approx(4.0 / 3));
  CHECK(projected.y_dot() == Approx(2.0 / 3));
}
