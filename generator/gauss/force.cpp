#include "gauss/force.hpp"

#include "support/assert.hpp"

namespace gaussgen::gauss {

namespace {

class ForceCollector {
 public:
  ForceCollector(const model::Model& model, const std::vector<BodyMotion>& bodies, const Chart& chart)
      : model_(model), bodies_(bodies), chart_(chart), Q_(chart.full_count(), ex(0)) {}

  void operator()(const model::UniformField& field) {
    const Vector3 f = chart_(field.field);
    for (const BodyMotion& body : bodies_) {
      const ex virtual_work = body.mass * symbolic::dot(f, body.position);
      for (const FullIndex A : chart_.all()) Q_[A] += virtual_work.diff(chart_[A].y);
    }
  }

  void operator()(const model::Potential& potential) {
    const ex V = chart_(potential.energy);
    for (const FullIndex A : chart_.all()) Q_[A] -= V.diff(chart_[A].y);
  }

  void operator()(const model::GeneralizedForce& force) {
    for (const auto& [name, value] : force.components) {
      if (model_.resolve(name.text).kind == model::SymbolKind::speed) {
        act_along_speed(name, chart_(value));
      } else {
        Q_[chart_.find(name.text)] += chart_(value);
      }
    }
  }

  void operator()(const model::PointForce& law) {
    const Vector3 force = in_space(law.axes, law.components);
    const Vector3 r = chart_.frames().point(law.frame, law.at);
    const std::size_t pushed = model::pushed_by_force_on(model_, law.frame);
    if (pushed == law.frame) {
      work_along(r, law.frame, force, 1);
    } else {
      work_on_material(r, pushed, force, 1);
    }
    work_on_material(r, model::pushed_by_force_on(model_, law.from), force, -1);
  }

  void operator()(const model::Torque& law) {
    const Vector3 moment = in_space(law.axes, law.components);
    turn(law.frame, moment, 1);
    turn(law.from, moment, -1);
  }

  void operator()(const model::Spring& law) {
    const Vector3 first = origin(law.first);
    const Vector3 second = origin(law.second);
    const Vector3 gap = symbolic::operator-(second, first);
    const Vector3 opening = chart_.rate_of(gap);
    const ex k = chart_(law.stiffness);
    const ex c = law.damping ? chart_(*law.damping) : ex(0);
    const ex distance = GiNaC::pow(symbolic::dot(gap, gap), GiNaC::numeric(1, 2));
    const ex length = law.length ? chart_(*law.length) : ex(0);
    const ex stretch = distance - length;
    const ex V = k * GiNaC::pow(stretch, 2) / 2;
    for (const FullIndex A : chart_.all()) {
      Q_[A] -= V.diff(chart_[A].y);
      const Vector3 along = symbolic::each(gap, [&](const ex& f) { return f.diff(chart_[A].y); });
      const ex stretching = symbolic::dot(gap, opening) - distance * chart_.rate_of(length);
      Q_[A] -= c * (law.length ? ex(stretching * symbolic::dot(gap, along) / symbolic::dot(gap, gap))
                               : symbolic::dot(opening, along));
    }
  }

  void operator()(const model::CoordinateSpring& law) {
    const FullIndex A = chart_.find(law.coordinate.text);
    const ex stretch = law.rest ? ex(chart_[A].y - chart_(*law.rest)) : ex(chart_[A].y);
    Q_[A] -= chart_(law.stiffness) * stretch + (law.damping ? chart_(*law.damping) : ex(0)) * chart_.rate_of(stretch);
  }

  // paper_route_obstacle keeps such models away.
  void operator()(const model::Friction&) { GAUSS_ASSERT(false, "friction"); }

  const Row<FullIndex>& sum() const { return Q_; }

 private:
  Vector3 in_space(std::size_t axes, const std::array<model::Ast, 3>& components) const {
    const Vector3 own = chart_(components);
    return axes == model::k_space ? own : symbolic::multiply(chart_.frames()(axes).axes, own);
  }

  /// Q_A = Q ∂u/∂ẏ^A
  void act_along_speed(const model::Name& name, const ex& force) {
    model::Ast speed;
    speed.kind = model::AstKind::symbol;
    speed.name = name.text;
    const ex u = chart_(speed);
    for (const FullIndex A : chart_.all()) Q_[A] += force * u.diff(chart_[A].rate);
  }

  Vector3 origin(std::size_t frame) const {
    return frame == model::k_space ? Vector3{0, 0, 0} : chart_.frames()(frame).origin;
  }

  void work_along(const Vector3& r, std::size_t frame, const Vector3& force, int sense) {
    if (frame == model::k_space) return;
    for (const FullIndex A : chart_.all()) {
      for (std::size_t i = 0; i < 3; ++i) Q_[A] += sense * force[i] * r[i].diff(chart_[A].y);
    }
  }

  /// On what is at r of the frame now: it moves along by ∂v/∂ẏ = ∂r_0/∂y + ∂(A s)/∂y with a constant s.
  void work_on_material(const Vector3& r, std::size_t frame, const Vector3& force, int sense) {
    if (frame == model::k_space) return;
    const symbolic::Placement& placed = chart_.frames()(frame);
    const Vector3 inside = symbolic::multiply(symbolic::transposed(placed.axes), symbolic::operator-(r, placed.origin));
    for (const FullIndex A : chart_.all()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& row = placed.axes[i];
        ex shift = placed.origin[i].diff(chart_[A].y);
        for (std::size_t j = 0; j < 3; ++j) shift += row[j].diff(chart_[A].y) * inside[j];
        Q_[A] += sense * force[i] * shift;
      }
    }
  }

  void turn(std::size_t frame, const Vector3& moment, int sense) {
    if (frame == model::k_space) return;
    const symbolic::Placement& placement = chart_.frames()(frame);
    const Vector3 along = symbolic::multiply(symbolic::transposed(placement.axes), moment);
    for (const FullIndex A : chart_.all()) {
      for (std::size_t i = 0; i < 3; ++i) Q_[A] += sense * along[i] * placement.omega_body[i].diff(chart_[A].rate);
    }
  }

  const model::Model& model_;
  const std::vector<BodyMotion>& bodies_;
  const Chart& chart_;
  Row<FullIndex> Q_;
};

}  // namespace

Row<FullIndex> active_force(const model::Model& model, const std::vector<BodyMotion>& bodies, const Chart& chart,
                            symbolic::Bindings& bindings) {
  ForceCollector collector(model, bodies, chart);
  for (const model::Force& force : model.forces) std::visit(collector, force.law);
  Row<FullIndex> Q;
  for (const FullIndex A : chart.all()) {
    Q.push_back(bindings.define("Q_" + chart[A].label, chart.at_attitude(collector.sum()[A])));
  }
  return Q;
}

}  // namespace gaussgen::gauss
