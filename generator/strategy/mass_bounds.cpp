#include "strategy/mass_bounds.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Rational;
using ir::Vector3;
using kinematics::Link;

namespace {

Expr size(Expr x) { return call(ir::Function::abs, x); }

// Of a chain of n links with a parameter each, sums would be written out n times, with up to n terms.
Expr kept_short(Expr sum, const std::string& name) {
  constexpr std::size_t k_few_terms = 4;
  return sum.graph()[sum.id()].children.size() > k_few_terms ? sum.named(name) : sum;
}

}  // namespace

Expr AxisBounds::sum() const {
  Expr result = values_[of_[0]];
  for (std::size_t place = 0; place < 3; ++place) {
    if (place != of_[0] && is_used(place)) result += values_[place];
  }
  return result;
}

void AxisBounds::add(const AxisBounds& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) join(axis, other.of_[axis]);
  for (std::size_t place = 0; place < 3; ++place) {
    if (other.is_used(place)) add(place, other.values_[place]);
  }
}

void AxisBounds::join(std::size_t axis, std::size_t other) {
  const std::size_t kept = of_[axis], gone = of_[other];
  if (kept == gone) return;
  values_[kept] += values_[gone];
  for (std::size_t& place : of_) {
    if (place == gone) place = kept;
  }
}

void AxisBounds::clear(std::size_t axis) {
  const Expr shared = along(axis);
  // The others keep their place, which must not be the one of this axis.
  for (std::size_t other = 0; other < 3; ++other) {
    if (other == axis || of_[other] != of_[axis]) continue;
    const std::size_t before = of_[axis];
    values_[other] = shared;
    for (std::size_t third = 0; third < 3; ++third) {
      if (third != axis && of_[third] == before) of_[third] = other;
    }
    break;
  }
  of_[axis] = axis;
  values_[axis] = Rational(0) * shared;
}

void AxisBounds::keep_short(const std::string& name) {
  for (std::size_t place = 0; place < 3; ++place) {
    values_[place] = kept_short(values_[place], name + "_" + "xyz"[place]);
  }
}

MassBound MassBound::of(const MassProperties& own) {
  const auto& [x, y, z] = own.first;
  const Vector3 across{size(y) + size(z), size(z) + size(x), size(x) + size(y)};
  return {own.mass, AxisBounds(across), AxisBounds({own.inertia[0][0], own.inertia[1][1], own.inertia[2][2]})};
}

void MassBound::add(const MassBound& other) {
  mass += other.mass;
  moment.add(other.moment);
  inertia.add(other.inertia);
}

void MassBound::minimise(std::size_t axis) {
  moment.clear(axis);
  inertia.clear(axis);
}

MassBound passed_on(const Link& link, MassBound bound) {
  switch (link.kind) {
    case Link::Kind::shift:
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Expr p = link.offset[(axis + 1) % 3], q = link.offset[(axis + 2) % 3];
        const Expr arm = size(p) + size(q);
        if (arm.is_zero()) continue;
        bound.inertia.add(axis, Rational(2) * arm * bound.moment.along(axis) + bound.mass * (p * p + q * q));
        bound.moment.add(axis, bound.mass * arm);
      }
      break;
    case Link::Kind::turn:
      for (AxisBounds* bounds : {&bound.moment, &bound.inertia}) bounds->join((link.axis + 1) % 3, (link.axis + 2) % 3);
      break;
    case Link::Kind::free:
      for (AxisBounds* bounds : {&bound.moment, &bound.inertia}) {
        bounds->join(0, 1);
        bounds->join(0, 2);
      }
      break;
    default: break;  // the axes stay
  }
  bound.mass = kept_short(bound.mass, "mass_on_" + link.name);
  bound.moment.keep_short("moment_on_" + link.name);
  bound.inertia.keep_short("inertia_on_" + link.name);
  return bound;
}

}  // namespace gaussgen::strategy
