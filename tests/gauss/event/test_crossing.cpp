// Where a function falls through 0 between two times at which it and its rate are known.

#include <cmath>
#include <limits>

#include "catch_shim.hpp"
#include "gauss/event/crossing.hpp"

using gauss::event::Ends;
using gauss::event::falls_through;
using gauss::event::least_inside;

namespace {

/// c0 + c1 s + c2 s² + c3 s³
struct Cubic {
  double c0, c1, c2, c3;
  double operator()(double s) const { return c0 + s * (c1 + s * (c2 + s * c3)); }
  double rate(double s) const { return c1 + s * (2 * c2 + 3 * s * c3); }
  Ends<double> ends() const { return {(*this)(0), rate(0), (*this)(1), rate(1)}; }
};

template <class Value>
double root(double low, double high, const Value& value) {
  return falls_through(low, value(low), high, value(high), 0.0, value);
}

}  // namespace

TEST_CASE("a cubic through both ends is that of its coefficients", "[event]") {
  for (const Cubic& cubic : {Cubic{1, -2, 3, -4}, Cubic{0, 0, 0, 1}, Cubic{-5, 7, 0, 0}, Cubic{2, 0, -9, 8}}) {
    const Ends<double> ends = cubic.ends();
    for (double s = 0; s <= 1; s += 0.125) CHECK(std::abs(ends(s) - cubic(s)) < 1e-14);
  }
}

TEST_CASE("the least inside of a step is where the rate is 0 and rises", "[event]") {
  // (s - 0.3) (s - 0.8) and multiples: p' = 0 where p'' > 0
  const Cubic bowl{0.24, -1.1, 1, 0};
  REQUIRE(least_inside(bowl.ends()));
  CHECK(std::abs(*least_inside(bowl.ends()) - 0.55) < 1e-14);
  // p' = 3 (s - 0.25) (s - 0.75): a maximum at 0.25, a minimum at 0.75
  const Cubic wave{0, 0.5625, -1.5, 1};
  REQUIRE(least_inside(wave.ends()));
  CHECK(std::abs(*least_inside(wave.ends()) - 0.75) < 1e-14);
  const Cubic turned{0, -0.5625, 1.5, -1};
  REQUIRE(least_inside(turned.ends()));
  CHECK(std::abs(*least_inside(turned.ends()) - 0.25) < 1e-14);
}

TEST_CASE("there is no least inside where the function rises, falls, or has its least elsewhere", "[event]") {
  for (const Cubic& cubic : {Cubic{1, 1, 0, 0}, Cubic{1, -1, 0, 0}, Cubic{1, 0, 0, 0}, Cubic{0, 1, 0, 1},
                             Cubic{0, 1, -1, 0}, Cubic{1, 2, 1, 0}, Cubic{5, -4, 1, 0}, Cubic{0, 0, 1, 0}})
    CHECK_FALSE(least_inside(cubic.ends()));
}

TEST_CASE("what is said to be above 0 is there", "[event]") {
  int above = 0;
  for (double a = -1; a <= 1; a += 0.25)
    for (double b = -4; b <= 4; b += 0.5)
      for (double c = -1; c <= 1; c += 0.25)
        for (double d = -4; d <= 4; d += 0.5) {
          const Ends<double> ends{a, b, c, d};
          if (!(ends.least_control() > 0)) continue;
          ++above;
          for (double s = 0; s <= 1; s += 0.0625) CHECK(ends(s) > 0);
        }
  CHECK(above > 500);
  // And what stays far above is said to be so: it needs no look.
  CHECK(Ends<double>{1, 0.5, 1, -0.5}.least_control() > 0);
  CHECK(Ends<double>{1, -0.5, 0.5, -0.5}.least_control() > 0);
}

TEST_CASE("roots are found to all digits of the time, at or behind the root", "[event]") {
  const double found = root(0, 3, [](double t) { return 1 - t * t / 2; });
  CHECK(std::abs(found - std::sqrt(2.0)) <= 4 * std::numeric_limits<double>::epsilon());
  const double of_cosine = root(0, 3, [](double t) { return std::cos(t); });
  CHECK(std::abs(of_cosine - std::acos(0.0)) <= 4 * std::numeric_limits<double>::epsilon());
  CHECK(1 - found * found / 2 <= 0);
  CHECK(std::cos(of_cosine) <= 0);
  // Far from time 0, where digits are few
  const auto late = [](double t) { return 1e6 + 0.3 - t; };
  CHECK(std::abs(root(1e6, 1e6 + 1, late) - (1e6 + 0.3)) < 2e-10);
}

TEST_CASE("a steep fall, and a usual one, do not need many looks", "[event]") {
  constexpr double nearness = 1e-15;
  int looks = 0;
  const auto cliff = [&](double t) { return ++looks, t < 0.123 ? 1e-9 : -1e9; };
  CHECK(std::abs(falls_through(0.0, 1e-9, 1.0, -1e9, nearness, cliff) - 0.123) < 1e-6);
  CHECK(looks <= 102);
  looks = 0;
  const auto usual = [&](double t) { return ++looks, std::exp(-3 * t) - 0.4; };
  CHECK(std::abs(falls_through(0.0, 0.6, 1.0, std::exp(-3.0) - 0.4, nearness, usual) + std::log(0.4) / 3) < 1e-15);
  CHECK(looks < 15);
}

// The end at which it is not positive never moves: its value is halved as fast as that at the other one falls.
TEST_CASE("a root of three folds is found", "[event]") {
  const auto value = [](double t) { return std::pow(1 - t, 3); };
  CHECK(std::abs(falls_through(0.0, 1.0, 3.0, -8.0, 1e-13, value) - 1) < 1e-4);
}

TEST_CASE("no nearer than is asked for", "[event]") {
  int looks = 0;
  const auto value = [&](double t) { return ++looks, std::cos(t); };
  const double found = falls_through(0.0, 1.0, 3.0, std::cos(3.0), 0.5, value);
  CHECK(std::abs(found - std::acos(0.0)) < 0.5);
  CHECK(std::cos(found) <= 0);
  CHECK(looks <= 4);
}

TEST_CASE("a value that is no number ends the search at a time where it is not positive", "[event]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double found = falls_through(0.0, 1.0, 2.0, -1.0, 0.0, [&](double) { return nan; });
  CHECK(found == 2.0);
}
