// The integration itself, on models written by hand that misbehave on purpose.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "catch_shim.hpp"
#include "gauss/simulate/simulation.hpp"

namespace {

using gauss::Status;
using gauss::simulate::Outcome;

/// y' = rate(t, y), in the shape of an emitted model.
namespace line {

template <class S>
struct State {
  S values[1];
};
template <class S>
struct Derivative {
  S values[1];
};
template <class S>
struct Inputs {};

template <class S>
struct Prepared {
  S rate = 1;
  S growth = 0;
  S wave = 0;            // times cos(10 t)
  S pulse = 0;           // from 3.1 to 3.2
  S wall = 1e300;        // the model fails beyond it
  S hole = 1e300;        // rates beyond it are NaN, with status ok: a model that lies
  S projected = -1e300;  // projection moves lower states up to here; NaN: it fails
  S ledge = 1e300;       // projection moves higher states up by 1
  S flat = 1e300;        // constraints depend on each other beyond it, for a tenth
};

template <class S>
Status rhs(const S& t, const State<S>& state, const Inputs<S>&, const Prepared<S>& p, Derivative<S>& derivative) {
  const S y = state.values[0];
  derivative.values[0] =
      y > p.hole ? std::numeric_limits<S>::quiet_NaN() : p.rate + p.growth * y + p.wave * std::cos(10 * t);
  if (t > S(3.1) && t < S(3.2)) derivative.values[0] += p.pulse;
  if (y > p.flat && y < p.flat + S(0.1)) return Status::dependent_constraints;
  return y > p.wall ? Status::singular_mass_matrix : Status::ok;
}

template <class S>
Status project(const S&, const State<S>& from, const Prepared<S>& p, State<S>& state) {
  if (std::isnan(p.projected)) return Status::violated_constraints;
  state.values[0] = std::max(from.values[0], p.projected) + (from.values[0] > p.ledge ? 1 : 0);
  return Status::ok;
}

}  // namespace line

struct Line {
  static constexpr int n_q = 1, n_v = 0;
  template <class S>
  using Parameters = line::Prepared<S>;
  template <class S>
  using Prepared = line::Prepared<S>;
  template <class S>
  using Inputs = line::Inputs<S>;
  template <class S>
  using State = line::State<S>;
  template <class S>
  using Derivative = line::Derivative<S>;
  template <class S>
  static Prepared<S> prepare(const Parameters<S>& parameters) {
    return parameters;
  }
  template <class S>
  static Status rhs(const S& t, const State<S>& state, const Inputs<S>& inputs, const Prepared<S>& p,
                    Derivative<S>& result) {
    return line::rhs(t, state, inputs, p, result);
  }
};

using Prepared = line::Prepared<double>;
using State = line::State<double>;

auto model_with(const Prepared& prepared) {
  return gauss::integrate::bind_model<Line>(prepared, line::Inputs<double>{});
}

}  // namespace

TEST_CASE("requested times are reached exactly, and the solution there is accurate") {
  Prepared prepared;
  prepared.rate = 0;
  prepared.growth = -1;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{1.0}});
  for (const double t : {0.1, 0.3, 0.30000001, 1.7, 5.0}) {
    REQUIRE(simulation.advance_to(t));
    CHECK(simulation.time() == t);
    CHECK(simulation.state().values[0] == Approx(std::exp(-t)).epsilon(0).margin(1e-11));
  }
  CHECK(simulation.report().steps > 0);
  CHECK(simulation.report().calls >= 13 * simulation.report().steps);
  CHECK(simulation.report().status == Status::ok);
}

TEST_CASE("what depends on time alone is integrated as accurately, however far apart the requested times are") {
  Prepared prepared;
  prepared.rate = 0;
  prepared.wave = 10;
  for (const double span : {0.1, 1.0, 10.0, 40.0}) {
    gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
    for (double t = span; t <= 40; t += span) REQUIRE(simulation.advance_to(t));
    CHECK(simulation.state().values[0] == Approx(std::sin(10 * simulation.time())).epsilon(0).margin(1e-10));
  }
}

TEST_CASE("a pulse between the times at which a step looks is seen with a longest step") {
  Prepared prepared;
  prepared.rate = 0;
  prepared.pulse = 10;
  gauss::simulate::Settings<double> settings;
  settings.longest_step = 0.05;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}}, 0.0, settings);
  REQUIRE(simulation.advance_to(5));
  CHECK(simulation.report().steps >= 100);
  CHECK(simulation.state().values[0] == Approx(1).epsilon(0).margin(1e-9));
}

TEST_CASE("times may be of any unit: a motion of femtoseconds is followed from a first step that is too long") {
  Prepared prepared;
  prepared.rate = 0;
  prepared.growth = -1e15;
  gauss::simulate::Settings<double> settings;
  settings.first_step = 1e-3;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{1e-3}}, 0.0, settings);
  REQUIRE(simulation.advance_to(1e-14));
  CHECK(simulation.report().rejected > 0);
  CHECK(simulation.state().values[0] == Approx(1e-3 * std::exp(-10.0)).margin(1e-9));
}

TEST_CASE("a step has the order 8, and its estimate the order 7, in state and time") {
  using Array = std::array<double, 2>;
  // y' = -2 t y^2, y = 1/(1 + t^2), and z' = cos 3t.
  const auto system = [](const Array& x, Array& rates, double t) { rates = {-2 * t * x[0] * x[0], std::cos(3 * t)}; };
  const auto exact = [](double t) { return Array{1 / (1 + t * t), std::sin(3 * t) / 3}; };
  gauss::integrate::PrinceDormand87<Array, double> stepper;
  const auto errors = [&](double h) {
    Array x = exact(0.3), estimate{};
    stepper.do_step(system, x, 0.3, h, estimate);
    const Array wanted = exact(0.3 + h);
    return std::array<double, 4>{std::abs(x[0] - wanted[0]), std::abs(x[1] - wanted[1]), std::abs(estimate[0]),
                                 std::abs(estimate[1])};
  };
  const auto coarse = errors(0.4), fine = errors(0.2);
  const double least[] = {8.5, 8.5, 7.5, 7.5}, most[] = {11, 11, 9, 9};
  for (std::size_t i = 0; i < 4; ++i) {
    INFO(i);
    const double order = std::log2(coarse[i] / fine[i]);
    CHECK(order > least[i]);
    CHECK(order < most[i]);
    CHECK(fine[i] > 0);
  }
}

TEST_CASE("requested times far apart are reached exactly, too") {
  gauss::simulate::Simulation simulation(model_with({}), State{{0.0}});
  // More than twice the time before: the difference of the two is rounded.
  for (double t = 1e-6; t < 1e6; t *= 3.3) {
    REQUIRE(simulation.advance_to(t));
    CHECK(simulation.time() == t);
  }
}

TEST_CASE("a step cut short to reach a requested time does not shorten the steps after it") {
  Prepared prepared;
  prepared.rate = 0;
  prepared.growth = -1;
  gauss::simulate::Simulation undisturbed(model_with(prepared), State{{1.0}});
  REQUIRE(undisturbed.advance_to(10));
  gauss::simulate::Simulation disturbed(model_with(prepared), State{{1.0}});
  for (int k = 1; k <= 10; ++k) {
    REQUIRE(disturbed.advance_to(k - 1e-9));
    REQUIRE(disturbed.advance_to(k));
  }
  CHECK(disturbed.report().steps <= undisturbed.report().steps + 2 * 10);
}

TEST_CASE("a status other than ok stops the simulation before the trouble, and is reported") {
  Prepared prepared;
  prepared.wall = 1;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK_FALSE(simulation.advance_to(2));
  CHECK(simulation.time() == Approx(1.0).margin(1e-9));
  CHECK(simulation.state().values[0] <= 1.0);
  CHECK(simulation.report().outcome == Outcome::step_too_small);
  CHECK(simulation.report().status == Status::singular_mass_matrix);
  CHECK(simulation.report().rejected > 0);
  // It does not go on by itself.
  CHECK_FALSE(simulation.advance_to(3));
}

TEST_CASE("a model that fails at the start is reported") {
  Prepared prepared;
  prepared.wall = -1;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK_FALSE(simulation.advance_to(2));
  CHECK(simulation.report().outcome == Outcome::model_failed);
  CHECK(simulation.report().status == Status::singular_mass_matrix);
  CHECK(simulation.time() == 0);
}

TEST_CASE("a NaN is never accepted, whatever status comes with it") {
  Prepared prepared;
  prepared.hole = 1;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK_FALSE(simulation.advance_to(2));
  CHECK(simulation.state().values[0] <= 1.0);
  CHECK(simulation.report().outcome != Outcome::running);
}

TEST_CASE("the start and every accepted step are projected, and the observer sees both states") {
  Prepared prepared;
  prepared.projected = 5;
  prepared.rate = -1e-12;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK(simulation.state().values[0] == 5);
  CHECK(simulation.report().start_moved == 5);
  CHECK(simulation.report().start_component == 0);
  std::vector<double> before, after;
  REQUIRE(simulation.advance_to(1, [&](double, const State& from, const State& to) {
    before.push_back(from.values[0]);
    after.push_back(to.values[0]);
  }));
  REQUIRE(static_cast<long>(after.size()) == simulation.report().steps);
  CHECK(before.front() < 5);
  CHECK(*std::min_element(after.begin(), after.end()) == 5);
  CHECK(simulation.report().start_moved == 5);  // of the start alone
}

TEST_CASE("the report says of the start which component moved most, and nothing where it may not move") {
  struct Pair {
    double values[2];
  };
  gauss::simulate::Report<Status> report;
  report.compare_start(Pair{{1, 2}}, Pair{{1.5, -1}}, 2);
  CHECK(report.start_moved == 3);
  CHECK(report.start_component == 1);

  Prepared prepared;
  prepared.projected = 5;
  gauss::simulate::Settings<double> settings;
  settings.project = false;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}}, 0.0, settings);
  CHECK(simulation.report().start_moved == 0);
}

TEST_CASE("settings that are no numbers or out of their range are refused, and so is a start at no time") {
  using Settings = gauss::simulate::Settings<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto with = [](auto member, auto value) {
    Settings settings;
    settings.*member = value;
    return settings;
  };
  const auto is_refused = [](const Settings& settings, double start_time) {
    gauss::simulate::Simulation simulation(model_with(Prepared{}), State{{0.0}}, start_time, settings);
    const bool arrived = simulation.advance_to(1);
    CHECK(simulation.state().values[0] == Approx(arrived ? 1 : 0).margin(1e-12));
    CHECK(simulation.report().steps == (arrived ? simulation.report().steps : 0));
    return !arrived && simulation.report().outcome == Outcome::bad_settings;
  };
  CHECK_FALSE(is_refused({}, 0));
  for (const double value : {-1e-12, 0.0, nan, infinite}) CHECK(is_refused(with(&Settings::tolerance, value), 0));
  for (auto member : {&Settings::smallest_scale, &Settings::smallest_speed, &Settings::first_step,
                      &Settings::longest_step, &Settings::most_projected})
    for (const double value : {-1e-12, nan}) CHECK(is_refused(with(member, value), 0));
  CHECK(is_refused(with(&Settings::most_steps, -1L), 0));
  CHECK(is_refused({}, nan));
  CHECK(is_refused({}, -infinite));
  CHECK_FALSE(is_refused(with(&Settings::longest_step, infinite), 0));
  CHECK(name(Outcome::bad_settings) == std::string("bad settings"));
}

TEST_CASE("a projection that jumps however short the step stops the simulation, unless it is allowed to") {
  Prepared prepared;
  prepared.ledge = 0.5;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK_FALSE(simulation.advance_to(1));
  CHECK(simulation.report().outcome == Outcome::constraints_lost);
  CHECK(simulation.time() == Approx(0.5));
  CHECK(simulation.state().values[0] == Approx(0.5));

  gauss::simulate::Settings<double> settings;
  settings.most_projected = 1e300;
  gauss::simulate::Simulation patient(model_with(prepared), State{{0.0}}, 0.0, settings);
  CHECK(patient.advance_to(1));
  CHECK(patient.state().values[0] >= 2);
}

TEST_CASE("a projection that fails stops the simulation") {
  Prepared prepared;
  prepared.projected = std::numeric_limits<double>::quiet_NaN();
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}});
  CHECK_FALSE(simulation.advance_to(1));
  CHECK(simulation.report().outcome == Outcome::step_too_small);
  CHECK(simulation.report().status == Status::violated_constraints);
  CHECK(simulation.time() == 0);
}

TEST_CASE("where constraints say less than usual the motion goes on, and the report says in how many steps") {
  Prepared prepared;
  prepared.flat = 0.5;
  gauss::simulate::Settings<double> settings;
  settings.longest_step = 0.01;
  gauss::simulate::Simulation simulation(model_with(prepared), State{{0.0}}, 0.0, settings);
  REQUIRE(simulation.advance_to(1));
  CHECK(simulation.state().values[0] == Approx(1).epsilon(1e-14));
  CHECK(simulation.report().with_fewer_constraints >= 10);
  CHECK(simulation.report().with_fewer_constraints <= 12);
  CHECK(simulation.report().steps > 50);
}

TEST_CASE("inputs may be a function of time and state") {
  const auto controller = [](double, const State&) { return line::Inputs<double>{}; };
  const auto model = gauss::integrate::bind_model<Line>(Prepared{}, controller);
  gauss::simulate::Simulation simulation(model, State{{0.0}});
  REQUIRE(simulation.advance_to(1));
  CHECK(simulation.state().values[0] == Approx(1.0));
}

TEST_CASE("a time before the present one is not reached, nor one that is no number") {
  gauss::simulate::Simulation simulation(model_with(Prepared{}), State{{0.0}}, 3.0);
  CHECK_FALSE(simulation.advance_to(2));
  CHECK_FALSE(simulation.advance_to(std::numeric_limits<double>::quiet_NaN()));
  CHECK(simulation.time() == 3);
  CHECK(simulation.advance_to(3));
  CHECK(simulation.advance_to(4));
}
