#include "strategy/link_rows.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "strategy/axes.hpp"
#include "strategy/spins.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::ConstraintAction;
using kinematics::ConstraintRow;
using kinematics::is_fixed;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::LocalDirection;
using kinematics::Place;

namespace {

/// Of ±e_k.
std::optional<std::size_t> axis_of(const Vector3& v) {
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    if (v[k].is_zero()) continue;
    if (axis || !(v[k].is_one() || (-v[k]).is_one())) return std::nullopt;
    axis = k;
  }
  return axis;
}

/// A freedom along this component and no other, by a number.
bool is_free_along(const Link& link, std::size_t k) {
  return std::any_of(link.freedoms.begin(), link.freedoms.end(), [&](const kinematics::Freedom& freedom) {
    const Vector3& c = freedom.column;
    const bool is_only = c[(k + 1) % 3].is_zero() && c[(k + 2) % 3].is_zero();
    return is_only && c[k].graph()[c[k].id()].kind == ir::Kind::constant;
  });
}

}  // namespace

LinkRowBuilder::LinkRowBuilder(const ConstraintProblem& problem, kinematics::Linkage& linkage)
    : problem_(problem), linkage_(linkage), graph_(problem.kinematics.field[0].graph()) {
  std::size_t count = 0;
  for (const ConstraintRow& row : problem.kinematics.constraints) placed_.push_back(placed(count++, row));
  for (const ConstraintRow& row : problem.kinematics.idle_slips) placed_.push_back(placed(count++, row));
  follow_contacts();
  find_groups();
}

bool LinkRowBuilder::can_be_placed(const ConstraintAction& action) const {
  if (!action.local || (action.along_way && !problem_.vanishes(*action.along_way))) return false;
  const LocalDirection& local = *action.local;
  const std::optional<Place>& carrier = linkage_.places[local.carrier];
  if (!is_fixed(local.components) || !carrier || !carrier->is_fixed) return false;
  if (local.place == model::k_space || !linkage_.places[local.place]) return false;
  const std::size_t at = linkage_.places[local.place]->link;
  const std::vector<Link>& links = linkage_.links;
  if (!is_carried(links, at, carrier->link) && !is_carried(links, carrier->link, at)) return false;
  if (local.axes == model::k_space) return true;
  return linkage_.places[local.axes] && linkage_.places[local.axes]->is_fixed;
}

std::optional<LinkRowBuilder::PlacedRow> LinkRowBuilder::placed(std::size_t constraint,
                                                                const ConstraintRow& row) const {
  if (row.actions.empty() || !std::all_of(row.beside.begin(), row.beside.end(), problem_.vanishes)) return std::nullopt;
  PlacedRow result{constraint, model::k_space, {}};
  for (const ConstraintAction& action : row.actions) {
    if (action.local && action.local->carrier == model::k_space) continue;
    if (!can_be_placed(action)) return std::nullopt;
    const LocalDirection& local = *action.local;
    const std::size_t link = linkage_.places[local.carrier]->link;
    result.axes = local.axes;
    if (link != k_ground) result.spots.push_back({link, local.place, local.components});
  }
  return result.spots.empty() ? std::nullopt : std::optional<PlacedRow>(std::move(result));
}

void LinkRowBuilder::follow_contacts() {
  for (const std::optional<PlacedRow>& row : placed_) {
    if (!row) continue;
    for (const Spot& spot : row->spots) {
      if (linkage_.links[spot.link].kind == Link::Kind::spin)
        follow(linkage_, spot.link, position(spot), problem_.rate_of);
    }
  }
}

void LinkRowBuilder::find_groups() {
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    if (placed_[i] && placed_[i]->axes == model::k_space) add_to_groups(i);
  }
  for (Group& group : groups_) release_or_drop(group);
}

std::size_t LinkRowBuilder::first_of(const Group& group) {
  return **std::find_if(group.along.begin(), group.along.end(), [](const auto& row) { return row.has_value(); });
}

void LinkRowBuilder::add_to_groups(std::size_t index) {
  const std::vector<Spot>& spots = placed_[index]->spots;
  const std::optional<std::size_t> axis = axis_of(spots[0].direction);
  const auto is_alike = [&](const Spot& a, const Spot& b) { return a.link == b.link && a.place == b.place; };
  const bool is_along_axis = axis && std::all_of(spots.begin(), spots.end(),
                                                 [&](const Spot& spot) { return axis_of(spot.direction) == axis; });
  if (!is_along_axis) return;
  for (Group& group : groups_) {
    const std::vector<Spot>& others = placed_[first_of(group)]->spots;
    const bool is_same = std::equal(spots.begin(), spots.end(), others.begin(), others.end(), is_alike);
    if (!is_same || group.along[*axis]) continue;
    group.along[*axis] = index;
    return;
  }
  groups_.push_back({});
  groups_.back().along[*axis] = index;
}

// The third direction of rolling, along which a coordinate of the model follows the surface: as a row it says how, and the origin is
// free along it.
void LinkRowBuilder::release_or_drop(Group& group) {
  std::size_t count = 0;
  std::optional<std::size_t> idle;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!group.along[k]) continue;
    if (is_idle(*group.along[k])) {
      idle = k;
    } else {
      ++count;
    }
  }
  if (!idle) return;
  std::size_t base = placed_[*group.along[*idle]]->spots[0].link;
  while (linkage_.links[base].parent != k_ground) base = linkage_.links[base].parent;
  const Link& link = linkage_.links[base];
  const bool is_floating = link.kind == Link::Kind::shift && is_free_along(link, (*idle + 1) % 3) &&
                           is_free_along(link, (*idle + 2) % 3) && !is_free_along(link, *idle);
  const bool is_alone =
      std::none_of(released_.begin(), released_.end(), [&](const auto& r) { return r.first == base; });
  if (count == 2 && is_floating && is_alone && placed_[*group.along[*idle]]->spots.size() == 1) {
    released_.emplace_back(base, *idle);
  } else {
    group.along[*idle].reset();
  }
}

Vector3 LinkRowBuilder::position(const Spot& spot) const {
  const Place& place = *linkage_.places[spot.place];
  return position_on(linkage_.links, place.link, spot.link, place.position);
}

// d/dt of direction·(v + ω × ρ) where the direction stays: direction·(a + α × ρ + ω × dρ/dt).
void LinkRowBuilder::add_term(const Spot& spot, const Vector3& direction, LinkMotion& motion, LinkRow& row) const {
  const Vector3 place = position(spot);
  const Vector3 way{problem_.rate_of(place[0]), problem_.rate_of(place[1]), problem_.rate_of(place[2])};
  const Vector3 velocity = way + cross(motion.omega_of_axes(spot.link), place);
  row.links.push_back({spot.link, direction, cross(place, direction)});
  row.rest += dot(direction, cross(motion.omega(spot.link), velocity));
}

// The axes of the link, as far as turns to it leave the directions of the group among themselves.
std::size_t LinkRowBuilder::axes_of(const Group& group) const {
  const std::size_t link = placed_[first_of(group)]->spots[0].link;
  const auto count =
      std::count_if(group.along.begin(), group.along.end(), [](const auto& row) { return row.has_value(); });
  if (count == 3) return link;
  std::vector<std::size_t> path;
  for (std::size_t at = link; at != k_ground; at = linkage_.links[at].parent) path.push_back(at);
  std::size_t axes = k_ground;
  for (auto at = path.rbegin(); at != path.rend(); ++at) {
    const Link& next = linkage_.links[*at];
    if (next.kind == Link::Kind::free) break;
    if (next.kind == Link::Kind::turn && group.along[next.axis].has_value() == (count == 2)) break;
    axes = *at;
  }
  return axes;
}

const ConstraintRow& LinkRowBuilder::row_of(std::size_t index) const {
  const kinematics::Kinematics& kinematics = problem_.kinematics;
  const bool is_idle = index >= problem_.b.size();
  return is_idle ? kinematics.idle_slips[index - problem_.b.size()]
                 : kinematics.constraints[kinematics::ConstraintIndex{index}];
}

LinkRow LinkRowBuilder::empty_row(std::size_t index) const {
  return {row_of(index).name, {}, {}, number(0), number(0)};
}

Expr LinkRowBuilder::rest_beside(std::size_t index) const {
  const Expr by_time = problem_.rate_of(row_of(index).phi_beside);
  return problem_.residuals.empty() ? by_time : by_time + problem_.residuals[index];
}

// A wheel rolls along the plane, and nothing falls along it, but its axes do not show this.
void LinkRowBuilder::set_fall(Expr fall, LinkRow& row) const {
  if (!problem_.vanishes(fall)) row.fall = fall;
}

void LinkRowBuilder::add(const Group& group, LinkMotion& motion, LinkAxes& in_space, Steps& steps,
                         LinkRows& result) const {
  const std::size_t axes = axes_of(group);
  const std::size_t first_row = result.rows.size();
  std::vector<std::size_t> directions;
  for (std::size_t k = 0; k < 3; ++k) {
    if (group.along[k]) directions.push_back(k);
  }
  for (const std::size_t k : directions) {
    const PlacedRow& as = *placed_[*group.along[k]];
    LinkRow row = empty_row(as.constraint);
    int falling = 0;
    for (const Spot& spot : as.spots) {
      // Against the first: rows differ in sign as wholes.
      const bool is_opposite = !(spot.direction[k] == as.spots[0].direction[k]);
      const Vector3 along = resolved(linkage_.links, axes, spot.link, ir::unit_vector(graph_, k));
      add_term(spot, is_opposite ? -along : along, motion, row);
      falling += is_opposite ? -1 : 1;
    }
    if (falling != 0) set_fall(ir::Rational(falling) * motion.fall_at(axes)[k], row);
    result.rows.push_back(std::move(row));
  }
  steps.begin("how the axes of the rows lie in space, for multipliers");
  for (const std::size_t k : directions) {
    if (is_idle(*group.along[k])) continue;
    const PlacedRow& as = *placed_[*group.along[k]];
    const Vector3 in_axes = in_space.of(axes, steps)[k];
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Expr share = in_axes[directions[i]] * as.spots[0].direction[k];
      if (share.is_zero()) continue;
      result.multipliers[as.constraint].push_back({first_row + i, share});
      // The axes of the rows are as orthogonal as those of space: what turns multipliers turns residuals back.
      result.rows[first_row + i].rest += share * rest_beside(as.constraint);
    }
  }
}

// Directions in the axes of a frame turn with them: (ω_axes × direction)·v beside the others. So do those of a body within axes of its link that do not turn with it, those of
// a spin: d(direction)/dt there.
void LinkRowBuilder::add(const PlacedRow& placed, LinkMotion& motion, Steps& steps, LinkRows& result) const {
  LinkRow row = empty_row(placed.constraint);
  Vector3 falling = ir::zero3(graph_);
  std::size_t axes = k_ground;
  for (const Spot& spot : placed.spots) {
    Vector3 along = spot.direction;
    if (placed.axes != model::k_space) {
      const Place& place = *linkage_.places[placed.axes];
      axes = place.link;
      along = ir::multiply(place.axes, along);
    }
    const Vector3 direction = resolved(linkage_.links, axes, spot.link, along);
    add_term(spot, direction, motion, row);
    falling = falling + along;
    Vector3 change{problem_.rate_of(along[0]), problem_.rate_of(along[1]), problem_.rate_of(along[2])};
    if (axes != k_ground) change = change + cross(motion.omega_of_axes(axes), along);
    if (is_zero(change)) continue;
    const Vector3 turning = resolved(linkage_.links, axes, spot.link, change);
    row.rest += dot(turning, motion.velocity(spot.link, steps) + cross(motion.omega(spot.link), position(spot)));
  }
  if (!is_zero(falling)) set_fall(dot(falling, motion.fall_at(axes)), row);
  row.rest += rest_beside(placed.constraint);
  result.multipliers[placed.constraint].push_back({result.rows.size(), number(1)});
  result.rows.push_back(std::move(row));
}

void LinkRowBuilder::add_over_speeds(std::size_t constraint, LinkRows& result) const {
  LinkRow row = empty_row(constraint);
  row.rest = problem_.b_drift[constraint];
  for (std::size_t u = 0; u < problem_.b[constraint].size(); ++u) {
    if (!problem_.b[constraint][u].is_zero()) row.speeds.push_back({u, problem_.b[constraint][u]});
  }
  result.multipliers[constraint].push_back({result.rows.size(), number(1)});
  result.rows.push_back(std::move(row));
}

LinkRows LinkRowBuilder::rows(LinkMotion& motion, Steps& steps) const {
  LinkRows result;
  result.multipliers.resize(problem_.b.size());
  result.released = released_;
  std::vector<char> is_done(problem_.b.size(), 0);
  LinkAxes in_space(linkage_.links, graph_);
  for (const Group& group : groups_) {
    bool is_wanted = false;
    for (const auto& index : group.along) {
      if (!index || is_idle(*index)) continue;
      is_done[placed_[*index]->constraint] = 1;
      is_wanted = true;
    }
    if (is_wanted) add(group, motion, in_space, steps, result);
  }
  for (std::size_t mu = 0; mu < problem_.b.size(); ++mu) {
    if (is_done[mu] != 0) continue;
    if (placed_[mu]) {
      add(*placed_[mu], motion, steps, result);
    } else {
      add_over_speeds(mu, result);
    }
  }
  return result;
}

}  // namespace gaussgen::strategy
