#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "symbolic/rational.hpp"

using namespace gaussgen;
using namespace gaussgen::symbolic;

namespace {

constexpr model::Axes k_frames[] = {model::Axes::space, model::Axes::body};

/// Derivative of every component.
Quaternion derivative(const Quaternion& e, const GiNaC::realsymbol& by) {
  return {e[0].diff(by), e[1].diff(by), e[2].diff(by), e[3].diff(by)};
}

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

}  // namespace

TEST_CASE("coordinates stand in the order free, angular velocities, held", "[symbolic]") {
  const model::Model model = oracle::model_of_file("sphere_in_cylinder_quaternion");
  const Chart chart(model);
  std::vector<std::string> labels;
  for (const symbolic::FullIndex A : chart.all()) labels.push_back(chart[A].label);
  CHECK(labels == std::vector<std::string>{"chi", "zeta", "wx", "wy", "wz", "rho"});
  CHECK(chart.free_count() == 5);
  CHECK(chart[symbolic::HeldIndex{0}].held_at.has_value());
}

TEST_CASE("the rotation chart turns with the angular velocity up to first order, in space and in the body",
          "[symbolic]") {
  // 2 ė ē = ω in space, 2 ē ė = ω in the body, along θ(τ) = θ̇ τ, by series in τ.
  const GiNaC::realsymbol tau("tau");
  const Quaternion e{GiNaC::numeric(1, 5), GiNaC::numeric(2, 5), GiNaC::numeric(2, 5), GiNaC::numeric(4, 5)};
  const Vector3 theta_dot{2, -3, 5};
  const Vector3 bent{GiNaC::numeric(1, 2) * tau * tau, 4 * tau * tau, -tau * tau};
  for (const model::Axes frame : k_frames) {
    const Vector3 theta = ex(tau) * theta_dot + bent;
    const Vector3 rate{theta[0].diff(tau), theta[1].diff(tau), theta[2].diff(tau)};
    const Quaternion now = symbolic::turned(e, theta, frame);
    const Quaternion rates = derivative(now, tau);
    const Quaternion conjugate{now[0], -now[1], -now[2], -now[3]};
    const Quaternion twice = frame == model::Axes::space ? product(rates, conjugate) : product(conjugate, rates);
    const Vector3 omega = symbolic::angular_velocity(theta, rate, frame);
    for (std::size_t i = 0; i < 3; ++i) {
      const ex error = 2 * twice[i + 1] - omega[i];
      CHECK(error.subs(tau == 0).is_zero());
      CHECK(error.diff(tau).subs(tau == 0).is_zero());
      CHECK(omega[i].diff(tau).subs(tau == 0).is_equal(rate[i].diff(tau)));
    }
  }
}
