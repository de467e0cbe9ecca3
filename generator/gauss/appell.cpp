#include "gauss/appell.hpp"

#include "symbolic/rational.hpp"

namespace gaussgen::gauss {

ex gibbs_appell(const std::vector<BodyMotion>& bodies, const Chart& chart) {
  const ex half = symbolic::number(support::Rational(1) / 2);
  const auto settled = [&](const Vector3& v) {
    return symbolic::each(v, [&](const ex& f) { return chart.at_attitude(f); });
  };
  ex S = 0;
  for (const BodyMotion& body : bodies) {
    const Vector3 acceleration = settled(chart.rate_of(chart.rate_of(body.position)));
    S += half * body.mass * symbolic::dot(acceleration, acceleration);
    if (!body.is_rigid) continue;
    // In body axes dω/dt has the derivatives of the components: ω × ω = 0.
    const Vector3 omega = settled(body.omega_body);
    const Vector3 omega_dot = settled(chart.rate_of(body.omega_body));
    S += half * symbolic::dot(omega_dot, symbolic::multiply(body.inertia, omega_dot));
    S += symbolic::dot(omega_dot, symbolic::cross(omega, symbolic::multiply(body.inertia, omega)));
  }
  return S;
}

}  // namespace gaussgen::gauss
