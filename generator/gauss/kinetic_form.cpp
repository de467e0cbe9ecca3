#include "gauss/kinetic_form.hpp"

#include "symbolic/rational.hpp"

namespace gaussgen::gauss {

using symbolic::dot;

namespace {

/// A velocity v = v_A ẏ^A + v_t, and what weighs it: v·M v is twice its kinetic energy.
struct WeightedVelocity {
  support::Indexed<FullIndex, Vector3> along;
  Vector3 of_time;
  Matrix3 weight;
};

Vector3 derivative(const Vector3& v, const GiNaC::realsymbol& by) {
  return symbolic::each(v, [&](const ex& f) { return f.diff(by); });
}

WeightedVelocity translation(const BodyMotion& body, const Chart& chart) {
  const ex& m = body.mass;
  WeightedVelocity v{
      {}, derivative(body.position, chart.time()), {Vector3{m, 0, 0}, Vector3{0, m, 0}, Vector3{0, 0, m}}};
  for (const FullIndex A : chart.all()) v.along.push_back(derivative(body.position, chart[A].y));
  return v;
}

WeightedVelocity rotation(const BodyMotion& body, const Chart& chart) {
  WeightedVelocity v{{}, symbolic::each(body.omega, [&](const ex& f) { return chart.at_rest(f); }), body.inertia};
  for (const FullIndex A : chart.all()) v.along.push_back(derivative(body.omega, chart[A].rate));
  return v;
}

/// a·M b; a multiple of the unit matrix stays outside, so that sin² + cos² meet in one sum.
ex weighted(const Vector3& a, const Matrix3& M, const Vector3& b) {
  const bool is_isotropic = M[0][0].is_equal(M[1][1]) && M[0][0].is_equal(M[2][2]) && M[0][1].is_zero() &&
                            M[0][2].is_zero() && M[1][2].is_zero();
  return is_isotropic ? M[0][0] * dot(a, b) : dot(a, symbolic::multiply(M, b));
}

void add(const WeightedVelocity& v, const Chart& chart, KineticForm& form) {
  for (const FullIndex A : chart.all()) {
    for (const FullIndex B : chart.all()) {
      if (B < A) continue;
      form.G[A][B] += weighted(v.along[A], v.weight, v.along[B]);
      form.G[B][A] = form.G[A][B];
    }
    form.B[A] += weighted(v.along[A], v.weight, v.of_time);
  }
  form.T_0 += symbolic::number(support::Rational(1) / 2) * weighted(v.of_time, v.weight, v.of_time);
}

}  // namespace

KineticForm kinetic_form(const std::vector<BodyMotion>& bodies, const Chart& chart) {
  const std::size_t count = chart.full_count();
  KineticForm form{symbolic::zero_table<FullIndex, FullIndex>(count, count), Row<FullIndex>(count, ex(0)), 0};
  for (const BodyMotion& body : bodies) {
    add(translation(body, chart), chart, form);
    if (body.is_rigid) add(rotation(body, chart), chart, form);
  }
  return form;
}

}  // namespace gaussgen::gauss
