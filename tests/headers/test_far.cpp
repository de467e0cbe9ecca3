// Constraints of coordinates that are large beside lengths: as good as their digits, and not as half of them.

#include <cmath>
#include <random>

#include "catch_shim.hpp"
#include "far_bar.hpp"
#include "far_bob.hpp"

namespace {

namespace bar = gauss::far_bar;
namespace bob = gauss::far_bob;
using gauss::Status;

constexpr double k_epsilon = 0x1p-53;

struct Reach {
  int arrived = 0;
  double widest = 0;  ///< m, where the status is ok
};

/// How far the rod of 300 states is from its length, after projection from up to `off` m beside it.
Reach reach_of_bob(double far, double off) {
  bob::Parameters<double> parameters;
  parameters.x0 = far;
  parameters.y0 = -2 * far;
  const auto prepared = prepare(parameters);
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  Reach result;
  for (int k = 0; k < 300; ++k) {
    const double angle = 4 * up_to_one(engine);
    bob::State<double> from{}, to;
    from.x() = parameters.x0 + std::cos(angle) + off * up_to_one(engine);
    from.y() = parameters.y0 + std::sin(angle) + off * up_to_one(engine);
    if (project(0.0, from, prepared, to) != Status::ok) continue;
    ++result.arrived;
    const double length = std::hypot(to.x() - parameters.x0, to.y() - parameters.y0);
    result.widest = std::fmax(result.widest, std::abs(length - parameters.L));
  }
  return result;
}

/// How far the end of the bar is from its pin, likewise; with its angle off by up to as many rad.
Reach reach_of_bar(double far, double off) {
  bar::Parameters<double> parameters;
  parameters.x0 = far;
  parameters.y0 = -2 * far;
  const auto prepared = prepare(parameters);
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  Reach result;
  for (int k = 0; k < 300; ++k) {
    bar::State<double> from{}, to;
    from.phi() = 4 * up_to_one(engine);
    from.x() = parameters.x0 + std::cos(from.phi()) + off * up_to_one(engine);
    from.y() = parameters.y0 + std::sin(from.phi()) + off * up_to_one(engine);
    from.phi() += off * up_to_one(engine);
    if (project(0.0, from, prepared, to) != Status::ok) continue;
    ++result.arrived;
    const double x = to.x() - parameters.x0 - std::cos(to.phi()), y = to.y() - parameters.y0 - std::sin(to.phi());
    result.widest = std::fmax(result.widest, std::hypot(x, y));
  }
  return result;
}

}  // namespace

TEST_CASE("far from the origin, project closes constraints to the digits of coordinates, or says that it does not") {
  for (const double far : {0.0, 1.0, 1e3, 1e6, 1e9, 1e12}) {
    for (const double off : {0.01, 0.3, 3.0}) {
      const double digits = 512 * k_epsilon * (1 + off + 3 * far);
      const Reach of_bob = reach_of_bob(far, off), of_bar = reach_of_bar(far, off);
      INFO(far << " m off, from " << off << ": " << of_bob.arrived << ", " << of_bob.widest << "; " << of_bar.arrived
               << ", " << of_bar.widest << " beside " << digits);
      CHECK(of_bob.widest <= digits);
      CHECK(of_bar.widest <= digits);
      if (off <= 0.3 && far <= 1e9) CHECK(of_bob.arrived == 300);
      if (off <= 0.3) CHECK(of_bar.arrived == 300);
    }
  }
}
