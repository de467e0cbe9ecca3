#include "kinematics/frames.hpp"

#include "ir/contract.hpp"
#include "kinematics/expressions.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using model::Axes;

namespace {

Matrix3 elementary_rotation(Expr angle, std::size_t axis) {
  ir::Graph& graph = angle.graph();
  Matrix3 matrix = ir::identity3(graph);
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  const Expr c = call(ir::Function::cos, angle);
  const Expr s = call(ir::Function::sin, angle);
  matrix[i][i] = c;
  matrix[j][j] = c;
  matrix[i][j] = -s;
  matrix[j][i] = s;
  return matrix;
}

/// c 1 + s [n]× + (1 - c) n nᵀ for a unit vector n (Rodrigues).
Matrix3 rotation_about(const Vector3& n, Expr angle) {
  ir::Graph& graph = angle.graph();
  const Expr c = call(ir::Function::cos, angle);
  const Expr s = call(ir::Function::sin, angle);
  const Expr rest = Expr(graph, graph.constant(1)) - c;
  Matrix3 matrix{Vector3{c, -s * n[2], s * n[1]}, Vector3{s * n[2], c, -s * n[0]}, Vector3{-s * n[1], s * n[0], c}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += rest * n[i] * n[j];
  }
  return matrix;
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  const Matrix3 columns{ir::multiply(a, column(b, 0)), ir::multiply(a, column(b, 1)), ir::multiply(a, column(b, 2))};
  return transposed(columns);
}

}  // namespace

// R = (e0² - v·v) 1 + 2 v vᵀ + 2 e0 [v]×, written with e·e = 1.
Matrix3 quaternion_matrix(const std::array<Expr, 4>& e) {
  const Expr one(e[0].graph(), e[0].graph().constant(1));
  const support::Rational two = 2;
  return {Vector3{one - two * (e[2] * e[2] + e[3] * e[3]), two * (e[1] * e[2] - e[0] * e[3]),
                  two * (e[1] * e[3] + e[0] * e[2])},
          Vector3{two * (e[1] * e[2] + e[0] * e[3]), one - two * (e[1] * e[1] + e[3] * e[3]),
                  two * (e[2] * e[3] - e[0] * e[1])},
          Vector3{two * (e[1] * e[3] - e[0] * e[2]), two * (e[2] * e[3] + e[0] * e[1]),
                  one - two * (e[1] * e[1] + e[2] * e[2])}};
}

Frames::Frames(const model::Model& model, const Symbols& symbols, Expressions& expressions, std::size_t base)
    : model_(model), symbols_(symbols), expressions_(expressions), base_(base) {}

Matrix3 Frames::identity() const { return ir::identity3(expressions_.graph()); }

Vector3 Frames::origin(std::size_t frame) {
  return frame == base_ ? ir::zero3(expressions_.graph()) : placed(frame).origin;
}

Matrix3 Frames::axes(std::size_t frame) { return frame == base_ ? identity() : placed(frame).axes; }

Vector3 Frames::point(std::size_t frame, const Vector3& inside) {
  return frame == base_ ? inside : origin(frame) + ir::multiply(axes(frame), inside);
}

Vector3 Frames::omega(std::size_t frame, Axes axes) {
  return axes == Axes::space ? omega_in_space(frame) : omega_in_body(frame);
}

// From space outwards, so that long chains need no stack.
const Frames::Placed& Frames::placed(std::size_t frame) {
  std::vector<std::size_t> path;
  for (std::size_t at = frame; at != base_ && placed_.count(at) == 0; at = model_.frames[at].parent) path.push_back(at);
  for (auto at = path.rbegin(); at != path.rend(); ++at) placed_.emplace(*at, place(*at));
  return placed_.at(frame);
}

void Frames::carry_velocities(std::size_t frame, ir::Directional& rates) {
  std::vector<std::size_t> path;
  for (std::size_t at = frame; at != base_ && carried_.count(at) == 0; at = model_.frames[at].parent)
    path.push_back(at);
  for (auto at = path.rbegin(); at != path.rend(); ++at) {
    carried_.insert(*at);
    if (model_.frames[*at].parent == base_) continue;
    carry_velocity(*at, rates);
    carry_angle(*at, rates);
  }
}

// v = v_parent + d/dt (A_parent r)
void Frames::carry_velocity(std::size_t frame, ir::Directional& rates) {
  const model::Frame& what = model_.frames[frame];
  const Vector3 before = origin(what.parent), now = origin(frame);
  const Vector3 between = ir::multiply(axes(what.parent), expressions_(what.position));
  for (std::size_t k = 0; k < 3; ++k) {
    if (before[k].is_zero() || between[k].is_zero()) continue;
    const Expr rate = rates(before[k]) + rates(between[k]);
    if (!rate.is_zero()) rates.take(now[k], rate.named("v_of_" + what.name.text + "_" + "xyz"[k]));
  }
}

void Frames::carry_angle(std::size_t frame, ir::Directional& rates) {
  const Placed& now = placed(frame);
  const Placed& before = placed(model_.frames[frame].parent);
  if (now.steps.size() != 1 || !now.axis || now.axis != before.axis || *now.angle == *before.angle) return;
  const Expr rate = rates(*before.angle) + rates(*now.steps[0].angle);
  rates.take(*now.angle, rate.named("rate_of_" + model_.frames[frame].name.text));
}

Frames::Placed Frames::place(std::size_t index) {
  const model::Frame& frame = model_.frames[index];
  const Vector3 inside = expressions_(frame.position);
  Placed result{inside, identity(), {}, {}, identity(), steps_of(frame.attitude)};
  if (frame.parent != base_) {
    const Placed& parent = placed_.at(frame.parent);
    result.origin = parent.origin + ir::multiply(parent.axes, inside);
    result.base = parent.base;
    result.axis = parent.axis;
    result.angle = parent.angle;
    result.axes = parent.axes;
  }
  for (const Step& step : result.steps) {
    if (step.axis && step.axis == result.axis) {
      result.angle = *result.angle + *step.angle;
    } else {
      result.base = result.axes;
      result.axis = step.axis;
      result.angle = step.angle;
    }
    result.axes = multiply(result.base, result.axis ? elementary_rotation(*result.angle, *result.axis) : step.matrix);
  }
  return result;
}

std::vector<Frames::Step> Frames::steps_of(const model::Attitude& attitude) {
  std::vector<Step> steps;
  if (const auto* turns = std::get_if<model::Turns>(&attitude)) {
    for (const model::Turn& one : *turns) {
      Step step = turn(one);
      if (!step.angle->is_zero()) steps.push_back(std::move(step));
    }
  } else if (const auto* orientation = std::get_if<model::QuaternionOrientation>(&attitude)) {
    steps.push_back(quaternion(orientation->index));
  }
  return steps;
}

Frames::Step Frames::turn(const model::Turn& turn) {
  ir::Graph& graph = expressions_.graph();
  const Expr angle = expressions_(turn.angle);
  const Expr rate = expressions_.rate(angle);
  if (const char* letter = std::get_if<char>(&turn.axis)) {
    const auto axis = static_cast<std::size_t>(*letter - 'x');
    const Vector3 along = rate * unit_vector(graph, axis);
    return {elementary_rotation(angle, axis), along, along, axis, angle};
  }
  const Vector3 direction = expressions_(std::get<std::array<model::Ast, 3>>(turn.axis));
  const Vector3 n = ir::pow(dot(direction, direction), support::Rational(-1) / 2) * direction;
  return {rotation_about(n, angle), rate * n, rate * n, {}, angle};
}

Frames::Step Frames::quaternion(std::size_t orientation) {
  const std::size_t first_q = symbols_.first_quaternion_component[orientation].value;
  const auto e = [&](std::size_t i) {
    return expressions_.symbol(symbols_.configuration[ConfigurationIndex{first_q + i}].symbol);
  };
  const std::size_t first_u = symbols_.first_angular_velocity[orientation].value;
  const auto u = [&](std::size_t i) { return expressions_.symbol(symbols_.speeds[FreeIndex{first_u + i}].symbol); };
  const Matrix3 matrix = quaternion_matrix({e(0), e(1), e(2), e(3)});
  const Vector3 omega{u(0), u(1), u(2)};
  if (model_.orientations[orientation].axes == Axes::space) {
    return {matrix, omega, ir::multiply(transposed(matrix), omega), {}, {}};
  }
  return {matrix, ir::multiply(matrix, omega), omega, {}, {}};
}

Vector3 Frames::turning(std::size_t frame) {
  Vector3 omega = ir::zero3(expressions_.graph());
  for (const Vector3& part : turns_in_parent(frame)) omega = omega + part;
  return omega;
}

// α̇ a, R_a (β̇ b), R_a R_b (γ̇ c)
std::vector<Vector3> Frames::turns_in_parent(std::size_t frame) {
  const std::vector<Step>& steps = placed(frame).steps;
  std::vector<Vector3> parts;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Vector3 part = steps[i].before;
    for (std::size_t j = i; j-- > 0;) part = ir::multiply(steps[j].matrix, part);
    parts.push_back(part);
  }
  return parts;
}

// ω = ω_parent + A_parent (α̇ a + R_a (β̇ b) + R_a R_b (γ̇ c)), for every parent in turn.
Vector3 Frames::omega_in_space(std::size_t frame) {
  Vector3 omega = ir::zero3(expressions_.graph());
  for (std::size_t at = frame; at != base_; at = model_.frames[at].parent) {
    const std::size_t parent = model_.frames[at].parent;
    for (const Vector3& part : turns_in_parent(at)) {
      omega = omega + (parent == base_ ? part : ir::multiply(axes(parent), part));
    }
  }
  return omega;
}

// The same vectors turned back into the frame, step by step.
Vector3 Frames::omega_in_body(std::size_t frame) {
  std::vector<std::size_t> path;
  for (std::size_t at = frame; at != base_; at = model_.frames[at].parent) path.push_back(at);
  Vector3 omega = ir::zero3(expressions_.graph());
  for (auto at = path.rbegin(); at != path.rend(); ++at) {
    const std::vector<Step>& steps = placed(*at).steps;
    for (const Step& step : steps) omega = ir::multiply(transposed(step.matrix), omega);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Vector3 part = steps[i].after;
      for (std::size_t j = i + 1; j < steps.size(); ++j) part = ir::multiply(transposed(steps[j].matrix), part);
      omega = omega + part;
    }
  }
  return omega;
}

}  // namespace gaussgen::kinematics
