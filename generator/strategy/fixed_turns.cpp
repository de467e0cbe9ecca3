#include "strategy/fixed_turns.hpp"

#include <algorithm>

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

bool is_fixed_turn(const Link& link) {
  return link.kind == Link::Kind::turn && link.freedoms.empty() && is_zero(link.velocity) && !link.angle->is_zero() &&
         ir::is_of_parameters(link.angle->graph(), link.angle->id());
}

class AxesChoice {
 public:
  explicit AxesChoice(Linkage& linkage) : linkage_(linkage), links_(linkage.links), children_(children_of(links_)) {}

  void run() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (!is_fixed_turn(links_[i])) continue;
      const std::size_t axis = links_[i].axis;
      const Expr angle = *links_[i].angle;
      if (can_turn_axes(i, axis)) {
        turn_axes(i, axis, -angle);
        links_[i].angle = angle - angle;
      } else if (const std::size_t before = turn_before(i); before != k_ground && can_turn_axes(before, axis)) {
        turn_axes(before, axis, angle);
        links_[before].angle = *links_[before].angle + angle;
      }
    }
    // What does not turn any more keeps the axes before it.
    for (Link& link : links_) {
      if (link.kind == Link::Kind::turn && link.angle->is_zero()) link.kind = Link::Kind::spin;
    }
  }

 private:
  /// Before fixed shifts, about the same axis.
  std::size_t turn_before(std::size_t i) const {
    std::size_t at = links_[i].parent;
    while (at != k_ground && links_[at].kind == Link::Kind::shift) at = links_[at].parent;
    if (at == k_ground || links_[at].kind != Link::Kind::turn || links_[at].axis != links_[i].axis) return k_ground;
    return at;
  }

  /// Whether all that has the axes of a link can be given in others that are turned about one of them.
  bool can_turn_axes(std::size_t i, std::size_t axis) const {
    std::vector<std::size_t> open{i};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const std::size_t child : children_[at]) {
        const Link& link = links_[child];
        if (link.kind == Link::Kind::shift) {
          open.push_back(child);
        } else if (link.kind == Link::Kind::free || link.kind == Link::Kind::ball || link.axis != axis) {
          return false;
        }
      }
    }
    return true;
  }

  void turn_axes(std::size_t i, std::size_t axis, Expr angle) {
    std::vector<std::size_t> open{i};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      turn_contents(at, axis, angle);
      for (const std::size_t child : children_[at]) {
        Link& link = links_[child];
        if (link.kind == Link::Kind::turn) {
          link.angle = *link.angle - angle;
          continue;
        }
        if (link.kind == Link::Kind::shift) turn_shift(link, axis, angle);
        open.push_back(child);
      }
    }
  }

  static void turn_shift(Link& link, std::size_t axis, Expr angle) {
    for (Vector3* v : {&link.offset, &link.velocity, &link.drift}) *v = ir::turned(*v, axis, -angle);
    for (kinematics::Freedom& freedom : link.freedoms) freedom.column = ir::turned(freedom.column, axis, -angle);
  }

  static Matrix3 turned_columns(const Matrix3& m, std::size_t axis, Expr angle) {
    const Matrix3 columns = transposed(m);
    return ir::transposed({ir::turned(columns[0], axis, angle), ir::turned(columns[1], axis, angle),
                           ir::turned(columns[2], axis, angle)});
  }

  void turn_contents(std::size_t link, std::size_t axis, Expr angle) {
    for (kinematics::Part& part : linkage_.parts) {
      if (part.link != link) continue;
      part.centre = ir::turned(part.centre, axis, -angle);
      part.inertia = turned_columns(transposed(turned_columns(part.inertia, axis, -angle)), axis, -angle);
    }
    for (auto& place : linkage_.places) {
      if (!place || place->link != link) continue;
      place->position = ir::turned(place->position, axis, -angle);
      place->axes = turned_columns(place->axes, axis, -angle);
    }
  }

  Linkage& linkage_;
  std::vector<Link>& links_;
  std::vector<std::vector<std::size_t>> children_;
};

}  // namespace

bool has_fixed_turns(const Linkage& linkage) {
  return std::any_of(linkage.links.begin(), linkage.links.end(), is_fixed_turn);
}

void choose_axes(Linkage& linkage) { AxesChoice(linkage).run(); }

}  // namespace gaussgen::strategy
