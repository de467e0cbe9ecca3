// How many constraints say something is a matter of the state and of the parameters at run time, not of those of the model file.

#include <initializer_list>
#include <string>

#include "bennett.hpp"
#include "catch_shim.hpp"
#include "coarse_rank.hpp"
#include "hung_slab.hpp"
#include "parallelogram.hpp"
#include "switched_stop.hpp"
#include "three_bars.hpp"
#include "two_slopes.hpp"

namespace {

namespace coarse = gauss::coarse_rank;
namespace slopes = gauss::two_slopes;
namespace stop = gauss::switched_stop;
namespace bars = gauss::three_bars;
namespace hung = gauss::hung_slab;
namespace bennett = gauss::bennett;
namespace parallelogram = gauss::parallelogram;

slopes::Prepared<double> with_slope(double slope) {
  slopes::Parameters<double> parameters;
  parameters.slope = slope;
  return prepare(parameters);
}

stop::Prepared<double> with_stop(double k) {
  stop::Parameters<double> parameters;
  parameters.k = k;
  return prepare(parameters);
}

struct OnBars {
  gauss::Status status;
  bars::Derivative<double> derivative;
  double mobility;
};

/// The middle of the slab, and how far it is turned.
OnBars on_bars(double d, double x, double y, double turn) {
  bars::Parameters<double> parameters;
  parameters.d = d;
  const auto prepared = prepare(parameters);
  bars::State<double> state{};
  state.x() = x;
  state.y() = y;
  state.phi() = turn;
  OnBars result{};
  bars::Mobility<double> mobility{};
  result.status = rhs(0.0, state, {}, prepared, result.derivative);
  if (bars::mobility(0.0, state, {}, prepared, mobility) == gauss::Status::ok) result.mobility = mobility.mobility;
  return result;
}

/// At an angle of its bars, off by this much in height.
OnBars on_bars(double d, double angle, double off) { return on_bars(d, std::sin(angle), std::cos(angle) + off, 0); }

/// Turned about one of its ends (-1, 1), where the bar keeps its length.
OnBars turned_about(double end, double angle, double turn) {
  return on_bars(0, std::sin(angle) + end - end * std::cos(turn), std::cos(angle) - end * std::sin(turn), turn);
}

/// Two rows for two speeds of inertia 1, at an angle to each other.
struct TwoRows {
  explicit TwoRows(double angle) {
    b[1][0] = reach[1][0] = std::cos(angle);
    b[1][1] = reach[1][1] = std::sin(angle);
  }

  double g[2][2] = {{1, 0}, {0, 1}};
  double f[2] = {0, 0};
  double b[2][2] = {{1, 0}, {0, 0}};
  double reach[2][2] = {{1, 0}, {0, 0}};
  double of_positions[2] = {0, 0};
  double off[2] = {0, 0};
  double drift[2] = {0, 0};
  double drift_error[2] = {0, 0};
};

/// Two rows at an angle of 1e-6, of which positions are off by 1e-4, and two at 1e-7, of which none are.
struct TwoPairs {
  double g[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  double f[4] = {0, 0, 0, 0};
  double b[4][4] = {{1, 0, 0, 0}, {1, 1e-6, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1e-7}};
  double reach[4][4] = {{1, 0, 0, 0}, {1, 1e-6, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1e-7}};
  double of_positions[4] = {1, 1, 0, 0};
  double off[4] = {1e-8, 1e-8, 0, 0};
  double drift[4] = {0, 0, 0, 0};
  double drift_error[4] = {0, 0, 0, 0};
};

int rank_at(double angle, const gauss::RankRule<double>& rule) {
  gauss::LinearSolution<double, 2, 2> solution{};
  gauss::solve(TwoRows(angle), rule, solution);
  return static_cast<int>(solution.rank);
}

/// By halves.
double least_angle_of_two(const gauss::RankRule<double>& rule) {
  double angle = 1;
  while (rank_at(angle / 2, rule) == 2) angle /= 2;
  return angle;
}

}  // namespace

TEST_CASE("a closed loop that parameters lock is locked, however little they are off") {
  for (const double d : {1e-5, 1e-3, 2e-2, 0.3}) {
    INFO("middle pivot moved by " << d << " m");
    const OnBars locked = on_bars(d, 0, 0);
    CHECK(locked.status == gauss::Status::ok);
    for (const double a : locked.derivative.values) CHECK(std::abs(a) <= 1e-15 / d);
    CHECK(locked.mobility == 0);
  }
  // Also where positions are off, as long as that is little beside what locks it.
  for (const double off : {1e-12, 1e-10, 1e-8}) {
    INFO("off by " << off << " m");
    const OnBars locked = on_bars(2e-2, 0, off);
    CHECK(locked.status == gauss::Status::ok);
    for (const double a : locked.derivative.values) CHECK(std::abs(a) <= 1e-13);
    CHECK(locked.mobility == 0);
  }
}

// Without gravity the slab is carried along a circle: F cos(angle) / m along it.
TEST_CASE("positions that are off lock nothing: rows that follow from others are not taken for such as say something") {
  const double angle = 0.4;
  for (const double off : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3}) {
    INFO("off by " << off << " m");
    const OnBars moving = on_bars(0, angle, off);
    CHECK(moving.status == gauss::Status::ok);
    CHECK(moving.derivative.x_ddot() == Approx(std::cos(angle) * std::cos(angle)).margin(2 * off + 1e-15));
    CHECK(moving.derivative.y_ddot() == Approx(-std::cos(angle) * std::sin(angle)).margin(2 * off + 1e-15));
    CHECK(moving.mobility == 1);
  }
}

// A bob on a string of length L under what does not move: no acceleration along the string but v²/L, which is 0 here, and g sin across it.
TEST_CASE(
    "what locks a loop is told from positions that are off elsewhere, and what does not is not taken for a lock") {
  for (const double off : {0.0, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
    for (const double d : {0.0, 1e-5, 1e-3}) {
      INFO("strings off by " << off << " m, middle pivot moved by " << d << " m");
      hung::Parameters<double> parameters;
      parameters.d = d;
      const auto prepared = prepare(parameters);
      hung::State<double> state{};
      REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
      state.u() += off;
      state.q() += off;
      hung::Derivative<double> derivative{};
      hung::Mobility<double> mobility{};
      CHECK(rhs(0.0, state, {}, prepared, derivative) == gauss::Status::ok);
      CHECK(hung::mobility(0.0, state, {}, prepared, mobility) == gauss::Status::ok);
      CHECK(mobility.mobility == (d > 0 ? 2 : 3));
      if (d == 0) {
        // Pushed, with nothing across its way.
        CHECK(std::abs(derivative.x_ddot()) > 0.1);
        continue;
      }
      CHECK(std::abs(derivative.x_ddot()) <= 1e-13 / d);
      CHECK(std::abs(derivative.y_ddot()) <= 1e-13 / d);
      const double across = (state.u() - state.x()) / 0.5, down = (state.y() - state.w()) / 0.5;
      CHECK(derivative.u_ddot() == Approx(-9.81 * across * down).margin(20 * off + 1e-9));
    }
  }
}

TEST_CASE("whichever equation positions are off, they lock nothing") {
  const double angle = 0.4;
  for (const double end : {-1.0, 0.0, 1.0}) {
    for (const double turn : {1e-9, -1e-6, 1e-4}) {
      INFO("turned by " << turn << " about " << end);
      const OnBars moving = turned_about(end, angle, turn);
      CHECK(moving.status == gauss::Status::ok);
      CHECK(moving.mobility == 1);
      CHECK(moving.derivative.x_ddot() == Approx(std::cos(angle) * std::cos(angle)).margin(20 * std::abs(turn)));
    }
  }
}

// 2^-26 is sqrt(eps): a sixteenth of it for accelerations, four times it for steps of Newton's method, what a model asks for, or a twentieth
// beside positions that nobody knows.
TEST_CASE("rows are told from each other down to the angle that is documented") {
  const double half_of_digits = std::ldexp(1.0, -26);
  const auto is_about = [](double angle, double wanted) { return angle >= wanted && angle <= 2.1 * wanted; };
  CHECK(is_about(least_angle_of_two(gauss::rank_of_velocities<double>(2)), half_of_digits / 16));
  CHECK(is_about(least_angle_of_two(gauss::rank_on_positions<double>(2)), half_of_digits / 16));
  CHECK(is_about(least_angle_of_two(gauss::rank_on_positions<double>(1)), half_of_digits / 16));
  CHECK(is_about(least_angle_of_two(gauss::rank_of_steps<double>(2)), 4 * half_of_digits));
  CHECK(is_about(least_angle_of_two(gauss::rank_of_velocities<double>(2, 1e-3)), 1e-3));
  CHECK(is_about(least_angle_of_two(gauss::rank_of_steps<double>(2, 1e-3)), 1e-3));
  CHECK(rank_at(1, gauss::rank_of_steps<double>(1)) == 1);
  gauss::LinearSolution<double, 2, 2> solution{};
  // Ten roots of what positions are off by, and no more than a twentieth.
  struct Told {
    double off, angle;
    int rank;
  };
  for (const Told& told : {Told{1, 0.04, 1}, Told{1, 0.06, 2}, Told{1e-6, 0.008, 1}, Told{1e-6, 0.012, 2},
                           Told{1e-10, 8e-5, 1}, Told{1e-10, 1.2e-4, 2}}) {
    INFO("off by " << told.off << ", at an angle of " << told.angle);
    TwoRows rows(told.angle);
    rows.off[0] = rows.off[1] = told.off * told.off;
    gauss::solve(rows, gauss::rank_on_positions<double>(1), solution);
    CHECK(solution.rank == told.rank);
  }
  gauss::LinearSolution<double, 4, 4> of_pairs{};
  gauss::solve(TwoPairs(), gauss::rank_on_positions<double>(2), of_pairs);
  CHECK(of_pairs.rank == 3);
}

TEST_CASE("constraints that are one for the parameters of the file hold one by one for others") {
  slopes::Derivative<double> derivative{};
  // Along (1, -1) the force (1, 2) has the component -1/2.
  CHECK(rhs(0.0, slopes::State<double>{}, {}, with_slope(1), derivative) == gauss::Status::ok);
  CHECK(derivative.x_ddot() == Approx(-0.5).epsilon(1e-15));
  CHECK(derivative.y_ddot() == Approx(0.5).epsilon(1e-15));
  for (const double slope : {1.01, 2.0, -1.0}) {
    INFO("slope " << slope);
    CHECK(rhs(0.0, slopes::State<double>{}, {}, with_slope(slope), derivative) == gauss::Status::ok);
    CHECK(std::abs(derivative.x_ddot()) <= 1e-13);
    CHECK(std::abs(derivative.y_ddot()) <= 1e-13);
  }
}

TEST_CASE("an equation that is switched off in the file is not passed over where it is switched on") {
  for (const double k : {1e-3, 1.0}) {
    stop::Derivative<double> derivative{};
    CHECK(rhs(0.0, stop::State<double>{}, {}, with_stop(k), derivative) == gauss::Status::ok);
    CHECK(std::abs(derivative.x_ddot()) <= 1e-15);
    CHECK(derivative.y_ddot() == 2);
  }
}

TEST_CASE("rows closer than the model's rank_tolerance are one, and the status says where that begins") {
  for (const double d : {1.0, 1e-2, 2e-4, 5e-5, 1e-5, 1e-8}) {
    INFO("slope " << d);
    coarse::Parameters<double> parameters;
    parameters.d = d;
    const auto prepared = prepare(parameters);
    coarse::Derivative<double> derivative{};
    coarse::Reactions<double> reactions{};
    coarse::Mobility<double> mobility{};
    const bool are_two = d > 1e-4;
    const gauss::Status expected = are_two ? gauss::Status::ok : gauss::Status::dependent_constraints;
    CHECK(rhs(0.0, coarse::State<double>{}, {}, prepared, derivative) == expected);
    // What is left out moves by its part of the slope.
    CHECK(std::abs(derivative.x_ddot()) <= 3 * d);
    CHECK(derivative.y_ddot() == Approx(are_two ? 0.0 : 2.0).margin(3 * d));
    CHECK(coarse::reactions(0.0, coarse::State<double>{}, {}, prepared, reactions) == expected);
    CHECK(coarse::mobility(0.0, coarse::State<double>{}, {}, prepared, mobility) == gauss::Status::ok);
    CHECK(mobility.rank == (are_two ? 2 : 1));
    for (const double is_shared : mobility.is_shared) CHECK(is_shared == (are_two ? 0 : 1));
  }
}

TEST_CASE("rank and mobility at run time, and which constraints have no multiplier of their own") {
  slopes::Mobility<double> of_slopes{};
  for (const double slope : {1.0, 2.0}) {
    INFO("slope " << slope);
    const int rank = slope == 1 ? 1 : 2;
    CHECK(mobility(0.0, slopes::State<double>{}, {}, with_slope(slope), of_slopes) == gauss::Status::ok);
    CHECK(of_slopes.rank == rank);
    CHECK(of_slopes.mobility == 2 - rank);
    for (const double is_shared : of_slopes.is_shared) CHECK(is_shared == (rank == 1 ? 1 : 0));
  }

  // Bennett (1903): five equations more than motions, and it turns.
  const auto prepared = prepare(bennett::Parameters<double>{});
  bennett::State<double> state{};
  bennett::Mobility<double> of_bennett{};
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  CHECK(mobility(0.0, state, {}, prepared, of_bennett) == gauss::Status::ok);
  CHECK(of_bennett.rank == 2);
  CHECK(of_bennett.mobility == 1);
  for (const double is_shared : of_bennett.is_shared) CHECK(is_shared == 1);
}

TEST_CASE("a parallelogram gains a motion where it is flat, and the row that says nothing there is named") {
  const auto prepared = prepare(parallelogram::Parameters<double>{});
  parallelogram::State<double> state{};
  parallelogram::Mobility<double> found{};
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  REQUIRE(mobility(0.0, state, {}, prepared, found) == gauss::Status::ok);
  CHECK(found.mobility == 1);
  for (const double is_shared : found.is_shared) CHECK(is_shared == 0);

  const parallelogram::State<double> flat{};
  REQUIRE(mobility(0.0, flat, {}, prepared, found) == gauss::Status::ok);
  CHECK(found.mobility == 2);
  std::string named;
  for (int mu = 0; mu < parallelogram::n_constraints; ++mu) {
    if (found.is_shared[mu] == 1) named += std::string(parallelogram::constraint_table[mu].name) + " ";
  }
  CHECK(named == "loop_x ");
}
