#include "strategy/mass_properties.hpp"

#include <algorithm>

#include "ir/traverse.hpp"
#include "strategy/axes.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Matrix3;
using ir::Rational;
using ir::Vector3;
using kinematics::is_fixed;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::Part;

namespace {

Expr squared(const Vector3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// m (c² 1 - c cᵀ), of a mass at c.
Matrix3 of_mass(Expr mass, const Vector3& c) {
  const Vector3 none = ir::zero3(mass.graph());
  Matrix3 result{none, none, none};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Expr product = mass * c[i] * c[j];
      result[i][j] = i == j ? mass * squared(c) - product : -product;
    }
  }
  return result;
}

Matrix3 sum(const Matrix3& a, const Matrix3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Matrix3 difference(const Matrix3& a, const Matrix3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Expr trace(const Matrix3& m) { return m[0][0] + m[1][1] + m[2][2]; }

const Rational* number(Expr e) {
  const ir::Node& node = e.graph()[e.id()];
  return node.kind == ir::Kind::constant ? &node.value : nullptr;
}

// Whether the mass `moved` takes to r no more than a few times the inertia of the bar about its origin with it, so that what stays has the
// digits of that: of parameters, which may be anything, only where it is a known part of the mass. With the mass centre at r moved/mass
// that inertia is at least r² moved²/mass, and its trace twice that.
bool keeps_digits(const MassProperties& bar, Expr moved, const Vector3& r) {
  const Rational* inertia = number(trace(bar.inertia));
  const Rational* needed = number(moved * squared(r));
  if (inertia != nullptr && needed != nullptr) return *inertia > 0 && cln::abs(*needed) <= 4 * *inertia;
  const Rational* part = bar.mass.is_zero() ? nullptr : number(moved / bar.mass);
  return part != nullptr && *part >= Rational(1) / 8 && *part <= 1;
}

bool is_end(const Link& link) {
  return link.kind == Link::Kind::shift && link.freedoms.empty() && link.parent != k_ground && is_fixed(link.offset);
}

bool is_point(const MassProperties& own) {
  return is_zero(own.first) &&
         std::all_of(own.inertia.begin(), own.inertia.end(), [](const Vector3& row) { return is_zero(row); });
}

// A particle at the end of a bar, where the next bar begins, goes with that.
void gather_at_ends(const std::vector<Link>& links, std::vector<MassProperties>& properties, Vector& all_moved) {
  const std::vector<std::vector<std::size_t>> children = children_of(links);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!is_end(links[i]) || !children[i].empty() || !is_point(properties[i]) || properties[i].mass.is_zero()) continue;
    for (const std::size_t next : children[links[i].parent]) {
      if (!is_end(links[next]) || children[next].empty() || links[next].offset != links[i].offset) continue;
      const Expr mass = properties[i].mass;
      properties[i].mass -= mass;
      properties[next].mass += mass;
      all_moved[i] -= mass;
      all_moved[next] += mass;
      break;
    }
  }
}

}  // namespace

bool has_nothing(const MassProperties& own) { return own.mass.is_zero() && is_point(own); }

std::vector<MassProperties> mass_properties(const kinematics::Linkage& linkage, ir::Graph& graph) {
  const Vector3 none = ir::zero3(graph);
  std::vector<MassProperties> result(linkage.links.size(), {none[0], none, {none, none, none}});
  for (const Part& part : linkage.parts) {
    MassProperties& own = result[part.link];
    own.mass += part.mass;
    own.first = own.first + part.mass * part.centre;
    own.inertia = sum(own.inertia, sum(part.inertia, of_mass(part.mass, part.centre)));
  }
  return result;
}

Vector move_masses_to_ends(const std::vector<Link>& links, std::vector<MassProperties>& properties) {
  Vector all_moved;
  for (const MassProperties& own : properties) all_moved.push_back(Rational(0) * own.mass);
  gather_at_ends(links, properties, all_moved);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    if (!is_end(link)) continue;
    MassProperties& bar = properties[link.parent];
    if (is_zero(bar.first)) continue;
    const Vector3& r = link.offset;
    const Expr moved = (bar.first[0] * r[0] + bar.first[1] * r[1] + bar.first[2] * r[2]) / squared(r);
    if (!is_zero(bar.first - moved * r) || !keeps_digits(bar, moved, r)) continue;
    all_moved[i] = moved;
    properties[i].mass += moved;
    bar.mass -= moved;
    bar.first = ir::zero3(moved.graph());
    bar.inertia = difference(bar.inertia, of_mass(moved, r));
  }
  return all_moved;
}

}  // namespace gaussgen::strategy
