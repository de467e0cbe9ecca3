#include "newton/motion.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

namespace agreement::newton {

using gaussgen::model::Ast;
using gaussgen::model::AstKind;
using gaussgen::model::k_space;

namespace {

const Real k_unknown = std::numeric_limits<Real>::quiet_NaN();

Matrix fixed(const Matrix3& m) { return {m, Matrix3::Zero(), Matrix3::Zero()}; }

Vector vector(const Number& x, const Number& y, const Number& z) {
  return {{x.value, y.value, z.value}, {x.rate, y.rate, z.rate}, {x.second, y.second, z.second}};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a.value.cross(b.value), a.rate.cross(b.value) + a.value.cross(b.rate),
          a.second.cross(b.value) + 2 * a.rate.cross(b.rate) + a.value.cross(b.second)};
}

Number elementary(const std::string& name, const Number& a) {
  const Real x = a.value;
  if (name == "sin") return sin(a);
  if (name == "cos") return cos(a);
  if (name == "sqrt") return pow(a, 0.5);
  if (name == "exp") return composed(a, functions::exp(x), functions::exp(x), functions::exp(x));
  if (name == "log") return composed(a, functions::log(x), 1 / x, -1 / (x * x));
  if (name == "sinh") return composed(a, functions::sinh(x), functions::cosh(x), functions::sinh(x));
  if (name == "cosh") return composed(a, functions::cosh(x), functions::sinh(x), functions::cosh(x));
  const Real t = name == "tan" ? functions::tan(x) : functions::tanh(x);
  if (name == "tan") return composed(a, t, 1 + t * t, 2 * t * (1 + t * t));
  if (name == "tanh") return composed(a, t, 1 - t * t, -2 * t * (1 - t * t));
  const Real w = 1 / functions::sqrt(1 - x * x);
  if (name == "asin") return composed(a, functions::asin(x), w, x * w * w * w);
  if (name == "acos") return composed(a, functions::acos(x), -w, -x * w * w * w);
  if (name == "atan") return composed(a, functions::atan(x), 1 / (1 + x * x), -2 * x / ((1 + x * x) * (1 + x * x)));
  const Real sign = x > 0 ? 1 : x < 0 ? -1 : 0;
  if (name == "abs") return composed(a, functions::fabs(x), sign, 0);
  if (name == "sign") return constant(sign);
  throw std::logic_error("no such function: " + name);
}

}  // namespace

Real number_of(const Ast& ast) {
  switch (ast.kind) {
    case AstKind::number: return real(ast.number);
    case AstKind::negate: return -number_of(ast.children[0]);
    case AstKind::reciprocal: return 1 / number_of(ast.children[0]);
    case AstKind::sum: {
      Real sum = 0;
      for (const Ast& child : ast.children) sum += number_of(child);
      return sum;
    }
    default: {
      Real result = 1;
      for (const Ast& child : ast.children) result *= number_of(child);
      return result;
    }
  }
}

Number Motion::operator()(const Ast& ast) {
  switch (ast.kind) {
    case AstKind::number: return constant(real(ast.number));
    case AstKind::symbol: return named(ast.name);
    case AstKind::negate: return -(*this)(ast.children[0]);
    case AstKind::reciprocal: return pow((*this)(ast.children[0]), -1);
    case AstKind::power: return pow((*this)(ast.children[0]), number_of(ast.children[1]));
    case AstKind::call: return call(ast);
    case AstKind::comparison: {
      return constant(gaussgen::model::holds(ast.name, (*this)(ast.children[0]).value, (*this)(ast.children[1]).value));
    }
    default: break;
  }
  Number result = (*this)(ast.children[0]);
  for (std::size_t i = 1; i < ast.children.size(); ++i) {
    const Number next = (*this)(ast.children[i]);
    result = ast.kind == AstKind::sum ? result + next : result * next;
  }
  return result;
}

Vector Motion::operator()(const std::array<Ast, 3>& components) {
  return vector((*this)(components[0]), (*this)(components[1]), (*this)(components[2]));
}

Number Motion::named(const std::string& name) {
  if (const auto found = values_.find(name); found != values_.end()) return found->second;
  const gaussgen::model::SymbolRef ref = model_.resolve(name);
  if (ref.kind == gaussgen::model::SymbolKind::axis) {
    const Matrix all = axes(ref.index / 9);
    const auto row = static_cast<Eigen::Index>(ref.index % 3), column = static_cast<Eigen::Index>(ref.index / 3 % 3);
    return {all.value(row, column), all.rate(row, column), all.second(row, column)};
  }
  if (ref.kind != gaussgen::model::SymbolKind::place) throw std::logic_error("no value of " + name);
  const Vector at = origin(ref.index / 3);
  const auto i = static_cast<Eigen::Index>(ref.index % 3);
  return {at.value[i], at.rate[i], at.second[i]};
}

Number Motion::call(const Ast& ast) {
  if (ast.name == "piecewise") return piecewise(ast);
  const Number first = (*this)(ast.children[0]);
  if (ast.name == "dot") return {first.rate, first.second, k_unknown};
  if (ast.table != nullptr) {
    const auto derivative = [&](int order) {
      return Real(gaussgen::support::value_at(*ast.table, order, static_cast<double>(first.value)));
    };
    return composed(first, derivative(0), derivative(1), derivative(2));
  }
  if (ast.name == "atan2") return atan2(first, (*this)(ast.children[1]));
  if (ast.name != "min" && ast.name != "max") return elementary(ast.name, first);
  Number result = first;
  for (std::size_t i = 1; i < ast.children.size(); ++i) {
    const Number next = (*this)(ast.children[i]);
    const bool is_less = next.value < result.value;
    if (ast.name == "min" ? is_less : result.value < next.value) result = next;
  }
  return result;
}

Number Motion::piecewise(const Ast& ast) {
  for (std::size_t i = 0; i + 1 < ast.children.size(); i += 2) {
    if ((*this)(ast.children[i]).value != 0) return (*this)(ast.children[i + 1]);
  }
  return (*this)(ast.children.back());
}

const Motion::Placed& Motion::placed(std::size_t frame) {
  if (const auto found = placed_.find(frame); found != placed_.end()) return found->second;
  Placed result{{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()}, fixed(Matrix3::Identity())};
  if (frame != k_space) {
    const gaussgen::model::Frame& own = model_.frames[frame];
    const Placed parent = placed(own.parent);
    result = {parent.origin + parent.axes * (*this)(own.position), parent.axes * turned(own.attitude)};
  }
  return placed_.emplace(frame, result).first->second;
}

Matrix Motion::turned(const gaussgen::model::Attitude& attitude) {
  Matrix result = fixed(Matrix3::Identity());
  if (const auto* turns = std::get_if<gaussgen::model::Turns>(&attitude)) {
    for (const gaussgen::model::Turn& one : *turns) result = result * turn(one);
  } else if (const auto* orientation = std::get_if<gaussgen::model::QuaternionOrientation>(&attitude)) {
    result = quaternion(model_.orientations[orientation->index]);
  }
  return result;
}

// R = exp(angle K), whose derivatives are K R and K K R.
Matrix Motion::turn(const gaussgen::model::Turn& turn) {
  Vector3 axis = Vector3::Zero();
  if (const char* letter = std::get_if<char>(&turn.axis)) {
    axis[*letter - 'x'] = 1;
  } else {
    axis = (*this)(std::get<std::array<Ast, 3>>(turn.axis)).value.normalized();
  }
  Matrix3 K;
  K << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  const Number angle = (*this)(turn.angle);
  const Matrix3 R = Eigen::AngleAxis<Real>(angle.value, axis).toRotationMatrix();
  return {R, angle.rate * K * R, angle.second * K * R + angle.rate * angle.rate * K * K * R};
}

Matrix Motion::quaternion(const gaussgen::model::Orientation& orientation) {
  std::array<Number, 4> e{};
  for (std::size_t i = 0; i < 4; ++i) e[i] = named(orientation.quaternion[i].text);
  const Number two = constant(2);
  // Columns are the turned axes.
  const Vector x = vector(e[0] * e[0] + e[1] * e[1] - e[2] * e[2] - e[3] * e[3], two * (e[1] * e[2] + e[0] * e[3]),
                          two * (e[1] * e[3] - e[0] * e[2]));
  const Vector y = vector(two * (e[1] * e[2] - e[0] * e[3]), e[0] * e[0] - e[1] * e[1] + e[2] * e[2] - e[3] * e[3],
                          two * (e[2] * e[3] + e[0] * e[1]));
  const Vector z = vector(two * (e[1] * e[3] + e[0] * e[2]), two * (e[2] * e[3] - e[0] * e[1]),
                          e[0] * e[0] - e[1] * e[1] - e[2] * e[2] + e[3] * e[3]);
  Matrix result;
  result.value << x.value, y.value, z.value;
  result.rate << x.rate, y.rate, z.rate;
  result.second << x.second, y.second, z.second;
  return result;
}

Vector Motion::omega(std::size_t frame) {
  const Matrix R = axes(frame);
  const auto axial = [](const Matrix3& m) -> Vector3 {
    return Vector3(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / 2;
  };
  return {axial(R.rate * R.value.transpose()), axial(R.second * R.value.transpose() + R.rate * R.rate.transpose()),
          Vector3::Constant(k_unknown)};
}

Vector Motion::velocity_at(std::size_t frame, const Vector& place) {
  const Vector at = origin(frame);
  const Vector velocity{at.rate, at.second, Vector3::Constant(k_unknown)};
  return velocity + cross(omega(frame), place - at);
}

}  // namespace agreement::newton
