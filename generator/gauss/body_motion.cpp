#include "gauss/body_motion.hpp"

namespace gaussgen::gauss {

namespace {

using Shape = model::Inertia::Shape;

Matrix3 inertia_matrix(const model::Inertia& inertia, const Chart& chart) {
  const auto entry = [&](std::size_t i) { return chart(inertia.entries[i]); };
  if (inertia.shape == Shape::isotropic) {
    const ex J = entry(0);
    return {Vector3{J, 0, 0}, Vector3{0, J, 0}, Vector3{0, 0, J}};
  }
  if (inertia.shape == Shape::diagonal)
    return {Vector3{entry(0), 0, 0}, Vector3{0, entry(1), 0}, Vector3{0, 0, entry(2)}};
  const ex xy = entry(3);
  const ex xz = entry(4);
  const ex yz = entry(5);
  return {Vector3{entry(0), xy, xz}, Vector3{xy, entry(1), yz}, Vector3{xz, yz, entry(2)}};
}

}  // namespace

std::vector<BodyMotion> body_motions(const model::Model& model, const Chart& chart) {
  std::vector<BodyMotion> motions;
  for (const model::Body& body : model.bodies) {
    BodyMotion motion;
    motion.mass = chart(body.mass);
    motion.position = chart.frames().point(body.frame, body.centre);
    if (body.inertia) {
      motion.is_rigid = true;
      motion.inertia = inertia_matrix(*body.inertia, chart);
      motion.omega_body = chart.frames()(body.frame).omega_body;
      const bool is_isotropic = body.inertia->shape == Shape::isotropic;
      motion.omega = is_isotropic ? chart.frames().shortest_angular_velocity(body.frame) : motion.omega_body;
    }
    motions.push_back(motion);
  }
  return motions;
}

}  // namespace gaussgen::gauss
