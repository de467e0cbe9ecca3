// What errors of outputs are relative to: docs/scenes.md.

#include <cmath>
#include <functional>
#include <limits>

#include "catch_shim.hpp"
#include "sim/run/error_estimate.hpp"

using gausssim::Column;
using gausssim::Rows;
using gausssim::Yardstick;

namespace {

constexpr long k_samples = 101;
constexpr double k_tight = 1e-12, k_rounding = 1e-18;

using Motion = std::function<std::vector<long double>(long double t)>;

Rows rows_of(const Motion& motion) {
  Rows rows(motion(0).size(), k_samples);
  for (long k = 0; k < k_samples; ++k) rows.set(k, motion(static_cast<long double>(k) / 10));
  return rows;
}

Column column(const std::string& name, const std::string& unit) {
  Column result;
  result.name = name;
  result.unit = unit;
  return result;
}

/// Some digits that two runs do not share.
long double noise(long double t, int seed) { return std::sin(1e4L * t + static_cast<long double>(seed)); }

}  // namespace

TEST_CASE("an output that ranges over little keeps its own range beside one of its unit that ranges over much") {
  const auto motion = [](long double off, int seed) {
    return [=](long double t) {
      return std::vector<long double>{6e5L * t, 0.02L * std::cos(t) + off * 0.02L + 1e-14L * noise(t, seed)};
    };
  };
  const Yardstick yardstick(rows_of(motion(0, 1)), rows_of(motion(0, 2)),
                            {column("rotor", "rad"), column("swing", "rad")}, k_tight, k_rounding);
  CHECK(yardstick.constants().empty());
  const auto error = yardstick.error_of(rows_of(motion(0.1L, 1)));
  CHECK(error.output == "swing");
  CHECK(error.value == Approx(0.05).epsilon(1e-3));
}

TEST_CASE("an output that two runs begin alike and then lose keeps its own range, however small it is") {
  // Of unit circles, once around in 6.3 s: rows are 0.1 s apart.
  const auto motion = [](double size, double beside, double drift, int seed) {
    return [=](long double t) {
      const long double noisy = static_cast<long double>(size) * 1e-9L * noise(t, seed);
      return std::vector<long double>{beside * std::cos(t), size * std::sin(t * (1 + drift * t)) + noisy};
    };
  };
  const std::vector<Column> columns{column("z", "m"), column("y", "m")};
  const double loose = gausssim::least_range(1e-3);
  for (const double beside : {0.0, 1.0, 1e7}) {
    const double size = beside > 0 ? 1 : 1e-13;
    const Yardstick yardstick(rows_of(motion(size, beside, 0, 1)), rows_of(motion(size, beside, 0.1, 2)), columns,
                              loose, k_rounding);
    CHECK(yardstick.scale(1) == Approx(2 * size).epsilon(1e-3));
    CHECK(yardstick.error_of(rows_of(motion(size, beside, 0.1, 2))).value > 0.5);
  }
}

TEST_CASE("a wiggle on a large value keeps its own range as long as it is told apart from noise") {
  const auto motion = [](long double wiggle, int seed) {
    return
        [=](long double t) { return std::vector<long double>{7e6L + wiggle * std::cos(t) + 1e-8L * noise(t, seed)}; };
  };
  const Yardstick yardstick(rows_of(motion(1e-3L, 1)), rows_of(motion(1e-3L, 2)), {column("r", "m")}, k_tight,
                            k_rounding);
  CHECK(yardstick.error_of(rows_of(motion(2e-3L, 1))).value == Approx(0.5).epsilon(0.01));
}

TEST_CASE("what only drifts is relative to its size") {
  const auto energy = [](long double drift, int seed) {
    return [=](long double t) { return std::vector<long double>{5 + drift * noise(t, seed)}; };
  };
  const Yardstick yardstick(rows_of(energy(1e-13L, 1)), rows_of(energy(1e-11L, 2)), {column("energy.total", "J")},
                            k_tight, k_rounding);
  CHECK(yardstick.constants() == std::vector<std::string>{"energy.total"});
  CHECK(yardstick.error_of(rows_of(energy(5e-9L, 3))).value == Approx(1e-9).epsilon(0.1));
}

TEST_CASE("rounding that two runs share is no range") {
  const auto energy = [](long double t) { return std::vector<long double>{5 + 1e-16L * noise(t, 1)}; };
  const std::vector<Column> columns{column("energy.total", "J")};
  CHECK(Yardstick(rows_of(energy), rows_of(energy), columns, k_tight, 1e-15).constants().size() == 1);
  CHECK(Yardstick(rows_of(energy), rows_of(energy), columns, k_tight, 1e-18).constants().empty());
}

TEST_CASE("what is 0 but for rounding is so even where tighter runs have nearly the same rounding") {
  const auto slip = [](long double size, int seed) {
    return [=](long double t) {
      return std::vector<long double>{size * (noise(t, 1) + 0.01L * noise(t, seed)), 1e-70L * noise(t, seed / 3)};
    };
  };
  const std::vector<Column> columns{column("y", "m"), column("spin", "kg*m^2/s")};
  for (const long double size : {1e-18L, 1e-45L}) {
    const Yardstick yardstick(rows_of(slip(size, 1)), rows_of(slip(size, 2)), columns, k_tight, k_rounding);
    CHECK(yardstick.scale(0) == 1);
    CHECK(yardstick.error_of(rows_of(slip(0.1L * size, 3))).value < 1e-15);
  }
}

TEST_CASE("a motion as small as that keeps its range, as that of the mirrors that gravitational waves move") {
  const auto motion = [](long double error, int seed) {
    return [=](long double t) { return std::vector<long double>{1e-18L * std::cos(t) + error * noise(t, seed)}; };
  };
  const Yardstick yardstick(rows_of(motion(1e-25L, 1)), rows_of(motion(1e-25L, 2)), {column("x", "m")}, k_tight,
                            k_rounding);
  CHECK(yardstick.error_of(rows_of(motion(1e-20L, 3))).value == Approx(5e-3).epsilon(0.1));
}

TEST_CASE("a coordinate at rest is relative to what has its unit, and where nothing moves errors are in the unit") {
  const auto motion = [](long double rest, int seed) {
    return [=](long double t) {
      return std::vector<long double>{3 * std::cos(t), rest + 1e-18L * noise(t, seed), 1e-17L * noise(t, seed)};
    };
  };
  const Yardstick yardstick(rows_of(motion(0, 1)), rows_of(motion(0, 2)),
                            {column("x", "m"), column("y", "m"), column("spin", "kg*m^2/s")}, k_tight, k_rounding);
  CHECK(yardstick.constants() == std::vector<std::string>{"y", "spin"});
  CHECK(yardstick.error_of(rows_of(motion(6e-6L, 1))).value == Approx(1e-6).epsilon(1e-3));
  CHECK(yardstick.scale(2) == 1);
}

TEST_CASE("what two runs do not tell is no constant unless it is small beside its size") {
  const auto motion = [](int seed) {
    return [=](long double t) { return std::vector<long double>{1 + 1e-3L * noise(t, seed)}; };
  };
  const Yardstick yardstick(rows_of(motion(1)), rows_of(motion(2)), {column("x", "m")}, k_tight, k_rounding);
  CHECK(yardstick.constants().empty());
  CHECK(yardstick.error_of(rows_of(motion(2))).value > 0.1);
}

TEST_CASE("a number that is none in one sample hides nothing of the others") {
  const long double none = std::numeric_limits<long double>::infinity();
  const auto motion = [&](long double off) {
    return [=](long double t) { return std::vector<long double>{t == 0 ? -none : std::sin(t) + off}; };
  };
  const Yardstick yardstick(rows_of(motion(0)), rows_of(motion(1e-12L)), {column("log", "")}, k_tight, k_rounding);
  CHECK(yardstick.error_of(rows_of(motion(0.2L))).value == Approx(0.1).epsilon(0.01));
  CHECK(std::isinf(
      yardstick.error_of(rows_of([](long double t) { return std::vector<long double>{std::sin(t)}; })).value));
}
