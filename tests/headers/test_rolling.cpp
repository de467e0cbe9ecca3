// 'rolls' asks in all directions, some of which joints or coordinates have settled: such rows agree up to rounding of what cancels in them, and rounding
// is no contradiction.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "ball_in_cylinder.hpp"
#include "catch_shim.hpp"
#include "contradicting.hpp"
#include "conveyor.hpp"
#include "disc_in_ring.hpp"
#include "gauss/simulate/simulation.hpp"
#include "planetary_gear.hpp"

GAUSS_MODEL(Ball, gauss::ball_in_cylinder);
GAUSS_MODEL(Conveyor, gauss::conveyor);
GAUSS_MODEL(Disc, gauss::disc_in_ring);
GAUSS_MODEL(Gear, gauss::planetary_gear);

namespace {

using gauss::Status;

/// Some of their accelerations, by hand.
struct OfBall {
  using Model = Ball;
  using Reactions = gauss::ball_in_cylinder::Reactions<double>;
  static constexpr int k_shown = 2;

  /// Contact: z' = r w_t. Moments about it: the part of w along the radius keeps its direction in the frame that goes round with the ball.
  static std::array<double, k_shown> wanted(const gauss::ball_in_cylinder::Parameters<double>& p,
                                            const gauss::ball_in_cylinder::State<double>& s) {
    const double w_r = s.wx() * std::cos(s.chi()) + s.wy() * std::sin(s.chi());
    return {0, -(5 * p.g + 2 * p.r * w_r * s.chi_dot()) / 7};
  }
  static std::array<double, k_shown> found(const gauss::ball_in_cylinder::Derivative<double>& d) {
    return {d.chi_ddot(), d.z_ddot()};
  }
};

struct OfConveyor {
  using Model = Conveyor;
  using Reactions = gauss::conveyor::Reactions<double>;
  static constexpr int k_shown = 3;

  /// Two rollers count as half of their masses: 6 m in all.
  static std::array<double, k_shown> wanted(const gauss::conveyor::Parameters<double>& p,
                                            const gauss::conveyor::State<double>&) {
    const double along = -p.g * std::sin(p.al) * 5 / 6;
    return {along, -along / p.r, -along / p.r};
  }
  static std::array<double, k_shown> found(const gauss::conveyor::Derivative<double>& d) {
    return {d.s_ddot(), d.q1_ddot(), d.q2_ddot()};
  }
};

struct OfDisc {
  using Model = Disc;
  using Reactions = gauss::disc_in_ring::Reactions<double>;
  static constexpr int k_shown = 2;

  static std::array<double, k_shown> wanted(const gauss::disc_in_ring::Parameters<double>&,
                                            const gauss::disc_in_ring::State<double>&) {
    return {0, 0};
  }
  static std::array<double, k_shown> found(const gauss::disc_in_ring::Derivative<double>& d) {
    return {d.phi_ddot(), d.th_ddot()};
  }
};

struct OfGear {
  using Model = Gear;
  using Reactions = gauss::planetary_gear::Reactions<double>;
  static constexpr int k_shown = 3;

  /// Turns of planets and ring are sums of those of sun and arm, and all inertias are constant.
  static std::array<double, k_shown> wanted(const gauss::planetary_gear::Parameters<double>& p,
                                            const gauss::planetary_gear::State<double>&) {
    const double middle = p.rs + p.rp, outer = p.rs + 2 * p.rp;
    const double planet[2] = {-p.rs / p.rp, middle / p.rp}, ring[2] = {-p.rs / outer, 2 * middle / outer};
    const double disc = p.m * p.rs * p.rs / 2;
    const double of_planet = 3 * p.m * p.rp * p.rp / 8, of_ring = 8 * disc;
    const auto inertia = [&](int i, int j) { return of_planet * planet[i] * planet[j] + of_ring * ring[i] * ring[j]; };
    const double sun = disc + inertia(0, 0), mixed = inertia(0, 1);
    const double arm = disc + 3 * p.m / 4 * middle * middle + inertia(1, 1);
    const double determinant = sun * arm - mixed * mixed;
    const double s = p.T * arm / determinant, c = -p.T * mixed / determinant;
    return {s, c, ring[0] * s + ring[1] * c};
  }
  static std::array<double, k_shown> found(const gauss::planetary_gear::Derivative<double>& d) {
    return {d.s_ddot(), d.c_ddot(), d.q_ddot()};
  }
};

template <class Of>
struct Start {
  using Model = typename Of::Model;
  typename Model::template Parameters<double> parameters;
  typename Model::template Prepared<double> prepared = prepare(parameters);
  typename Model::template Inputs<double> inputs{};
  typename Model::template State<double> state;

  Start() { REQUIRE(initial_state(prepared, state) == Status::ok); }
};

/// Largest error, of what is large of them.
template <class Of, class State, class Derivative>
double error_at(const Start<Of>& from, const State& state, const Derivative& derivative) {
  const auto wanted = Of::wanted(from.parameters, state), found = Of::found(derivative);
  double size = 1, error = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    size = std::max(size, std::abs(wanted[i]));
    error = std::max(error, std::abs(wanted[i] - found[i]));
  }
  return error / size;
}

/// At states that satisfy the constraints, after speeds of this size.
template <class Of>
void check_everywhere(double speed) {
  using Model = typename Of::Model;
  const Start<Of> from;
  std::mt19937_64 engine(5);
  std::normal_distribution<double> spread;
  int refused = 0, contradictions = 0;
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    auto near = from.state, state = from.state;
    // Some speeds are 0 before they are projected: rounding alone is left of these.
    for (int i = 0; i < Model::n_q + Model::n_v; ++i) {
      const bool moves = i < Model::n_q || (i + k) % 3 != 0;
      near.values[i] += moves ? spread(engine) * (i < Model::n_q ? 1 : speed) : 0;
    }
    refused += project(0.0, near, from.prepared, state) != Status::ok ? 1 : 0;
    typename Model::template Derivative<double> derivative{}, beside{};
    typename Of::Reactions reactions{};
    refused += rhs(0.0, state, from.inputs, from.prepared, derivative) != Status::ok ? 1 : 0;
    // Of the rows that are shared by others, multipliers are not unique; that is all that may be said.
    const Status told = rhs_and_reactions(0.0, state, from.inputs, from.prepared, beside, reactions);
    contradictions += told == Status::dependent_constraints || told == Status::ok ? 0 : 1;
    if (speed < 1e3) worst = std::max(worst, error_at<Of>(from, state, derivative));
  }
  INFO("speeds of " << speed);
  CHECK(refused == 0);
  CHECK(contradictions == 0);
  CHECK(worst < 1e-11);
}

template <class Of>
void check_run() {
  using Model = typename Of::Model;
  const Start<Of> from;
  gauss::simulate::Simulation run(gauss::integrate::bind_model<Model>(from.prepared, from.inputs), from.state);
  CHECK(run.advance_to(5.0));
}

template <class Of>
void check() {
  for (const double speed : {1e-6, 1.0, 1e4}) check_everywhere<Of>(speed);
  check_run<Of>();
}

}  // namespace

TEST_CASE("a ball rolls in an upright cylinder") { check<OfBall>(); }
TEST_CASE("planets roll between a sun and a ring") { check<OfGear>(); }
TEST_CASE("a plate rolls down a slope on two rollers") { check<OfConveyor>(); }
TEST_CASE("a disc rolls in a ring") { check<OfDisc>(); }

namespace {

namespace contradicting = gauss::contradicting;

/// At (1, 0), where a bead of this speed would have to follow two curvatures.
Status on_belts(double speed, double b) {
  contradicting::Parameters<double> parameters;
  parameters.b = b;
  contradicting::State<double> state{};
  state.x() = 1;
  state.y_dot() = speed;
  contradicting::Derivative<double> derivative{};
  return rhs(0.0, state, {}, prepare(parameters), derivative);
}

}  // namespace

TEST_CASE("what does contradict is told, at any speed") {
  const double a = contradicting::Parameters<double>{}.a;
  CHECK(on_belts(0, a) == Status::dependent_constraints);  // fewer rows than usual, which agree
  for (const double speed : {1e-6, 1.0, 1e6}) CHECK(on_belts(speed, a) == Status::violated_constraints);
  for (const double faster : {1.001, 2.0, -1.0}) CHECK(on_belts(0, faster * a) == Status::violated_constraints);
}
