#include "strategy/axes.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/rotation.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// About an axis by an angle, or by a matrix: from the axes at hand to the next ones.
struct Turning {
  std::size_t axis = 0;
  std::optional<Expr> angle;
  ir::Matrix3 matrix;
};

Turning outward(const Link& link, ir::Graph& graph) {
  if (link.kind == Link::Kind::free) return {0, {}, transposed(link.matrix)};
  return {link.axis, -*link.angle, ir::identity3(graph)};
}

Turning inward(const Link& link, ir::Graph& graph) {
  if (link.kind == Link::Kind::free) return {0, {}, link.matrix};
  return {link.axis, *link.angle, ir::identity3(graph)};
}

bool turns(const Link& link) { return link.kind == Link::Kind::turn || link.kind == Link::Kind::free; }

void append(std::vector<Turning>& path, Turning next) {
  if (path.empty() || !next.angle || !path.back().angle || path.back().axis != next.axis) {
    path.push_back(std::move(next));
    return;
  }
  path.back().angle = *path.back().angle + *next.angle;
  if (path.back().angle->is_zero()) path.pop_back();
}

/// The links on the way from the one to the other: up, and then down.
struct Way {
  std::vector<std::size_t> up, down;
};

Way way_between(const std::vector<Link>& links, std::size_t from, std::size_t to) {
  const std::size_t top = common_carrier(links, from, to);
  Way way;
  for (std::size_t at = from; at != top; at = links[at].parent) way.up.push_back(at);
  for (std::size_t at = to; at != top; at = links[at].parent) way.down.push_back(at);
  std::reverse(way.down.begin(), way.down.end());
  return way;
}

}  // namespace

std::vector<std::vector<std::size_t>> children_of(const std::vector<Link>& links) {
  std::vector<std::vector<std::size_t>> children(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].parent != k_ground) children[links[i].parent].push_back(i);
  }
  return children;
}

std::size_t common_carrier(const std::vector<Link>& links, std::size_t a, std::size_t b) {
  // Links come after what carries them.
  while (a != b) {
    std::size_t& later = b == k_ground || (a != k_ground && a > b) ? a : b;
    later = links[later].parent;
  }
  return a;
}

bool is_carried(const std::vector<Link>& links, std::size_t link, std::size_t by) {
  return common_carrier(links, link, by) == by;
}

Vector3 resolved(const std::vector<Link>& links, std::size_t from, std::size_t to, Vector3 v) {
  ir::Graph& graph = v[0].graph();
  const Way way = way_between(links, from, to);
  std::vector<Turning> path;
  for (const std::size_t i : way.up) {
    if (turns(links[i])) append(path, inward(links[i], graph));
  }
  for (const std::size_t i : way.down) {
    if (turns(links[i])) append(path, outward(links[i], graph));
  }
  for (const Turning& turning : path) {
    v = turning.angle ? ir::turned(v, turning.axis, *turning.angle) : ir::multiply(turning.matrix, v);
  }
  return v;
}

Vector3 position_on(const std::vector<Link>& links, std::size_t from, std::size_t to, Vector3 place) {
  ir::Graph& graph = place[0].graph();
  const auto turn = [&](const Turning& turning) {
    place = turning.angle ? ir::turned(place, turning.axis, *turning.angle) : ir::multiply(turning.matrix, place);
  };
  const Way way = way_between(links, from, to);
  for (const std::size_t i : way.up) {
    if (links[i].kind == Link::Kind::shift) place = place + links[i].offset;
    if (turns(links[i])) turn(inward(links[i], graph));
  }
  for (const std::size_t i : way.down) {
    if (links[i].kind == Link::Kind::shift) place = place - links[i].offset;
    if (turns(links[i])) turn(outward(links[i], graph));
  }
  return place;
}

}  // namespace gaussgen::strategy
