// Loops in space that move although equations are as many as motions, or more: Bennett's linkage, Bricard's ring with threefold symmetry and
// Sarrus's linkage. Six equations close each; of Bennett's two say something, of the others four. Where Sarrus's lies flat, only two do: each
// pair of its legs may turn by itself there.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "bennett.hpp"
#include "bricard.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "process.hpp"
#include "registry.hpp"
#include "sarrus.hpp"
#include "without_rank.hpp"

namespace hard_cases {

GAUSS_MODEL(BennettModel, gauss::bennett);
GAUSS_MODEL(BricardModel, gauss::bricard);
GAUSS_MODEL(SarrusModel, gauss::sarrus);

namespace {

constexpr double k_turn = 6.283185307179586, k_pi = k_turn / 2;

/// What two angles differ by, within half a turn.
double apart(double a, double b) { return std::remainder(a - b, k_turn); }

// Each with an angle that grows by a turn as the linkage comes round, and with relations between its hinges by closed form.

struct Bennett : BennettModel {
  using Energy = gauss::bennett::Energy<double>;
  using Residuals = gauss::bennett::Residuals<double>;
  using Mobility = gauss::bennett::Mobility<double>;
  using System = gauss::bennett::LinearSystem<double>;
  static constexpr std::int64_t steps = 140'000;
  static double phase(const double* y) { return y[0]; }
  /// Bennett (1903): tan(q1/2) tan(q2/2) is a constant of the twists; opposite hinges turn alike.
  static void grow_misses(const double* y, double& largest) {
    const gauss::bennett::Parameters<double> p;
    const double v = std::asin(1.5 * std::sin(p.u));
    grow(largest, std::sin(y[0] / 2) * std::sin(y[1] / 2) * std::sin((v - p.u) / 2) -
                      std::cos(y[0] / 2) * std::cos(y[1] / 2) * std::sin((v + p.u) / 2));
    grow(largest, apart(y[2], -y[0]));
  }
};

struct Bricard : BricardModel {
  using Energy = gauss::bricard::Energy<double>;
  using Residuals = gauss::bricard::Residuals<double>;
  using Mobility = gauss::bricard::Mobility<double>;
  using System = gauss::bricard::LinearSystem<double>;
  static constexpr std::int64_t steps = 125'000;
  static double phase(const double* y) { return std::atan2(y[1], y[0]); }
  /// Chen, You and Tarnai (2005), twists of a quarter turn: cos q1 + cos q2 + cos q1 cos q2 = 0; every second hinge turns alike.
  static void grow_misses(const double* y, double& largest) {
    grow(largest, std::cos(y[0]) + std::cos(y[1]) + std::cos(y[0]) * std::cos(y[1]));
    for (const double difference : {apart(y[2], y[0]), apart(y[4], y[0]), apart(y[3], y[1])}) grow(largest, difference);
  }
};

struct Sarrus : SarrusModel {
  using Energy = gauss::sarrus::Energy<double>;
  using Residuals = gauss::sarrus::Residuals<double>;
  using Mobility = gauss::sarrus::Mobility<double>;
  using System = gauss::sarrus::LinearSystem<double>;
  static constexpr std::int64_t steps = 75'000;
  static double phase(const double* y) { return std::atan2(y[5] / 8, y[0] + 0.38); }
  /// The plate stays level and legs of a pair are symmetrical.
  static void grow_misses(const double* y, double& largest) {
    grow(largest, apart(y[1], -2 * y[0] - k_pi));
    grow(largest, apart(y[2], y[0] + k_pi));
    grow(largest, apart(y[3], -y[0]));
    grow(largest, apart(y[4], 2 * y[0] + k_pi));
  }
};

/// Where it lies flat in the middle of its swing, without gravity and with a spring of no length.
struct FlatSarrus : Sarrus {
  static constexpr std::int64_t steps = 100'000;
  static double phase(const double* y) { return std::atan2(y[5] / 8, y[0]); }
};

struct Run {
  double gap = 0;        ///< m
  double energy = 0;     ///< relative
  double misses = 0;     ///< of the relations between hinges
  double uncounted = 0;  ///< states whose mobility is not 1, or whose motion is not known
  double turns = 0;
  double seconds = 0;
  Series series = {};
};

template <class Loop, class Stepper, class Model>
Run run(const Model& model, const typename Model::State& start, std::int64_t steps, const char* name) {
  Stopwatch stopwatch;
  Run result;
  result.series.name = name;
  typename Loop::Energy energy_now{};
  (void)energy(0.0, start, model.prepared(), energy_now);
  const double first = energy_now.total;
  double phase = Loop::phase(start.values);
  gauss::simulate::FixedStep<Model, Stepper> moving(model, start, 0.001);
  const bool arrives = moving.advance(steps, [&](double t, const auto& state) {
    typename Loop::Residuals gaps{};
    (void)residuals(t, state, {}, model.prepared(), {}, gaps);
    for (const double f : gaps.position) grow(result.gap, f);
    (void)energy(t, state, model.prepared(), energy_now);
    grow(result.energy, energy_now.total / first - 1);
    Loop::grow_misses(state.values, result.misses);
    const double now = Loop::phase(state.values);
    result.turns += apart(now, phase) / k_turn;
    phase = now;
    if (moving.last().status != gauss::Status::ok) ++result.uncounted;
    if (moving.steps() % 10 == 0) {
      typename Loop::Mobility found{};
      if (mobility(t, state, {}, model.prepared(), found) != gauss::Status::ok || found.mobility != 1)
        ++result.uncounted;
    }
    if (moving.steps() % std::max<std::int64_t>(1, steps / 60) != 0) return;
    result.series.t.push_back(t);
    result.series.values.push_back(result.gap);
  });
  if (!arrives || !(result.gap <= 1e300)) result.gap = result.energy = result.misses = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

struct Runs {
  Run naive, ours;
  Run drifting;  ///< with our accelerations, not projected
};

template <class Loop>
Runs runs(const typename Loop::template Parameters<double>& parameters = {}) {
  const auto prepared = Loop::prepare(parameters);
  const auto model = gauss::integrate::bind_model<Loop>(prepared, typename Loop::template Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  using Naive = WithoutRank<Model, typename Loop::System>;
  typename Loop::template State<double> start;
  Runs result;
  if (initial_state(prepared, start) != gauss::Status::ok) return result;
  result.naive = run<Loop, gauss::integrate::Rk4<Naive>>(Naive(model), start, Loop::steps, "rk4, no rank decided");
  using Rk4 = gauss::integrate::Rk4<Model>;
  result.drifting = run<Loop, Rk4>(model, start, Loop::steps / 4, "rk4, not projected");
  result.ours = run<Loop, gauss::integrate::Projected<Rk4>>(model, start, Loop::steps, "rk4, projected");
  return result;
}

/// At the angle of the legs with the plates.
gauss::sarrus::State<double> sarrus_at(double angle, double rate) {
  return {{-angle, 2 * angle - k_pi, k_pi - angle, angle, k_pi - 2 * angle, -rate, 2 * rate, -rate, rate, -2 * rate}};
}

/// A(angle) angle'' + A'(angle) angle'^2/2 + V' = 0: the linkage with one coordinate, by hand.
double sarrus_acceleration(const gauss::sarrus::Parameters<double>& p, double angle, double rate) {
  const double c = std::cos(angle), s = std::sin(angle), square = p.l * p.l;
  const double legs = 2 * p.m * square * (1.0 / 12 + 1.0 / 4) + 2 * p.m * square * (1.0 / 12 + (s * s + 9 * c * c) / 4);
  const double inertia = legs + 4 * p.M * square * c * c;
  const double slope = -8 * (p.m + p.M) * square * s * c;
  const double height = 2 * p.l * s, rise = 2 * p.l * c;
  const double push = p.c * (height - p.b) * rise + p.g * (p.M * rise + 4 * p.m * p.l * c);
  return (-slope * rate * rate / 2 - push) / inertia;
}

double error_of_accelerations() {
  const gauss::sarrus::Parameters<double> p;
  const auto prepared = prepare(p);
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.75 + 0.7 * std::sin(0.7 * i), rate = 5 * std::cos(1.3 * i);
    gauss::sarrus::Derivative<double> rates{};
    if (rhs(0.0, sarrus_at(angle, rate), {}, prepared, rates) != gauss::Status::ok) return k_breaks_down;
    const double exact = sarrus_acceleration(p, angle, rate), size = std::abs(exact) + rate * rate;
    grow(largest, (rates.values[5] + exact) / size);
    grow(largest, (rates.values[8] - exact) / size);
  }
  return largest;
}

gauss::sarrus::Parameters<double> symmetrical() {
  gauss::sarrus::Parameters<double> parameters;
  parameters.g = parameters.b = 0;
  return parameters;
}

constexpr double k_beside[] = {0, 1e-16, 1e-15, 3e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4};

/// Relations between hinges in a second from a projected start that is flat, or nearly so.
double misses_from_flat() {
  const auto prepared = Sarrus::prepare(symmetrical());
  const auto model = gauss::integrate::bind_model<Sarrus>(prepared, gauss::sarrus::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  double largest = 0;
  for (const double beside : k_beside) {
    for (const double angle : {beside, -beside}) {
      gauss::sarrus::State<double> start = sarrus_at(angle, 3);
      const gauss::Status status = project(0.0, start, prepared, start);
      if (!gauss::integrate::is_motion_known(status)) return k_breaks_down;
      const Run from_here = run<FlatSarrus, gauss::integrate::Projected<gauss::integrate::Rk4<Model>>>(
          model, start, 1000, "beside the switch");
      grow(largest, from_here.misses);
    }
  }
  return largest;
}

/// Beside the flat position: states with another mobility than 3 where it is that to rounding and 1 where it is not, or with accelerations that
/// are wrong and have no status.
double wrong_beside_flat() {
  const gauss::sarrus::Parameters<double> parameters = symmetrical();
  const auto prepared = prepare(parameters);
  double wrong = 0;
  for (const double angle : k_beside) {
    const gauss::sarrus::State<double> state = sarrus_at(angle, 3);
    gauss::sarrus::Derivative<double> rates{};
    gauss::sarrus::Mobility<double> found{};
    const gauss::Status status = rhs(0.0, state, {}, prepared, rates);
    (void)mobility(0.0, state, {}, prepared, found);
    if (angle <= 1e-15 && (found.mobility != 3 || status != gauss::Status::dependent_constraints)) ++wrong;
    if (angle >= 1e-8 && (found.mobility != 1 || status != gauss::Status::ok)) ++wrong;
    const double exact = sarrus_acceleration(parameters, angle, 3);
    if (status == gauss::Status::ok && !(std::abs(rates.values[5] + exact) <= 1e-10)) ++wrong;
    for (const double rate : rates.values) {
      if (!std::isfinite(rate)) ++wrong;
    }
  }
  return wrong;
}

/// Of a model of this folder: 0 if the generator says that its mobility is 1, in --check and in the header.
double uncounted(const std::string& model) {
  const std::string text = "'" GAUSS_GEN "' '" GAUSS_SOURCE_DIR "/hard_cases/models/" + model + ".yaml' ";
  const Outcome check = run_program(text + "--check"), header = run_program(text + "-o -");
  const bool is_told = check.said.find("ok, mobility 1 (") != std::string::npos &&
                       header.said.find("Where nothing singles a state out: mobility 1 (") != std::string::npos;
  return is_told ? 0 : 1;
}

Figure closure(const char* id, const char* what, const Runs& found) {
  char remark[96];
  std::snprintf(remark, sizeof remark, "%.0f turns in %.0f s; naive: RK4, and all rows by elimination",
                std::abs(std::trunc(found.ours.turns)), found.ours.series.t.empty() ? 0.0 : found.ours.series.t.back());
  const double ours = std::abs(found.ours.turns) >= 100 ? found.ours.gap : k_breaks_down;
  return {id, what, "m", found.naive.gap, ours, 1e-10, found.naive.seconds, found.ours.seconds, remark, {}};
}

}  // namespace

std::vector<Figure> over_constrained(const Scope&) {
  const Runs of_bennett = runs<Bennett>(), of_bricard = runs<Bricard>(), of_sarrus = runs<Sarrus>();
  const Runs through_flat = runs<FlatSarrus>(symmetrical());
  double energy = 0, misses = 0, not_one = 0;
  for (const Runs* each : {&of_bennett, &of_bricard, &of_sarrus}) {
    grow(energy, each->ours.energy);
    grow(misses, each->ours.misses);
    not_one += each->ours.uncounted;
  }
  // What joints and bars count: speeds less equations, which is below 1 for all three.
  constexpr double k_by_counting = 3;
  std::vector<Figure> figures = {
      closure("H09.bennett", "largest gap of Bennett's linkage", of_bennett),
      closure("H09.bricard", "largest gap of Bricard's ring of six, which turns inside out", of_bricard),
      closure("H09.sarrus", "largest gap of Sarrus's linkage, which swings", of_sarrus),
      closure("H09.switch", "largest gap of Sarrus's linkage, which lies flat twice in a swing", through_flat),
      {"H09.branch", "hinges of that one beside those of legs that go as pairs", "rad", through_flat.naive.misses,
       through_flat.ours.misses, 1e-9},
      {"H09.beside", "the same from 28 projected starts, up to 1e-4 rad beside the flat position", "rad", std::nullopt,
       misses_from_flat(), 1e-9},
      {"H09.flat", "of 14 states there, those with another mobility than 3 or 1, or wrong without a status", "1",
       std::nullopt, wrong_beside_flat(), 0},
      {"H09.shape", "relations between hinges of the first three, beside closed forms", "1", std::nullopt, misses,
       1e-10},
      {"H09.energy", "relative error of the energy of the first three", "1", std::nullopt, energy, 1e-6},
      {"H09.accelerations", "accelerations of Sarrus's linkage beside an equation with one coordinate, 200 states", "1",
       std::nullopt, error_of_accelerations(), 1e-13},
      {"H09.mobility", "states on the way whose mobility is not 1, or whose motion has a status", "1", std::nullopt,
       not_one, 0},
      {"H09.generated",
       "of 3 models, those for which the generator does not count mobility 1 (naive: speeds less equations)", "1",
       k_by_counting, uncounted("bennett") + uncounted("bricard") + uncounted("sarrus"), 0}};
  figures[1].charts = {of_bricard.drifting.series, of_bricard.ours.series};
  return figures;
}

}  // namespace hard_cases
