#include "sim/study/rods.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <vector>

#include "sim/study/places.hpp"

namespace gausssim {

namespace {

using Forces = std::vector<const Motion::Force*>;

/// The forces of a constraint on what feels it.
Forces sides_of(const std::string& constraint, double rounding, const Motion& motion) {
  Forces all, felt;
  double most = 0;
  for (const Motion::Force& one : motion.forces) {
    if (one.name != constraint) continue;
    all.push_back(&one);
    most = std::max(most, largest_of(one.force));
  }
  for (const Motion::Force* one : all)
    if (largest_of(one->force) > rounding * most) felt.push_back(one);
  return felt;
}

const Motion::Body* particle(const std::string& name, const Motion& motion) {
  for (const Motion::Body& body : motion.bodies)
    if (body.name == name && body.orientation.empty()) return &body;
  return nullptr;
}

/// From the first particle to the second one, or from the origin to the only one; nothing where there are others.
std::optional<Motion::Line> line_between(const Forces& sides, const Motion& motion) {
  if (sides.empty() || sides.size() > 2) return std::nullopt;
  const std::vector<Place> origin(sides.size() == 1 ? 1 : 0);
  Motion::Line line{sides.front()->name, {sides.front()->at.size(), origin}};
  for (const Motion::Force* side : sides) {
    const Motion::Body* const body = particle(side->body, motion);
    if (body == nullptr) return std::nullopt;
    for (std::size_t k = 0; k < line.points.size(); ++k) line.points[k].push_back(body->position[k]);
  }
  return line;
}

Eigen::Vector3d along(const std::vector<Place>& points) { return vector_of(points.back()) - vector_of(points.front()); }

bool is_along(const std::vector<Place>& force, const Motion::Line& line, double rounding) {
  const double most = largest_of(force);
  for (std::size_t k = 0; k < force.size(); ++k) {
    const Eigen::Vector3d pull = vector_of(force[k]), way = along(line.points[k]);
    if (!(pull.norm() <= rounding * most || way.cross(pull).norm() <= rounding * way.norm() * pull.norm()))
      return false;
  }
  return true;
}

bool are_opposite(const std::vector<Place>& one, const std::vector<Place>& other, double rounding) {
  const double most = std::max(largest_of(one), largest_of(other));
  for (std::size_t k = 0; k < one.size(); ++k)
    if (!((vector_of(one[k]) + vector_of(other[k])).norm() <= rounding * most)) return false;
  return true;
}

/// What a floor or a drive holds may lie in line with the origin, too.
bool turns(const Motion::Line& line) {
  constexpr double k_seen = 1e-3;  ///< rad
  const Eigen::Vector3d first = along(line.points.front());
  return std::any_of(line.points.begin(), line.points.end(), [&](const std::vector<Place>& points) {
    const Eigen::Vector3d way = along(points);
    return first.cross(way).norm() > k_seen * first.norm() * way.norm();
  });
}

}  // namespace

void add_rods(const std::set<std::string>& constraints, double rounding, Motion& motion) {
  for (const std::string& constraint : constraints) {
    const Forces sides = sides_of(constraint, rounding, motion);
    auto line = line_between(sides, motion);
    if (!line || !is_along(sides.back()->force, *line, rounding)) continue;
    const bool is_rod = sides.size() == 1 ? turns(*line) : are_opposite(sides[0]->force, sides[1]->force, rounding);
    if (is_rod) motion.lines.push_back(std::move(*line));
  }
}

}  // namespace gausssim
