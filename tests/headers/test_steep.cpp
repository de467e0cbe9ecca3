// A metric that is nearly singular without any constraint: coordinates that hardly describe the motion, what is light before what is heavy. With
// status ok, a quarter of the digits is left.

#include <algorithm>
#include <cmath>
#include <random>

#include "bowl.hpp"
#include "catch_shim.hpp"
#include "mixed_chart.hpp"
#include "mixed_chart_beside_stops.hpp"
#include "steep_surface.hpp"
#include "two_bobs.hpp"

namespace bowl = gauss::bowl;
namespace surface = gauss::steep_surface;
namespace bobs = gauss::two_bobs;
namespace chart = gauss::mixed_chart;
namespace stopped = gauss::mixed_chart_beside_stops;
using gauss::Status;

namespace {

struct Plane {
  double x, y, x_dot, y_dot;
};

struct Truth {
  double x_ddot, y_ddot;
  double size;  ///< of what it is made of: beside it, what the force along each coordinate would do alone
};

/// With z = a r², z'' = 2 a (r·r'' + v·v) and r'' = -2 a r N, z'' = N - g: N = (g + 2 a v²)/(1 + 4 a² r²).
Truth acceleration_in_bowl(double a, const Plane& at) {
  const double r2 = at.x * at.x + at.y * at.y;
  const double fall = 9.81 + 2 * a * (at.x_dot * at.x_dot + at.y_dot * at.y_dot);
  const double normal = fall / (1 + 4 * a * a * r2);
  const double size = 2 * a * std::sqrt(r2) * normal + std::abs(2 * a * at.x * fall / (1 + 4 * a * a * at.x * at.x)) +
                      std::abs(2 * a * at.y * fall / (1 + 4 * a * a * at.y * at.y));
  return {-2 * a * at.x * normal, -2 * a * at.y * normal, size};
}

Status by_coordinates(double a, const Plane& at, double (&found)[2]) {
  bowl::Parameters<double> parameters;
  parameters.a = a;
  bowl::Derivative<double> derivative{};
  const Status status =
      rhs(0.0, bowl::State<double>{{at.x, at.y, at.x_dot, at.y_dot}}, {}, prepare(parameters), derivative);
  found[0] = derivative.x_ddot();
  found[1] = derivative.y_ddot();
  return status;
}

Status by_equation(double a, const Plane& at, double (&found)[2]) {
  surface::Parameters<double> parameters;
  parameters.a = a;
  const double z = a * (at.x * at.x + at.y * at.y), z_dot = 2 * a * (at.x * at.x_dot + at.y * at.y_dot);
  surface::Derivative<double> derivative{};
  const Status status =
      rhs(0.0, surface::State<double>{{at.x, at.y, z, at.x_dot, at.y_dot, z_dot}}, {}, prepare(parameters), derivative);
  found[0] = derivative.x_ddot();
  found[1] = derivative.y_ddot();
  return status;
}

struct Trusted {
  int ok = 0, other = 0;
  double widest = 0;  ///< relative error where the status is ok
};

/// Over 100 states.
template <class Solve>
Trusted in_bowl(double a, Solve solve) {
  std::mt19937 engine(20261124);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  Trusted result;
  for (int k = 0; k < 100; ++k) {
    const Plane at{up_to_one(engine), up_to_one(engine), up_to_one(engine), up_to_one(engine)};
    double found[2];
    const Status status = solve(a, at, found);
    if (status != Status::ok) {
      CHECK(status == Status::singular_mass_matrix);
      ++result.other;
      continue;
    }
    ++result.ok;
    const Truth truth = acceleration_in_bowl(a, at);
    const double error = std::hypot(found[0] - truth.x_ddot, found[1] - truth.y_ddot);
    result.widest = std::max(result.widest, error / truth.size);
  }
  return result;
}

/// The double pendulum with nearly aligned bars, where the first bob has nearly no inertia of its own: against long double.
Trusted of_bobs(double ratio) {
  const auto derivative_of = [ratio](auto one, const double(&values)[4], auto& derivative) {
    using S = decltype(one);
    bobs::Parameters<S> parameters;
    parameters.m2 = static_cast<S>(ratio);
    bobs::State<S> state{};
    for (int i = 0; i < 4; ++i) state.values[i] = static_cast<S>(values[i]);
    return rhs(S(0), state, {}, prepare(parameters), derivative);
  };
  std::mt19937 engine(20261124);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  Trusted result;
  for (int k = 0; k < 100; ++k) {
    const double values[4] = {up_to_one(engine), 1e-9 * up_to_one(engine), up_to_one(engine), up_to_one(engine)};
    bobs::Derivative<double> found{};
    bobs::Derivative<long double> truth{};
    if (derivative_of(1.0, values, found) != Status::ok) {
      ++result.other;
      continue;
    }
    ++result.ok;
    REQUIRE(derivative_of(1.0L, values, truth) == Status::ok);
    const long double size = std::hypot(truth.p_ddot(), truth.q_ddot());
    const long double error = std::hypot(found.p_ddot() - truth.p_ddot(), found.q_ddot() - truth.q_ddot());
    result.widest = std::max(result.widest, static_cast<double>(error / size));
  }
  return result;
}

/// Pendulums with masses 1, 1/R, 1/R² at angles p + q, q + r and r, each of which has the acceleration -g/L sin.
template <class State, class Parameters, class Derivative, class S>
Trusted in_mixed_chart(S ratio) {
  std::mt19937 engine(20261124);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  Parameters parameters;
  parameters.R = ratio;
  const auto prepared = prepare(parameters);
  Trusted result;
  for (int k = 0; k < 100; ++k) {
    State state{};
    state.p() = static_cast<S>(up_to_one(engine));
    state.q() = static_cast<S>(up_to_one(engine));
    state.r() = static_cast<S>(up_to_one(engine));
    Derivative found{};
    const Status status = rhs(S(0), state, {}, prepared, found);
    if (status != Status::ok) {
      CHECK(status == Status::singular_mass_matrix);
      ++result.other;
      continue;
    }
    ++result.ok;
    const double p = static_cast<double>(state.p()), q = static_cast<double>(state.q()),
                 r = static_cast<double>(state.r());
    const double p_ddot = static_cast<double>(found.p_ddot()), q_ddot = static_cast<double>(found.q_ddot()),
                 r_ddot = static_cast<double>(found.r_ddot());
    for (const double error : {p_ddot + q_ddot + 9.81 * std::sin(p + q), q_ddot + r_ddot + 9.81 * std::sin(q + r),
                               r_ddot + 9.81 * std::sin(r)})
      result.widest = std::max(result.widest, std::abs(error) / 9.81);
  }
  return result;
}

}  // namespace

TEST_CASE("a bead on a wall that is nearly upright is told from one on a floor, or the status says that it is not") {
  for (const auto& solve : {by_coordinates, by_equation}) {
    for (const double a : {1.0, 1e2, 1e4}) {
      const Trusted found = in_bowl(a, solve);
      INFO("a = " << a << " 1/m: " << found.widest);
      CHECK(found.ok == 100);
      CHECK(found.widest <= 1e-15 * (10 + 4 * a * a));
    }
    for (const double a : {1e5, 3e5, 1e6, 7.5e6, 1e7, 1e8, 1e12}) {
      const Trusted found = in_bowl(a, solve);
      INFO("a = " << a << " 1/m: " << found.ok << " ok, " << found.widest);
      CHECK(found.widest <= 2e-4);
      if (a >= 1e12) CHECK(found.ok == 0);
    }
  }
}

TEST_CASE("what is light before what is heavy keeps a quarter of its digits, or the status says that it does not") {
  for (const double ratio : {1.0, 1e6, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e20}) {
    const Trusted found = of_bobs(ratio);
    INFO("mass ratio " << ratio << ": " << found.ok << " ok, " << found.widest);
    CHECK(found.widest <= 2e-4);
    if (ratio <= 1e10) CHECK(found.ok == 100);
    if (ratio >= 1e15) CHECK(found.ok == 0);
  }
}

// Each pivot is small beside the diagonal entry by no more than digits allow; what is left of the last one is the product.
TEST_CASE(
    "small pivots one after the other lose what each of them keeps, and the status says so, in both ways to a "
    "solution") {
  using Plain = Trusted (*)(double);
  const Plain by_metric = in_mixed_chart<chart::State<double>, chart::Parameters<double>, chart::Derivative<double>>;
  const Plain in_general =
      in_mixed_chart<stopped::State<double>, stopped::Parameters<double>, stopped::Derivative<double>>;
  for (const Plain found_by : {by_metric, in_general}) {
    for (const double ratio : {1.0, 1e2, 1e4, 1e5, 1e6, 1e7, 1e8, 1e10, 1e14}) {
      const Trusted found = found_by(ratio);
      INFO("each lighter by " << ratio << ": " << found.ok << " ok, " << found.widest);
      CHECK(found.widest <= 2e-4);
      if (ratio <= 1e5) CHECK(found.ok == 100);
      if (ratio >= 1e8) CHECK(found.ok == 0);
    }
  }
}

TEST_CASE("in float, too") {
  for (const float ratio : {1.0F, 10.0F, 100.0F, 1e3F, 1e4F, 1e5F}) {
    for (const Trusted& found :
         {in_mixed_chart<chart::State<float>, chart::Parameters<float>, chart::Derivative<float>>(ratio),
          in_mixed_chart<stopped::State<float>, stopped::Parameters<float>, stopped::Derivative<float>>(ratio)}) {
      INFO("each lighter by " << ratio << ": " << found.ok << " ok, " << found.widest);
      CHECK(found.widest <= 2e-2);
      if (ratio <= 10) CHECK(found.ok == 100);
      if (ratio >= 1e4F) CHECK(found.ok == 0);
    }
  }
}
