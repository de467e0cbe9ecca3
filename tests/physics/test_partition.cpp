// Partitions of the speeds: whichever is current, accelerations and multipliers are those of `rhs` and `reactions`; which one is current is the rule's.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "bennett.hpp"
#include "bicycle.hpp"
#include "bound.hpp"
#include "catch_shim.hpp"
#include "chaplygin_sleigh.hpp"
#include "doubled_skate.hpp"
#include "four_bar.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/integrate/held_partition.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "parallelogram.hpp"
#include "wide_matrix.hpp"

GAUSS_MODEL(Bars, gauss::four_bar);
GAUSS_MODEL(Flat, gauss::parallelogram);
GAUSS_MODEL(Sleigh, gauss::chaplygin_sleigh);

namespace {

using namespace gauss::integrate;
using gauss::Status;
using gauss::simulate::FixedStep;
using physics::at;
using physics::distance;
using physics::grow;
using physics::Matrix;
using physics::start_of;
using physics::Wide;

constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

#define TESTED_MODEL(type, name_space, positions)                                                          \
  struct type {                                                                                            \
    using Parameters = gauss::name_space::Parameters<double>;                                              \
    using State = gauss::name_space::State<double>;                                                        \
    using Prepared = gauss::name_space::Prepared<double>;                                                  \
    using Derivative = gauss::name_space::Derivative<double>;                                              \
    using Inputs = gauss::name_space::Inputs<double>;                                                      \
    using System = gauss::name_space::LinearSystem<double>;                                                \
    using Reactions = gauss::name_space::Reactions<double>;                                                \
    static constexpr int n = gauss::name_space::n_v, n_q = gauss::name_space::n_q;                         \
    static constexpr int l = gauss::name_space::n_constraints;                                             \
    static constexpr bool has_positions = positions;                                                       \
    static_assert(sizeof(Reactions) == sizeof(double) * l * (1 + n), "multipliers, each with its forces"); \
  }
TESTED_MODEL(SleighModel, chaplygin_sleigh, false);
TESTED_MODEL(DoubledModel, doubled_skate, false);
TESTED_MODEL(BicycleModel, bicycle, true);
TESTED_MODEL(FourBarModel, four_bar, true);
TESTED_MODEL(BennettModel, bennett, true);
TESTED_MODEL(FlatModel, parallelogram, true);

template <class M>
gauss::RankRule<double> rule_of(int rank) {
  return M::has_positions ? gauss::rank_on_positions<double>(rank) : gauss::rank_of_velocities<double>(rank);
}

/// All choices of `rank` out of `count`.
std::vector<std::vector<int>> choices(int count, int rank) {
  std::vector<std::vector<int>> result;
  for (int bits = 0; bits < 1 << count; ++bits) {
    std::vector<int> one;
    for (int i = 0; i < count; ++i) {
      if (bits >> i & 1) one.push_back(i);
    }
    if (static_cast<int>(one.size()) == rank) result.push_back(one);
  }
  return result;
}

/// The system with inertias 1 and rows of unit length, in more digits, and (3.6)-(3.7) for one partition as the paper writes them.
template <class M>
class WrittenOut {
 public:
  WrittenOut(const typename M::System& system, const std::vector<int>& rows, const std::vector<int>& dependent)
      : system_(system), rows_(rows), dependent_(dependent) {
    for (int i = 0; i < M::n; ++i) {
      speed_.push_back(1 / std::sqrt(Wide(system.g[i][i])));
      if (std::find(dependent.begin(), dependent.end(), i) == dependent.end()) independent_.push_back(i);
    }
    for (int mu = 0; mu < M::l; ++mu) {
      Wide squares = 0;
      for (int i = 0; i < M::n; ++i) squares += system.b[mu][i] * speed_[at(i)] * system.b[mu][i] * speed_[at(i)];
      row_.push_back(1 / std::sqrt(squares));
    }
    Matrix dependent_part;
    for (const int mu : rows) {
      dependent_part.emplace_back();
      for (const int i : dependent) dependent_part.back().push_back(b(mu, i));
    }
    inverse_ = physics::inverse(dependent_part, 1e-13);  // to the digits of double
    condition_ = inverse_.empty() ? std::numeric_limits<Wide>::infinity()
                                  : physics::norm(inverse_) * std::sqrt(Wide(rows.size()));
  }

  /// Of B_d, where the size of a row is that of all of it: errors of the rows have that size.
  Wide condition() const { return condition_; }

  /// Largest |a_d - a_0 - c a_i|.
  Wide dependent_error(const double* a) const {
    Wide largest = 0;
    for (std::size_t k = 0; k < dependent_.size(); ++k) {
      Wide expected = 0;
      for (std::size_t m = 0; m < rows_.size(); ++m) expected -= inverse_[k][m] * drift(rows_[m]);
      for (const int p : independent_) expected += c(k, p) * a[p] / speed_[at(p)];
      largest = std::max(largest, std::abs(a[dependent_[k]] / speed_[at(dependent_[k])] - expected));
    }
    return largest;
  }

  /// Largest dZ/da_p + c_p^mu dZ/da_mu.
  Wide motion_error(const double* a) const {
    Wide largest = 0;
    for (const int p : independent_) {
      Wide sum = slope(p, a);
      for (std::size_t k = 0; k < dependent_.size(); ++k) sum += c(k, p) * slope(dependent_[k], a);
      largest = std::max(largest, std::abs(sum));
    }
    return largest;
  }

  /// What errors are measured by: accelerations, forces and what rows ask for.
  Wide size(const double* a) const {
    Wide largest = 0;
    for (int i = 0; i < M::n; ++i)
      largest = std::max({largest, std::abs(a[i] / speed_[at(i)]), std::abs(system_.f[i] * speed_[at(i)])});
    for (int mu = 0; mu < M::l; ++mu) largest = std::max(largest, std::abs(drift(mu)));
    return largest;
  }

  Wide speed(int i) const { return speed_[at(i)]; }
  Wide row(int mu) const { return row_[at(mu)]; }

 private:
  Wide b(int mu, int i) const { return row_[at(mu)] * system_.b[mu][i] * speed_[at(i)]; }
  Wide drift(int mu) const { return row_[at(mu)] * system_.drift[mu]; }
  Wide c(std::size_t k, int p) const {
    Wide sum = 0;
    for (std::size_t m = 0; m < rows_.size(); ++m) sum -= inverse_[k][m] * b(rows_[m], p);
    return sum;
  }
  Wide slope(int i, const double* a) const {
    Wide sum = -Wide(system_.f[i]);
    for (int j = 0; j < M::n; ++j) sum += Wide(system_.g[i][j]) * a[j];
    return sum * speed_[at(i)];
  }

  const typename M::System& system_;
  std::vector<int> rows_, dependent_, independent_;
  std::vector<Wide> speed_, row_;
  Matrix inverse_;
  Wide condition_;
};

template <class State, class Prepared, class Reactions>
Status reactions_of(const State& state, const Prepared& prepared, Reactions& result) {
  return reactions(0.0, state, {}, prepared, result);
}

/// Of the initial state, moved at random and back onto the constraints.
template <class M>
typename M::State moved(const typename M::Prepared& prepared, std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  for (;;) {
    typename M::State state{};
    REQUIRE(initial_state(prepared, state) == Status::ok);
    for (int i = 0; i < M::n_q; ++i) state.values[i] += 0.3 * part(random);
    for (int i = 0; i < M::n; ++i) state.values[M::n_q + i] += part(random);
    // One projection stops where errors are squares of small ones, and rows that follow from others then agree to no more digits.
    bool is_there = true;
    for (int k = 0; k < 3; ++k) is_there = is_there && project(0.0, state, prepared, state) == Status::ok;
    if (is_there) return state;
  }
}

struct Worst {
  Wide accelerations = 0, multipliers = 0, written_out = 0;  ///< in units of kappa eps
  int partitions = 0, singular = 0;
};

/// One state: every partition against `rhs`, `reactions` and (3.6)-(3.7).
template <class M>
void compare(const typename M::System& system, const typename M::Derivative& derivative,
             const typename M::Reactions& reactions, int rank, Worst& worst) {
  const double* expected = derivative.values + M::n_q;
  const double* multipliers = reinterpret_cast<const double*>(&reactions);
  const Elimination<double, M::n, M::l> elimination(system, rule_of<M>(rank));
  for (const auto& rows : choices(M::l, rank)) {
    for (const auto& dependent : choices(M::n, rank)) {
      Partition<M::n, M::l> partition;
      partition.rank = rank;
      for (const int mu : rows) partition.is_taken[mu] = true;
      for (const int i : dependent) partition.is_dependent[i] = true;
      const WrittenOut<M> written(system, rows, dependent);
      gauss::LinearSolution<double, M::n, M::l> found;
      const bool is_solved = elimination.solve(partition, found);
      if (!is_solved) {
        CHECK(written.condition() > 1e6);
        ++worst.singular;
        continue;
      }
      CHECK(written.condition() < 1e10);
      ++worst.partitions;
      CHECK(found.motion == Status::ok);
      CHECK(found.reactions == (rank < M::l ? Status::dependent_constraints : Status::ok));
      const Wide unit = written.condition() * k_epsilon * written.size(expected);
      for (int i = 0; i < M::n; ++i)
        worst.accelerations = std::max(worst.accelerations,
                                       std::abs(Wide(found.accelerations[i]) - expected[i]) / written.speed(i) / unit);
      for (int mu = 0; mu < M::l; ++mu)
        worst.multipliers =
            std::max(worst.multipliers,
                     std::abs(Wide(found.multipliers[mu]) - multipliers[mu * (1 + M::n)]) / written.row(mu) / unit);
      worst.written_out = std::max({worst.written_out, written.dependent_error(found.accelerations) / unit,
                                    written.motion_error(found.accelerations) / unit});
    }
  }
}

template <class M>
Worst over_states(int count, int rank, unsigned seed) {
  std::mt19937 random(seed);
  const auto prepared = prepare(typename M::Parameters{});
  Worst worst;
  for (int k = 0; k < count; ++k) {
    const typename M::State state = moved<M>(prepared, random);
    typename M::Derivative derivative{};
    typename M::Reactions reactions{};
    typename M::System system{};
    REQUIRE(is_motion_known(rhs(0.0, state, {}, prepared, derivative)));
    REQUIRE(is_motion_known(reactions_of(state, prepared, reactions)));
    REQUIRE(linear_system(0.0, state, {}, prepared, system) == Status::ok);
    compare<M>(system, derivative, reactions, rank, worst);
  }
  return worst;
}

void check_partitions(const Worst& worst) {
  INFO(worst.partitions << " partitions, " << worst.singular << " singular; "
                        << static_cast<double>(worst.accelerations) << ' ' << static_cast<double>(worst.multipliers)
                        << ' ' << static_cast<double>(worst.written_out) << " of kappa eps");
  CHECK(worst.accelerations <= 100);
  CHECK(worst.multipliers <= 100);
  CHECK(worst.written_out <= 100);
  CHECK(worst.partitions > 0);
}

/// A knife edge: Chaplygin's sleigh whose center of mass is at the blade.
auto knife_edge() {
  gauss::chaplygin_sleigh::Parameters<double> parameters;
  parameters.a = 0;
  parameters.m = parameters.Jc = 1;
  return bind_model<Sleigh>(parameters);
}
using KnifeEdge = decltype(knife_edge());
using KnifeEdgeByParts = PartitionedModel<KnifeEdge, SleighModel::System>;
using KnifeEdgeHeld = Held<Rk4<KnifeEdgeByParts>, SleighModel::System>;
const SleighModel::State k_along_x{{0, 0, 0, 1, 0, 1}};

/// Of the edge's only row.
Partition<3, 1> dependent(int speed) {
  Partition<3, 1> partition;
  partition.rank = 1;
  partition.is_taken[0] = partition.is_dependent[speed] = true;
  return partition;
}

auto four_bar() { return bind_model<Bars>(); }
using FourBar = decltype(four_bar());
using FourBarByParts = PartitionedModel<FourBar, FourBarModel::System>;

}  // namespace

TEST_CASE(
    "every partition that is not singular gives the accelerations and multipliers of the model, and (3.6)-(3.7)") {
  SECTION("one row: Chaplygin's sleigh") { check_partitions(over_states<SleighModel>(200, 1, 1)); }
  SECTION("six rows, nine speeds: bicycle") { check_partitions(over_states<BicycleModel>(10, 6, 2)); }
  SECTION("closed loop: four bars") { check_partitions(over_states<FourBarModel>(100, 2, 3)); }
  SECTION("a row twice: least multipliers of both") { check_partitions(over_states<DoubledModel>(200, 1, 4)); }
  SECTION("four rows of six follow from two: Bennett's linkage") {
    check_partitions(over_states<BennettModel>(20, 2, 5));
  }
}

TEST_CASE("the best partition of a knife edge depends on the larger of cos and sin, which are inverse to conditions") {
  const auto rule = rule_of<SleighModel>(1);
  for (const double angle : {0.1, 0.7, 0.8, 1.5, 2.4, 4.0, 5.4}) {
    SleighModel::System system{};
    SleighModel::State state = k_along_x;
    state.values[2] = angle;
    REQUIRE(linear_system(0.0, state, {}, knife_edge().prepared(), system) == Status::ok);
    const Elimination<double, 3, 1> elimination(system, rule);
    const bool is_y = std::abs(std::cos(angle)) > std::abs(std::sin(angle));
    const Partition<3, 1> best = elimination.best();
    CHECK(best.rank == 1);
    CHECK(best.is_dependent[0] == !is_y);
    CHECK(best.is_dependent[1] == is_y);
    CHECK_FALSE(best.is_dependent[2]);
    CHECK(elimination.condition(dependent(1)) / elimination.condition(dependent(0)) ==
          Approx(std::abs(std::tan(angle))).epsilon(1e-14));
  }
}

// phi = t. One speed has the coefficient cos phi, the other sin phi, and conditions are their inverses: the held one is left where |tan phi| passes 2 or
// 1/2, away from it, which is at phi = atan 2 + k pi/2. Up to 10 that is k = 0 to 5, since atan 2 + 3 pi = 10.53.
TEST_CASE("a held partition is switched where the other one is better by two: six times in ten radians") {
  const double h = 0.001;
  FixedStep<KnifeEdge, Projected<KnifeEdgeHeld>> run(knife_edge(), k_along_x, h, 0,
                                                     Projected<KnifeEdgeHeld>(KnifeEdgeHeld(rule_of<SleighModel>(1))));
  REQUIRE(run.advance(10'000));
  const auto& report = run.stepper().inner().report();
  REQUIRE(report.switches == 6);
  CHECK(report.handed_over == 0);
  for (int k = 0; k < 6; ++k) {
    const double expected = std::atan(2.0) + k * 1.5707963267948966;
    CHECK(report.at(k).time >= expected);
    CHECK(report.at(k).time < expected + h);
    CHECK(static_cast<double>(report.at(k).step) * h == Approx(report.at(k).time).epsilon(1e-14));
  }
  CHECK(std::abs(run.state().values[0] - std::sin(10.0)) < 1e-11);
}

TEST_CASE("near the boundary between two, a held partition stays where the best one goes to and fro") {
  const auto switches = [](double ratio) {
    // To and fro about pi/4, where both are equal.
    FixedStep<KnifeEdge, KnifeEdgeHeld> run(knife_edge(), {{0, 0, 0.7853, 1, 0.9998, 0.01}}, 0.05, 0,
                                            KnifeEdgeHeld(rule_of<SleighModel>(1), {}, ratio));
    for (int k = 0; k < 20; ++k) {
      REQUIRE(run.advance(4));
      run.turn_back();
    }
    return run.stepper().report().switches;
  };
  CHECK(switches(1) >= 10);
  CHECK(switches(2) == 0);
}

TEST_CASE("holding a partition and choosing one at every call give the same motion") {
  const KnifeEdge model = knife_edge();
  const KnifeEdgeByParts at_every_call(model, rule_of<SleighModel>(1));
  FixedStep<KnifeEdge, Projected<KnifeEdgeHeld>> held(model, k_along_x, 0.001, 0,
                                                      Projected<KnifeEdgeHeld>(KnifeEdgeHeld(rule_of<SleighModel>(1))));
  FixedStep<KnifeEdgeByParts, Projected<Rk4<KnifeEdgeByParts>>> chosen(at_every_call, k_along_x, 0.001);
  double largest = 0;
  for (int k = 0; k < 10'000; ++k) {
    REQUIRE((held.advance(1) && chosen.advance(1)));
    grow(largest, distance(held.state(), chosen.state()));
  }
  CHECK(largest <= 1e-11);
  CHECK(chosen.time() == Approx(10));
}

TEST_CASE("every kind of stepper takes a model with a held partition: a linkage moves as without") {
  using Energy = gauss::four_bar::Energy<double>;
  const auto start = start_of(four_bar());
  const auto rule = rule_of<FourBarModel>(2);

  using Explicit = Held<Projected<Rk4<FourBarByParts>>, FourBarModel::System>;
  FixedStep<FourBar, EnergyKept<Explicit, Energy, true>> held(four_bar(), start, 0.001, 0,
                                                              EnergyKept<Explicit, Energy, true>(Explicit(rule)));
  FixedStep<FourBar, EnergyKept<Projected<Rk4<FourBar>>, Energy, true>> plain(four_bar(), start, 0.001);
  REQUIRE((held.advance(2000) && plain.advance(2000)));
  // Rounding grows on the way, that of each of the 2000 steps: so far apart are runs that begin a digit apart and have none besides.
  FourBarModel::State a_digit_off = start;
  a_digit_off.values[0] += 1e-15;
  FixedStep<FourBar, EnergyKept<Projected<Rk4<FourBar>>, Energy, true>> moved(four_bar(), a_digit_off, 0.001);
  REQUIRE(moved.advance(2000));
  CHECK(distance(held.state(), plain.state()) < std::sqrt(2000) * distance(moved.state(), plain.state()));
  CHECK(distance(held.state(), plain.state()) < 1e-8);
  CHECK(held.stepper().inner().report().handed_over == 0);

  using Implicit = Held<GaussLegendre<FourBarByParts, 2>, FourBarModel::System>;
  FixedStep<FourBar, Implicit> implicit(four_bar(), start, 0.001, 0, Implicit(rule));
  FixedStep<FourBar, GaussLegendre<FourBar, 2>> implicit_plain(four_bar(), start, 0.001);
  REQUIRE((implicit.advance(1000) && implicit_plain.advance(1000)));
  CHECK(distance(implicit.state(), implicit_plain.state()) < 1e-10);
}

TEST_CASE(
    "a partition that is singular here, or a rank that falls, leaves results and status to the general solution") {
  const auto prepared = Flat::prepare(gauss::parallelogram::Parameters<double>{});
  const auto model = bind_model<Flat>(prepared, gauss::parallelogram::Inputs<double>{});
  using ByParts = PartitionedModel<decltype(model), FlatModel::System>;
  const auto rule = rule_of<FlatModel>(2);
  FlatModel::State start{}, flat{};
  REQUIRE(initial_state(prepared, start) == Status::ok);
  FlatModel::System system{};
  REQUIRE(linear_system(0.0, start, {}, prepared, system) == Status::ok);
  const auto best = Elimination<double, FlatModel::n, FlatModel::l>(system, rule).best();
  CHECK(best.rank == 2);

  for (int i = 0; i < FlatModel::n; ++i) flat.values[FlatModel::n_q + i] = 1;
  FlatModel::Derivative expected{}, found{};
  CHECK(rhs(0.0, flat, {}, prepared, expected) == Status::dependent_constraints);
  for (const ByParts& by_parts : {ByParts(model, rule, best), ByParts(model, rule)}) {
    CHECK(by_parts.derivative(0.0, flat, found) == Status::dependent_constraints);
    CHECK(distance(found, expected) < 1e-13);
  }
  const ByParts held(model, rule, best);
  held.derivative(0.0, flat, found);
  CHECK(held.handed_over() == 1);

  // y depends on x always, where the blade points along y.
  const KnifeEdge edge = knife_edge();
  const KnifeEdgeByParts fixed(edge, rule_of<SleighModel>(1), dependent(1));
  SleighModel::Derivative of_edge{}, of_fixed{};
  const SleighModel::State along_y{{0, 0, 1.5707963267948966, 0, 1, 1}};
  CHECK(edge.derivative(0.0, along_y, of_edge) == Status::ok);
  CHECK(fixed.derivative(0.0, along_y, of_fixed) == Status::ok);
  CHECK(distance(of_edge, of_fixed) < 1e-14);
  CHECK(fixed.handed_over() == 1);
}

TEST_CASE("simulations with an estimate of their error take a model that chooses its partition at every call") {
  const KnifeEdge model = knife_edge();
  gauss::simulate::Settings<double> settings;
  settings.tolerance = 1e-12;
  gauss::simulate::Simulation<KnifeEdgeByParts> run(KnifeEdgeByParts(model, rule_of<SleighModel>(1)), k_along_x, 0,
                                                    settings);
  REQUIRE(run.advance_to(10));
  CHECK(std::abs(run.state().values[0] - std::sin(10.0)) < 1e-10);
  CHECK(std::abs(run.state().values[1] - (1 - std::cos(10.0))) < 1e-10);
}

namespace {

/// Two speeds, of which two rows say the same, up to what is changed.
struct SameTwice {
  double g[2][2] = {{1, 0}, {0, 4}};
  double f[2] = {1, 2};
  double b[2][2] = {{1, 1}, {2, 2}};
  double reach[2][2] = {{1, 1}, {2, 2}};
  double of_positions[2] = {0, 0};
  double off[2] = {0, 0};
  double drift[2] = {0.5, 1};
  double drift_error[2] = {0, 0};
};

/// Whether the partition of rank 1 is enough.
bool is_carried(const SameTwice& system, gauss::LinearSolution<double, 2, 2>& solution) {
  const auto rule = gauss::rank_of_velocities<double>(1);
  Partition<2, 2> partition;
  partition.rank = 1;
  partition.is_taken[0] = partition.is_dependent[1] = true;
  return Elimination<double, 2, 2>(system, rule).solve(partition, solution);
}

}  // namespace

TEST_CASE("rows that contradict, rows that say more, and inertias that are missing are not passed over") {
  gauss::LinearSolution<double, 2, 2> solution;
  REQUIRE(is_carried({}, solution));
  // By hand: a_2 = -1/2 - a_1 and a_1 - 1 = 4 a_2 - 2.
  CHECK(solution.accelerations[0] == Approx(-0.6).epsilon(1e-15));
  CHECK(solution.accelerations[1] == Approx(0.1).epsilon(1e-14));
  CHECK(solution.multipliers[0] + 2 * solution.multipliers[1] == Approx(-1.6).epsilon(1e-15));
  // Least where rows have unit length: equal shares, of rows whose lengths are 1 to 2.
  CHECK(solution.multipliers[0] == Approx(2 * solution.multipliers[1]).epsilon(1e-15));

  SameTwice contradicts;
  contradicts.drift[1] = 1.001;
  CHECK_FALSE(is_carried(contradicts, solution));
  SameTwice says_more;
  says_more.b[1][0] = 2.001;
  CHECK_FALSE(is_carried(says_more, solution));
  SameTwice weightless;
  weightless.g[0][0] = weightless.g[1][1] = 0;
  CHECK_FALSE(is_carried(weightless, solution));
}

TEST_CASE("what is not a number has a status, and the state before it stays") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    for (int i = 2; i < 6; ++i) {
      SleighModel::State state = k_along_x;
      state.values[i] = bad;
      const KnifeEdge edge = knife_edge();
      SleighModel::Derivative derivative{};
      CHECK(KnifeEdgeByParts(edge, rule_of<SleighModel>(1)).derivative(0.0, state, derivative) == Status::not_finite);
      FixedStep<KnifeEdge, KnifeEdgeHeld> run(edge, state, 0.001, 0, KnifeEdgeHeld(rule_of<SleighModel>(1)));
      CHECK_FALSE(run.advance(1));
      CHECK(run.last().outcome == StepOutcome::model_failed);
      CHECK(run.last().status == Status::not_finite);
      CHECK(run.stepper().report().switches == 0);
    }
  }
}
