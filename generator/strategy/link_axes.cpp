#include "strategy/link_axes.hpp"

#include "ir/contract.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Function;
using ir::Matrix3;
using ir::Vector3;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// Of several angles.
bool is_sum(Expr angle) {
  const ir::Node& node = angle.graph()[angle.id()];
  return node.kind == ir::Kind::sum && node.children.size() > 1;
}

Matrix3 named(const Matrix3& m, const std::string& name, Steps& steps) {
  return {steps.name(m[0], name + "_x"), steps.name(m[1], name + "_y"), steps.name(m[2], name + "_z")};
}

/// base times the turn
Matrix3 turned(const Matrix3& base, std::size_t axis, Expr sine, Expr cosine) {
  const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
  Matrix3 result = base;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k][p] = cosine * base[k][p] + sine * base[k][q];
    result[k][q] = cosine * base[k][q] - sine * base[k][p];
  }
  return result;
}

}  // namespace

const Matrix3& LinkAxes::of(std::size_t link, Steps& steps) {
  if (!ground_) ground_ = ir::identity3(graph_);
  if (link == k_ground) return *ground_;
  std::vector<std::size_t> path;
  for (std::size_t at = link; at != k_ground && !known_[at]; at = links_[at].parent) path.push_back(at);
  for (auto at = path.rbegin(); at != path.rend(); ++at) {
    const std::size_t parent = links_[*at].parent;
    known_[*at] = outward(*at, parent == k_ground ? Turned{*ground_, 0, {}, {}, {}, *ground_} : *known_[parent], steps);
  }
  return known_[link]->matrix;
}

bool LinkAxes::is_first(const Matrix3& base) const { return base == *ground_; }

LinkAxes::Turned LinkAxes::outward(std::size_t i, const Turned& before, Steps& steps) const {
  const Link& link = links_[i];
  if (link.kind == Link::Kind::shift || keeps_axes(link)) return before;
  Turned result = before;
  if (link.kind == Link::Kind::turn) {
    turn(link, before, result, steps);
    return result;
  }
  const Matrix3 columns = transposed(link.matrix);
  const auto column = [&](std::size_t k) { return ir::multiply(before.matrix, columns[k]); };
  result.matrix = named(transposed(Matrix3{column(0), column(1), column(2)}), "axes_" + link.name, steps);
  result.angle.reset();
  return result;
}

void LinkAxes::turn(const Link& link, const Turned& before, Turned& result, Steps& steps) const {
  const bool goes_on = before.angle && before.axis == link.axis;
  if (!goes_on) result.base = before.matrix;
  result.axis = link.axis;
  result.angle = goes_on ? *before.angle + *link.angle : *link.angle;
  const Expr s = call(Function::sin, *link.angle), c = call(Function::cos, *link.angle);
  if (goes_on && is_sum(*result.angle)) {
    result.sine = steps.name(*before.sine * c + *before.cosine * s, "sin_" + link.name);
    result.cosine = steps.name(*before.cosine * c - *before.sine * s, "cos_" + link.name);
  } else {
    result.sine = call(Function::sin, *result.angle);
    result.cosine = call(Function::cos, *result.angle);
  }
  result.matrix = turned(result.base, link.axis, *result.sine, *result.cosine);
  if (!is_first(result.base)) result.matrix = named(result.matrix, "axes_" + link.name, steps);
}

}  // namespace gaussgen::strategy
