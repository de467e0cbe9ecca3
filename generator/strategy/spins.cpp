#include "strategy/spins.hpp"

#include "ir/contract.hpp"
#include "ir/rotation.hpp"
#include "ir/traverse.hpp"
#include "strategy/axes.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::Linkage;

namespace {

bool is_same_all_around(const MassProperties& body, std::size_t axis) {
  const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
  const Matrix3& I = body.inertia;
  const bool is_on_axis = body.first[p].is_zero() && body.first[q].is_zero();
  const bool is_principal = I[axis][p].is_zero() && I[axis][q].is_zero() && I[p][q].is_zero();
  return is_on_axis && is_principal && I[p][p] == I[q][q];
}

bool is_same_in_all_directions(const MassProperties& body) {
  return is_same_all_around(body, 0) && is_same_all_around(body, 1) && is_zero(body.first);
}

/// Its own turn and those before it are one.
void hang_before_turns_about_the_same_axis(std::vector<Link>& links, Link& spin) {
  while (spin.parent != k_ground) {
    const Link& before = links[spin.parent];
    if (before.kind == Link::Kind::spin) {
      spin.parent = before.parent;  // which does not turn, as something hangs on it
      continue;
    }
    if (before.kind != Link::Kind::turn || before.axis != spin.axis) return;
    spin.angle = *spin.angle + *before.angle;
    spin.velocity = spin.velocity + before.velocity;
    spin.drift = spin.drift + before.drift;
    spin.freedoms.insert(spin.freedoms.begin(), before.freedoms.begin(), before.freedoms.end());
    spin.parent = before.parent;
  }
}

/// Into axes that are turned by the opposite angle.
void turn_places(Linkage& linkage, std::size_t link, std::size_t axis, Expr angle) {
  for (std::optional<kinematics::Place>& place : linkage.places) {
    if (!place || place->link != link) continue;
    place->position = ir::turned(place->position, axis, angle);
    const Matrix3 columns = transposed(place->axes);
    place->axes = transposed(Matrix3{ir::turned(columns[0], axis, angle), ir::turned(columns[1], axis, angle),
                                     ir::turned(columns[2], axis, angle)});
  }
}

/// Its speeds are components along the axes before the turn: in these, nothing of it turns.
void roll(Linkage& linkage, std::size_t ball) {
  Link& link = linkage.links[ball];
  for (std::optional<kinematics::Place>& place : linkage.places) {
    if (!place || place->link != ball) continue;
    place->position = ir::multiply(link.matrix, place->position);
    const Matrix3 columns = transposed(place->axes);
    place->axes = transposed(Matrix3{ir::multiply(link.matrix, columns[0]), ir::multiply(link.matrix, columns[1]),
                                     ir::multiply(link.matrix, columns[2])});
  }
  link.kind = Link::Kind::ball;
  link.velocity = *link.velocity_before;
  for (std::size_t j = 0; j < 3; ++j) link.freedoms[j].column = ir::unit_vector(link.velocity[0].graph(), j);
  link.to_speeds.reset();
}

}  // namespace

void find_spins(const std::vector<MassProperties>& properties, Linkage& linkage) {
  const auto children = children_of(linkage.links);
  for (std::size_t i = 0; i < linkage.links.size(); ++i) {
    Link& link = linkage.links[i];
    const bool is_ball = link.velocity_before && children[i].empty() && is_same_in_all_directions(properties[i]);
    if (is_ball) roll(linkage, i);
    if (link.kind != Link::Kind::turn || !children[i].empty() || !is_same_all_around(properties[i], link.axis))
      continue;
    link.kind = Link::Kind::spin;
    link.rate.reset();
    hang_before_turns_about_the_same_axis(linkage.links, link);
    turn_places(linkage, i, link.axis, *link.angle);
  }
}

void follow(Linkage& linkage, std::size_t spin, const Vector3& place, const std::function<Expr(Expr)>& rate_of) {
  Link& link = linkage.links[spin];
  const std::size_t p = (link.axis + 1) % 3, q = (link.axis + 2) % 3;
  const std::optional<Expr> angle = ir::polar_angle(place[p], place[q]);
  if (!angle || ir::is_of_parameters(angle->graph(), angle->id())) return;
  link.kind = Link::Kind::turn;
  link.angle = *angle;
  link.rate = rate_of(*angle);
  turn_places(linkage, spin, link.axis, -*angle);
}

}  // namespace gaussgen::strategy
