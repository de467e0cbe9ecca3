#include "strategy/mass_properties.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

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

// The mass that would go to the end, against the inertia that stays: with numbers only, since parameters may be anything.
bool keeps_digits(Expr moved, Expr inertia) {
  const ir::Graph& graph = moved.graph();
  const ir::Node& a = graph[moved.id()];
  const ir::Node& b = graph[inertia.id()];
  if (a.kind != ir::Kind::constant || b.kind != ir::Kind::constant) return false;
  return b.value > 0 && cln::abs(a.value) <= 4 * b.value;
}

}  // namespace

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
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    const bool is_end = link.kind == Link::Kind::shift && link.freedoms.empty() && link.parent != k_ground;
    if (!is_end || !is_fixed(link.offset)) continue;
    MassProperties& bar = properties[link.parent];
    if (is_zero(bar.first)) continue;
    const Vector3& r = link.offset;
    const Expr moved = (bar.first[0] * r[0] + bar.first[1] * r[1] + bar.first[2] * r[2]) / squared(r);
    if (!is_zero(bar.first - moved * r) || !keeps_digits(moved * squared(r), trace(bar.inertia))) continue;
    all_moved[i] = moved;
    properties[i].mass += moved;
    bar.mass -= moved;
    bar.first = ir::zero3(moved.graph());
    bar.inertia = difference(bar.inertia, of_mass(moved, r));
  }
  return all_moved;
}

std::vector<MassBound> mass_bounds(const std::vector<Link>& links, const std::vector<MassProperties>& properties) {
  std::vector<MassBound> bounds;
  for (const MassProperties& own : properties) {
    const Expr none(own.mass.graph(), own.mass.graph().constant(0));
    bounds.push_back({own.mass, none, trace(own.inertia)});
  }
  const auto size = [](Expr x) { return call(ir::Function::abs, x); };
  for (std::size_t i = links.size(); i-- > 0;) {
    if (links[i].parent == k_ground) continue;
    const Vector3& r = links[i].offset;
    MassBound& parent = bounds[links[i].parent];
    const Expr reach = bounds[i].reach + size(r[0]) + size(r[1]) + size(r[2]);
    // The farther of two branches, without a square root.
    parent.reach = parent.reach.is_zero() ? reach : parent.reach == reach ? reach : parent.reach + reach;
    parent.mass += bounds[i].mass;
    parent.inertia += bounds[i].inertia;
  }
  return bounds;
}

}  // namespace gaussgen::strategy
