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

  const Row<FullIndex>& sum() const { return Q_; }

 private:
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
