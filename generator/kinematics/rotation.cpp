#include "kinematics/rotation.hpp"

#include "ir/contract.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using model::Frame;

namespace {

std::size_t axis_of(char letter) { return static_cast<std::size_t>(letter - 'x'); }

Vector3 unit_vector(ir::Graph& graph, std::size_t axis) {
  Vector3 v = ir::zero3(graph);
  v[axis] = Expr(graph, graph.constant(1));
  return v;
}

Matrix3 elementary_rotation(Expr angle, std::size_t axis) {
  ir::Graph& graph = angle.graph();
  Matrix3 matrix{unit_vector(graph, 0), unit_vector(graph, 1), unit_vector(graph, 2)};
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

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  const Matrix3 columns{ir::multiply(a, column(b, 0)), ir::multiply(a, column(b, 1)), ir::multiply(a, column(b, 2))};
  return transposed(columns);
}

// ω = α̇ a + R_a (β̇ b) + R_a R_b (γ̇ c) in space, and the same three vectors turned back into the body.
Rotation euler_rotation(const model::EulerAngles& euler, Frame frame, Expressions& expressions) {
  std::array<std::size_t, 3> axis{};
  std::vector<Expr> angle;
  std::vector<Matrix3> step;
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = axis_of(euler.sequence[i]);
    angle.push_back(expressions(euler.angles[i]));
    step.push_back(elementary_rotation(angle[i], axis[i]));
  }
  const Matrix3 first_two = multiply(step[0], step[1]);
  Rotation rotation{multiply(first_two, step[2]), ir::zero3(angle[0].graph()), frame};
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 part = expressions.rate(angle[i]) * unit_vector(angle[0].graph(), axis[i]);
    if (frame == Frame::space) {
      for (std::size_t j = i; j-- > 0;) part = ir::multiply(step[j], part);
    } else {
      for (std::size_t j = i + 1; j < 3; ++j) part = ir::multiply(transposed(step[j]), part);
    }
    rotation.omega = rotation.omega + part;
  }
  return rotation;
}

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

Rotation quaternion_rotation(const model::Orientation& orientation, std::size_t index, const Symbols& symbols,
                             Frame frame, Expressions& expressions) {
  const std::size_t first_q = symbols.first_quaternion_component[index].value;
  const auto e = [&](std::size_t i) {
    return expressions.symbol(symbols.configuration[ConfigurationIndex{first_q + i}].symbol);
  };
  const std::size_t first_u = symbols.first_angular_velocity[index].value;
  const auto u = [&](std::size_t i) { return expressions.symbol(symbols.speeds[FreeIndex{first_u + i}].symbol); };
  const Matrix3 matrix = quaternion_matrix({e(0), e(1), e(2), e(3)});
  Vector3 omega{u(0), u(1), u(2)};
  if (orientation.frame != frame) {
    omega = ir::multiply(frame == Frame::space ? matrix : transposed(matrix), omega);
  }
  return {matrix, omega, frame};
}

}  // namespace

Rotation rotation_of(const model::Model& model, const model::Body& body, const Symbols& symbols, Frame frame,
                     Expressions& expressions) {
  if (const auto* euler = std::get_if<model::EulerAngles>(&body.orientation)) {
    return euler_rotation(*euler, frame, expressions);
  }
  const std::size_t index = std::get<model::QuaternionOrientation>(body.orientation).index;
  return quaternion_rotation(model.orientations[index], index, symbols, frame, expressions);
}

}  // namespace gaussgen::kinematics
