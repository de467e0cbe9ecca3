#include "strategy/link_motion.hpp"

#include "ir/contract.hpp"
#include "ir/rotation.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::keeps_axes;
using kinematics::Link;

LinkMotion::LinkMotion(const std::vector<Link>& links, Vector3 fall, std::string prefix)
    : links_(links),
      fall_(std::move(fall)),
      prefix_(std::move(prefix)),
      drift_(links.size()),
      velocity_(links.size()),
      fall_at_(links.size()) {}

Vector3 LinkMotion::turned(std::size_t i, const Vector3& v) const {
  const Link& link = links_[i];
  if (link.kind == Link::Kind::free) return ir::multiply(transposed(link.matrix), v);
  if (link.kind != Link::Kind::turn) return v;
  const std::size_t p = (link.axis + 1) % 3, q = (link.axis + 2) % 3;
  Vector3 result = v;
  result[p] = cosine(i) * v[p] + sine(i) * v[q];
  result[q] = cosine(i) * v[q] - sine(i) * v[p];
  return result;
}

Vector3 LinkMotion::turned_back(std::size_t i, const Vector3& v) const {
  const Link& link = links_[i];
  if (link.kind == Link::Kind::free) return ir::multiply(link.matrix, v);
  return link.kind == Link::Kind::turn ? ir::turned(v, link.axis, *link.angle) : v;
}

// From the ground on, so that long chains need no stack.
std::vector<std::size_t> LinkMotion::missing(const Found& found, std::size_t link) const {
  std::vector<std::size_t> path;
  for (std::size_t at = link; at != k_ground && !found[at]; at = links_[at].parent) path.insert(path.begin(), at);
  return path;
}

const Vector3& LinkMotion::velocity(std::size_t link, Steps& steps) {
  for (const std::size_t i : missing(velocity_, link)) {
    const std::size_t parent = links_[i].parent;
    Vector3 v = parent == k_ground ? ir::zero3(fall_[0].graph()) : turned(i, *velocity_[parent]);
    if (links_[i].kind == Link::Kind::shift) v = v + cross(omega_before(i), links_[i].offset) + links_[i].velocity;
    velocity_[i] = steps.name(v, prefix_ + "v_" + links_[i].name);
  }
  return *velocity_[link];
}

const Vector3& LinkMotion::fall_at(std::size_t link) {
  if (link == k_ground) return fall_;
  for (const std::size_t i : missing(fall_at_, link)) {
    fall_at_[i] = turned(i, links_[i].parent == k_ground ? fall_ : *fall_at_[links_[i].parent]);
  }
  return *fall_at_[link];
}

Vector3 LinkMotion::omega_of_axes(std::size_t i) const {
  const Link& link = links_[i];
  Vector3 omega = omega_[i];
  if (keeps_axes(link)) omega = omega_before(i);
  if (link.kind == Link::Kind::turn) omega[link.axis] += *link.rate - link.velocity[link.axis];
  return omega;
}

Vector3 LinkMotion::omega_before(std::size_t i) const {
  return links_[i].parent == k_ground ? ir::zero3(fall_[0].graph()) : omega_[links_[i].parent];
}

void LinkMotion::find_velocities(Steps& steps) {
  steps.begin("angular velocities, each in the axes of its link");
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Vector3 before = omega_before(i);
    if (link.kind == Link::Kind::shift) {
      omega_.push_back(before);
      continue;
    }
    const Vector3 omega = turned(i, before) + link.velocity;
    // Of a spin it is a sum that may cancel against parts of it; nothing else needs it.
    const bool is_sum = keeps_axes(link);
    omega_.push_back(is_sum ? omega : steps.name(omega, prefix_ + "omega_" + link.name));
  }
}

// d/dt (Rᵀ ω + ω_rel) in turned axes: Rᵀ dω/dt + dω_rel/dt + (Rᵀ ω) × ω_rel. Axes of a ball do not turn: the same, with R = 1.
Vector3 LinkMotion::of_turn(std::size_t i) const {
  const Link& link = links_[i];
  Vector3 before = link.kind == Link::Kind::ball ? omega_before(i) : omega_[i] - link.velocity;
  if (link.kind == Link::Kind::turn || link.kind == Link::Kind::spin) {
    before = omega_[i];  // what is along the axis does not matter
    before[link.axis] = Expr(fall_[0].graph(), fall_[0].graph().constant(0));
  }
  return cross(before, link.velocity) + link.drift;
}

Vector3 LinkMotion::of_shift(std::size_t i) const {
  const Link& link = links_[i];
  const Vector3 omega = omega_before(i);
  return cross(omega, cross(omega, link.offset)) + scaled(2, cross(omega, link.velocity)) + link.drift;
}

const Vector3& LinkMotion::drift(std::size_t i, Steps& steps) {
  if (!drift_[i]) {
    const bool is_shift = links_[i].kind == Link::Kind::shift;
    const char* const name = is_shift ? "drift_a_" : "drift_alpha_";
    drift_[i] = steps.name(is_shift ? of_shift(i) : of_turn(i), prefix_ + name + links_[i].name);
  }
  return *drift_[i];
}

void LinkMotion::accumulate(const std::function<bool(std::size_t, std::size_t)>& is_free, Steps& steps) {
  steps.begin("accelerations against free fall if no speed changed, each in the axes of its link");
  const Vector3 none = ir::zero3(fall_[0].graph());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const LinkAcceleration before = link.parent == k_ground ? LinkAcceleration{fall_, none} : accumulated_[link.parent];
    LinkAcceleration now{turned(i, before.linear), turned(i, before.angular)};
    if (link.kind == Link::Kind::shift) {
      now.linear = now.linear + cross(before.angular, link.offset) + of_shift(i);
    } else {
      now.angular = now.angular + of_turn(i);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_free(i, k)) now.linear[k] = none[0];
    }
    now.linear = steps.name(now.linear, prefix_ + "drift_a_" + link.name);
    now.angular = steps.name(now.angular, prefix_ + "drift_alpha_" + link.name);
    accumulated_.push_back(now);
  }
}

Vector3 scaled(const ir::Rational& factor, const Vector3& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }

kinematics::Linkage in_units(const kinematics::Linkage& linkage, const ir::Rational& length, const ir::Rational& mass) {
  kinematics::Linkage result = linkage;
  const ir::Rational per_length = 1 / length, per_mass = 1 / mass;
  for (Link& link : result.links) {
    if (link.kind != Link::Kind::shift) continue;
    link.offset = scaled(per_length, link.offset);
    link.velocity = scaled(per_length, link.velocity);
    link.drift = scaled(per_length, link.drift);
    for (kinematics::Freedom& freedom : link.freedoms) freedom.column = scaled(per_length, freedom.column);
  }
  for (kinematics::Part& part : result.parts) {
    part.mass = per_mass * part.mass;
    part.centre = scaled(per_length, part.centre);
    for (Vector3& row : part.inertia) row = scaled(per_mass * per_length * per_length, row);
  }
  for (std::optional<kinematics::Place>& place : result.places) {
    if (place) place->position = scaled(per_length, place->position);
  }
  return result;
}

}  // namespace gaussgen::strategy
