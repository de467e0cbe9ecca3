#include "nonholonomic/constraint_rows.hpp"

#include "model/rate.hpp"

namespace gaussgen::nonholonomic {

namespace {

/// Θ_μ: the part of φ̇_μ without second derivatives.
ex drift(const ex& phi, const Chart& chart) {
  GiNaC::exvector terms{phi.diff(chart.time())};
  for (const FullIndex A : chart.all()) terms.push_back(phi.diff(chart[A].y) * chart[A].rate);
  return chart.at_attitude(GiNaC::add(terms));
}

/// Components of grad_v φ_μ along the dual basis э^i.
Row<HeldIndex> dual_components(const Row<FullIndex>& beta, const gauss::Metric& metric, const Chart& chart) {
  Row<HeldIndex> across;
  for (const HeldIndex j : chart.held()) {
    ex sum = beta[chart.full(j)];
    for (const FreeIndex a : chart.free()) {
      for (const FreeIndex b : chart.free()) sum -= beta[chart.full(a)] * metric.g_up[a][b] * metric.G_qx[b][j];
    }
    across.push_back(sum);
  }
  Row<HeldIndex> result(chart.held_count(), ex(0));
  for (const HeldIndex i : chart.held()) {
    for (const HeldIndex j : chart.held()) result[i] += across[j] * metric.E_xx_up[j][i];
  }
  return result;
}

/// φ_μ of a law of the model, with x free.
class Law {
 public:
  explicit Law(const Chart& chart) : chart_(chart) {}

  ex operator()(const model::VelocityLaw& law) const { return chart_(law.phi); }
  ex operator()(const model::PositionLaw& law) const { return chart_(model::rate_of(law)); }

  ex operator()(const model::SlipLaw& law) const {
    const auto* place = std::get_if<std::size_t>(&law.at);
    const Vector3 point = place != nullptr ? chart_.frames().point(*place, k_origin)
                                           : chart_(std::get<std::array<model::Ast, 3>>(law.at));
    const Vector3 own = chart_(law.direction);
    const Vector3 direction =
        law.axes == model::k_space ? own : symbolic::multiply(chart_.frames()(law.axes).axes, own);
    return symbolic::dot(
        direction, symbolic::operator-(material_velocity(law.frame, point), material_velocity(law.surface, point)));
  }

 private:
  using Vector3 = symbolic::Vector3;

  /// Of what is fixed in a frame, at a place in space: d/dt of origin + A s with s constant, at s = Aᵀ (place - origin).
  Vector3 material_velocity(std::size_t frame, const Vector3& place) const {
    if (frame == model::k_space) return {0, 0, 0};
    const symbolic::Placement& placement = chart_.frames()(frame);
    Vector3 velocity = chart_.rate_of(placement.origin);
    const Vector3 inside =
        symbolic::multiply(symbolic::transposed(placement.axes), symbolic::operator-(place, placement.origin));
    for (std::size_t i = 0; i < 3; ++i) {
      velocity[i] = velocity[i] + symbolic::dot(chart_.rate_of(placement.axes[i]), inside);
    }
    return velocity;
  }

  static inline const std::array<model::Ast, 3> k_origin{};

  const Chart& chart_;
};

}  // namespace

ConstraintRows constraint_rows(const model::Model& model, const gauss::System& system) {
  const Chart& chart = *system.chart;
  ConstraintRows rows;
  const Law law(chart);
  for (const model::Constraint& constraint : model.constraints) {
    const ex phi = std::visit(law, constraint.law);
    Row<FullIndex> beta;
    for (const FullIndex A : chart.all()) beta.push_back(chart.at_attitude(phi.diff(chart[A].rate)));
    rows.names.push_back(constraint.name.text);
    rows.phi.push_back(chart.at_attitude(phi));
    rows.beta_drift.push_back(drift(phi, chart));
    rows.b_x.push_back(dual_components(beta, system.metric, chart));
    rows.beta.push_back(std::move(beta));
  }
  return rows;
}

}  // namespace gaussgen::nonholonomic
