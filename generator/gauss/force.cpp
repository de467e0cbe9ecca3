#include "gauss/force.hpp"

namespace gaussgen::gauss {

namespace {

class ForceCollector {
 public:
  ForceCollector(const std::vector<BodyMotion>& bodies, const Chart& chart)
      : bodies_(bodies), chart_(chart), Q_(chart.full_count(), ex(0)) {}

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
    for (const auto& [name, value] : force.components) Q_[chart_.find(name.text)] += chart_(value);
  }

  void operator()(const model::PointForce& law) {
    const Vector3 force = in_space(law.axes, law.components);
    const Vector3 r = chart_.frames().point(law.frame, law.at);
    work_along(r, law.frame, force, 1);
    if (law.from == model::k_space) return;
    // The opposite acts on the point of the other frame that is there now: it moves along by ∂v/∂ẏ = ∂r_0/∂y + ∂(A s)/∂y.
    const symbolic::Placement& other = chart_.frames()(law.from);
    const Vector3 inside = symbolic::multiply(symbolic::transposed(other.axes), symbolic::operator-(r, other.origin));
    for (const FullIndex A : chart_.all()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& row = other.axes[i];
        ex shift = other.origin[i].diff(chart_[A].y);
        for (std::size_t j = 0; j < 3; ++j) shift += row[j].diff(chart_[A].y) * inside[j];
        Q_[A] -= force[i] * shift;
      }
    }
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
    const ex stretch = law.length ? ex(distance - chart_(*law.length)) : distance;
    const ex V = k * GiNaC::pow(stretch, 2) / 2;
    for (const FullIndex A : chart_.all()) {
      Q_[A] -= V.diff(chart_[A].y);
      const Vector3 along = symbolic::each(gap, [&](const ex& f) { return f.diff(chart_[A].y); });
      Q_[A] -= c * (law.length ? ex(symbolic::dot(gap, opening) * symbolic::dot(gap, along) / symbolic::dot(gap, gap))
                               : symbolic::dot(opening, along));
    }
  }

  void operator()(const model::CoordinateSpring& law) {
    const FullIndex A = chart_.find(law.coordinate.text);
    const ex stretch = law.rest ? ex(chart_[A].y - chart_(*law.rest)) : ex(chart_[A].y);
    Q_[A] -= chart_(law.stiffness) * stretch + (law.damping ? chart_(*law.damping) : ex(0)) * chart_[A].rate;
  }

  const Row<FullIndex>& sum() const { return Q_; }

 private:
  Vector3 in_space(std::size_t axes, const std::array<model::Ast, 3>& components) const {
    const Vector3 own = chart_(components);
    return axes == model::k_space ? own : symbolic::multiply(chart_.frames()(axes).axes, own);
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

  void turn(std::size_t frame, const Vector3& moment, int sense) {
    if (frame == model::k_space) return;
    const symbolic::Placement& placement = chart_.frames()(frame);
    const Vector3 along = symbolic::multiply(symbolic::transposed(placement.axes), moment);
    for (const FullIndex A : chart_.all()) {
      for (std::size_t i = 0; i < 3; ++i) Q_[A] += sense * along[i] * placement.omega_body[i].diff(chart_[A].rate);
    }
  }

  const std::vector<BodyMotion>& bodies_;
  const Chart& chart_;
  Row<FullIndex> Q_;
};

}  // namespace

Row<FullIndex> active_force(const model::Model& model, const std::vector<BodyMotion>& bodies, const Chart& chart,
                            symbolic::Bindings& bindings) {
  ForceCollector collector(bodies, chart);
  for (const model::Force& force : model.forces) std::visit(collector, force.law);
  Row<FullIndex> Q;
  for (const FullIndex A : chart.all()) {
    Q.push_back(bindings.define("Q_" + chart[A].label, chart.at_attitude(collector.sum()[A])));
  }
  return Q;
}

}  // namespace gaussgen::gauss
