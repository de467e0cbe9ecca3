// Constraints of coordinates that are large beside lengths: as good as their digits, and not as half of them.

#include <cmath>
#include <functional>
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

using Uniform = std::function<double()>;  ///< from -1 to 1

/// The widest gap of 300 states that `start` makes, after projection.
template <class Prepared, class State>
Reach reach(const Prepared& prepared, State (*start)(const Uniform&, double far, double off),
            double (*gap)(const State&, double far), double far, double off) {
  std::mt19937 engine(20261125);
  std::uniform_real_distribution<double> up_to_one(-1, 1);
  const Uniform uniform = [&] { return up_to_one(engine); };
  Reach result;
  for (int k = 0; k < 300; ++k) {
    State to{};
    if (project(0.0, start(uniform, far, off), prepared, to) != Status::ok) continue;
    ++result.arrived;
    result.widest = std::fmax(result.widest, gap(to, far));
  }
  return result;
}

/// Held at (far, -2 far).
template <class Parameters>
auto held_at(double far) {
  Parameters parameters;
  parameters.x0 = far;
  parameters.y0 = -2 * far;
  return prepare(parameters);
}

/// The bob up to `off` m beside its circle.
bob::State<double> bob_beside(const Uniform& uniform, double far, double off) {
  bob::State<double> state{};
  const double angle = 4 * uniform();
  state.x() = far + std::cos(angle) + off * uniform();
  state.y() = -2 * far + std::sin(angle) + off * uniform();
  return state;
}

double gap_of_rod(const bob::State<double>& at, double far) {
  return std::abs(std::hypot(at.x() - far, at.y() + 2 * far) - 1);
}

/// The bar as far off its pin, and as many rad.
bar::State<double> bar_beside(const Uniform& uniform, double far, double off) {
  bar::State<double> state{};
  const double angle = 4 * uniform();
  state.x() = far + std::cos(angle) + off * uniform();
  state.y() = -2 * far + std::sin(angle) + off * uniform();
  state.phi() = angle + off * uniform();
  return state;
}

double gap_of_pin(const bar::State<double>& at, double far) {
  return std::hypot(at.x() - far - std::cos(at.phi()), at.y() + 2 * far - std::sin(at.phi()));
}

}  // namespace

TEST_CASE("far from the origin, project closes constraints to the digits of coordinates, or says that it does not") {
  for (const double far : {0.0, 1.0, 1e3, 1e6, 1e9, 1e12}) {
    for (const double off : {0.01, 0.3, 3.0}) {
      const double digits = 512 * k_epsilon * (1 + off + 3 * far);
      const Reach of_bob = reach(held_at<bob::Parameters<double>>(far), bob_beside, gap_of_rod, far, off);
      const Reach of_bar = reach(held_at<bar::Parameters<double>>(far), bar_beside, gap_of_pin, far, off);
      INFO(far << " m off, from " << off << ": " << of_bob.arrived << ", " << of_bob.widest << "; " << of_bar.arrived
               << ", " << of_bar.widest << " beside " << digits);
      CHECK(of_bob.widest <= digits);
      CHECK(of_bar.widest <= digits);
      if (off <= 0.3 && far <= 1e9) CHECK(of_bob.arrived == 300);
      if (off <= 0.3) CHECK(of_bar.arrived == 300);
    }
  }
}
