#include "kinematics/body_motions.hpp"

#include "ir/contract.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;
using model::Axes;
using support::Indexed;

namespace {

std::vector<ir::SymbolId> rates_of(const Symbols& symbols) {
  std::vector<ir::SymbolId> rates;
  for (std::size_t i = 0; i < symbols.full_count(); ++i) rates.push_back(symbols.rate(FullIndex{i}));
  return rates;
}

}  // namespace

Partials::Partials(ir::Graph& graph, const Symbols& symbols)
    : rates_in_(graph, rates_of(symbols)), zero_(graph, graph.constant(0)) {
  for (std::size_t i = 0; i < symbols.full_count(); ++i) {
    along_rate_.emplace_back(graph);
    along_rate_.back().seed(symbols.rate(FullIndex{i}), Expr(graph, graph.constant(1)));
    along_rate_.back().skip_others(rates_in_, i);
  }
}

Indexed<FullIndex, Vector3> Partials::operator()(const Vector3& v) {
  Indexed<FullIndex, Vector3> columns;
  for (const FullIndex i : support::indices<FullIndex>(along_rate_.size())) {
    columns.push_back({(*this)(v[0], i), (*this)(v[1], i), (*this)(v[2], i)});
  }
  return columns;
}

const BodyMotion& BodyMotions::operator[](BodyIndex body) {
  const auto known = known_.find(body.value);
  if (known != known_.end()) return known->second;
  return known_.emplace(body.value, motion(model_.bodies[body.value])).first->second;
}

Vector3 BodyMotions::position(BodyIndex body) {
  const model::Body& what = model_.bodies[body.value];
  return expressions_.frames().point(what.frame, expressions_(what.centre));
}

BodyMotion BodyMotions::motion(const model::Body& body) {
  const Vector3 position = expressions_.frames().point(body.frame, expressions_(body.centre));
  const Vector3 velocity = expressions_.rate(position);
  const Vector3 zero = ir::zero3(expressions_.graph());
  BodyMotion motion{body.name.text,
                    expressions_(body.mass),
                    position,
                    velocity,
                    partials_(velocity),
                    expressions_.rate(velocity),
                    zero,
                    zero,
                    false,
                    false,
                    {zero, zero, zero},
                    {{zero, zero, zero}, zero, Axes::space},
                    {},
                    zero};
  if (body.inertia) add_rotation(body, motion);
  return motion;
}

// An isotropic tensor has the same components in every frame, so ω may stay in the frame where it is simplest; any
// other tensor is constant in body axes only.
void BodyMotions::add_rotation(const model::Body& body, BodyMotion& motion) {
  motion.is_rigid = true;
  motion.is_isotropic = body.inertia->shape == model::Inertia::Shape::isotropic;
  motion.inertia = inertia_matrix(*body.inertia, expressions_);
  motion.rotation =
      expressions_.frames().rotation(body.frame, motion.is_isotropic ? preferred_axes(body.frame) : Axes::body);
  motion.W = partials_(motion.rotation.omega);
  motion.eta = expressions_.rate(motion.rotation.omega);
}

Axes BodyMotions::preferred_axes(std::size_t frame) const {
  const auto* quaternion = std::get_if<model::QuaternionOrientation>(&model_.frames[frame].attitude);
  if (quaternion == nullptr) return Axes::space;
  const Axes own = model_.orientations[quaternion->index].axes;
  return own == Axes::space && model_.frames[frame].parent != model::k_space ? Axes::body : own;
}

ir::Matrix3 inertia_matrix(const model::Inertia& inertia, Expressions& expressions) {
  const auto entry = [&](std::size_t i) { return expressions(inertia.entries[i]); };
  const Expr zero = expressions.number(0);
  switch (inertia.shape) {
    case model::Inertia::Shape::isotropic:
      return {Vector3{entry(0), zero, zero}, Vector3{zero, entry(0), zero}, Vector3{zero, zero, entry(0)}};
    case model::Inertia::Shape::diagonal:
      return {Vector3{entry(0), zero, zero}, Vector3{zero, entry(1), zero}, Vector3{zero, zero, entry(2)}};
    default:
      return {Vector3{entry(0), entry(3), entry(4)}, Vector3{entry(3), entry(1), entry(5)},
              Vector3{entry(4), entry(5), entry(2)}};
  }
}

Vector3 BodyMotion::inertia_times(const Vector3& a) const {
  return is_isotropic ? inertia[0][0] * a : ir::multiply(inertia, a);
}

}  // namespace gaussgen::kinematics
