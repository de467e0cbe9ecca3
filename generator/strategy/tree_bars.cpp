// Bars in a plane: their Schur complements go on as numerators, until they turned and got their masses (bar.hpp).

#include <algorithm>

#include "strategy/tree_z.hpp"

namespace gaussgen::strategy {

using ir::Rational;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::Link;

namespace {

PlaneVector across(const Vector3& v, std::size_t axis) { return {v[(axis + 1) % 3], v[(axis + 2) % 3]}; }

}  // namespace

bool TreeZ::is_only_child(std::size_t i) const {
  if (links_[i].parent == k_ground) return false;
  const std::vector<std::size_t>& children = children_[links_[i].parent];
  return std::all_of(children.begin(), children.end(),
                     [&](std::size_t child) { return child == i || is_bare_[child] != 0; });
}

PlaneBlock TreeZ::block_of(std::size_t i, std::size_t axis) const {
  const Component p = a(i, (axis + 1) % 3), q = a(i, (axis + 2) % 3);
  return PlaneBlock::of(Z_.entry(p, p), Z_.entry(p, q), Z_.entry(q, q));
}

void TreeZ::replace_block(std::size_t i, std::size_t axis, const PlaneBlock& block) {
  const Component p = a(i, (axis + 1) % 3), q = a(i, (axis + 2) % 3);
  Z_.replace(p, p, block.pp);
  Z_.replace(p, q, block.pq);
  Z_.replace(q, q, block.qq);
}

// What a bar carries at its end, where it does not resist a turn of the bar but by its place.
void TreeZ::remember_end(std::size_t i) {
  const Link& link = links_[i];
  if (!is_only_child(i) || !link.freedoms.empty() || links_[link.parent].kind != Link::Kind::turn) return;
  const std::size_t axis = links_[link.parent].axis;
  const Component turned = alpha(i, axis);
  if (!Z_.neighbours(turned).empty() || !Z_.entry(turned, turned).is_zero()) return;
  Z_.name(components(i), steps_);
  PlaneBlock block = block_of(i, axis);
  if (const auto known = determinants_.find(i); known != determinants_.end()) block.determinant = known->second;
  ends_.insert({link.parent, {across(link.offset, axis), block}});
}

// One that turns by a speed of its own, on something that carries nothing else.
std::optional<Bar> TreeZ::bar_at(std::size_t i, Component c) const {
  const Link& link = links_[i];
  const auto end = ends_.find(i);
  if (end == ends_.end() || c != alpha(i, link.axis)) return std::nullopt;
  const auto is_owned = [this](const kinematics::Freedom& freedom) { return is_own(freedom); };
  if (!std::all_of(link.freedoms.begin(), link.freedoms.end(), is_owned)) return std::nullopt;
  if (!is_only_child(i) || !is_shift(link.parent) || links_[link.parent].parent == k_ground) return std::nullopt;
  for (const std::size_t at : {i, link.parent}) {
    if (own_.base_at(at) != nullptr || own_.base_anchored_at(at) != nullptr) return std::nullopt;
  }
  const MassProperties& own = properties_[i];
  return Bar{end->second.offset, end->second.block, own.inertia[link.axis][link.axis], across(own.first, link.axis)};
}

Eliminated TreeZ::minimise_bar(std::size_t i, Component c, const Bar& bar) {
  const PostponedBlock block(bar, name_of(c, c), steps_);
  // The denominator has the sign of its unit.
  const Rational sign = block.is_negative() ? -1 : 1;
  margins_.push_back({sign * block.denominator(), sign * block.unit() * trusted(c)});
  is_clean_ = false;
  Eliminated result = Z_.minimise(c, block.inverse(), steps_);
  if (block.is_led_by_end()) result.lever = lever_of(i, bar, block);
  replace_block(i, links_[i].axis, block.numerators());
  postponed_.insert({i, {links_[i].axis, block}});
  return result;
}

// With J < 0 the end is accelerated more than the turn alone would do: no digits are lost in the difference. Where J is large, they
// would be.
std::optional<Lever> TreeZ::lever_of(std::size_t i, const Bar& bar, const PostponedBlock& block) const {
  const std::size_t axis = links_[i].axis;
  const auto& [r_p, r_q] = bar.offset;
  if (!r_p.is_zero() && !r_q.is_zero()) return std::nullopt;
  if (r_p.is_zero()) return Lever{a(i, (axis + 1) % 3), -r_q, block.left_to_end()};
  return Lever{a(i, (axis + 2) % 3), r_p, block.left_to_end()};
}

void TreeZ::pass_block(std::size_t i) {
  const auto found = postponed_.find(i);
  if (found == postponed_.end()) return;
  Turned turned = found->second;
  postponed_.erase(found);
  const PlaneBlock now = block_of(links_[i].parent, turned.axis);
  turned.block.replace(now.pp, now.pq, now.qq);
  postponed_.insert({links_[i].parent, turned});
}

// With the mass of the link: nothing is to be added behind the division.
std::optional<std::size_t> TreeZ::divide_block(std::size_t i) {
  const auto found = postponed_.find(i);
  if (found == postponed_.end()) return std::nullopt;
  Turned turned = found->second;
  postponed_.erase(found);
  turned.block.add_mass(masses_[i]);
  const PlaneBlock divided = turned.block.divided();
  replace_block(i, turned.axis, divided);
  determinants_.insert({i, steps_.name(divided.determinant, problem_.prefix + "det_M_" + links_[i].name)});
  return turned.axis;
}

}  // namespace gaussgen::strategy
