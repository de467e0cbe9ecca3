#include "kinematics/relative_places.hpp"

#include <algorithm>
#include <vector>

#include "ir/contract.hpp"
#include "ir/substitute.hpp"
#include "ir/traverse.hpp"
#include "kinematics/expressions.hpp"
#include "kinematics/place_symbols.hpp"
#include "model/constant.hpp"
#include "model/functions.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using model::Ast;
using model::AstKind;
using model::k_space;
using support::Rational;

namespace {

/// A motion of everything at once: r becomes turn r + shift, dr/dt turn dr/dt + ω × turn r + velocity.
struct RigidMotion {
  Matrix3 turn;
  Vector3 omega, shift, velocity;
};

Vector3 vector_of(ir::Graph& graph, const std::array<Rational, 3>& components) {
  Vector3 result = ir::zero3(graph);
  for (std::size_t i = 0; i < 3; ++i) result[i] = Expr(graph, graph.constant(components[i]));
  return result;
}

/// By a quaternion of rational length: its angle is no rational part of a turn, so that its powers come near to all turns about its axis.
Matrix3 turn_by(ir::Graph& graph, const std::array<int, 4>& quaternion, int length) {
  std::array<Expr, 4> e{Expr(graph, graph.constant(0)), Expr(graph, graph.constant(0)), Expr(graph, graph.constant(0)),
                        Expr(graph, graph.constant(0))};
  for (std::size_t i = 0; i < 4; ++i) e[i] = Expr(graph, graph.constant(Rational(quaternion[i]) / length));
  return quaternion_matrix(e);
}

/// Rationals without a pattern that a model could have, the same in every run.
class Numbers {
 public:
  Rational operator()() {
    state_ = (state_ * 1103515245U + 12345U) % 2147483648U;
    return Rational(static_cast<int>(state_ / 65536U) - 16384) / 4093;
  }
  Vector3 vector(ir::Graph& graph) {
    std::array<Rational, 3> components;
    for (Rational& component : components) component = (*this)();
    return vector_of(graph, components);
  }

 private:
  std::uint32_t state_ = 20177;
};

void put(const PlaceSymbols::Vector& symbols, const Vector3& at, const Vector3& rate, ir::Substitution& into) {
  for (std::size_t i = 0; i < 3; ++i) {
    into.replace(symbols[i].place, at[i]);
    into.replace(symbols[i].rate, rate[i]);
  }
}

std::vector<std::size_t> carriers_of(const model::Model& model, std::size_t frame) {
  std::vector<std::size_t> result;
  for (; frame != k_space; frame = model.frames[frame].parent) result.push_back(frame);
  return result;
}

bool is_whole(const Ast& exponent) {
  const auto value = model::exact_value(exponent);
  return value && support::is_integer(*value);
}

}  // namespace

void RelativePlaces::collect(const Ast& ast, std::set<std::size_t>& frames) const {
  if (ast.kind == AstKind::symbol) {
    const model::SymbolRef ref = model_.resolve(ast.name);
    if (ref.kind == model::SymbolKind::place) frames.insert(ref.index / 3);
    if (ref.kind == model::SymbolKind::axis) frames.insert(ref.index / 9);
  }
  for (const Ast& child : ast.children) collect(child, frames);
}

bool RelativePlaces::has_places(const Ast& ast) const {
  std::set<std::size_t> frames;
  collect(ast, frames);
  return !frames.empty();
}

bool RelativePlaces::has_spins(const Ast& ast) const {
  if (ast.kind == AstKind::symbol) return model_.resolve(ast.name).kind == model::SymbolKind::spin;
  return std::any_of(ast.children.begin(), ast.children.end(), [this](const Ast& child) { return has_spins(child); });
}

std::size_t RelativePlaces::common_carrier(const std::set<std::size_t>& frames) const {
  std::vector<std::size_t> common = carriers_of(model_, *frames.begin());
  for (const std::size_t frame : frames) {
    const std::vector<std::size_t> others = carriers_of(model_, frame);
    const auto is_other = [&](std::size_t at) { return std::find(others.begin(), others.end(), at) != others.end(); };
    common.erase(common.begin(), std::find_if(common.begin(), common.end(), is_other));
  }
  return common.empty() ? k_space : common.front();
}

std::size_t RelativePlaces::moving_carrier(const std::set<std::size_t>& frames) const {
  const std::size_t frame = common_carrier(frames);
  return frame != k_space && moves(frame) ? frame : k_space;
}

bool RelativePlaces::moves(std::size_t frame) const {
  Frames& frames = expressions_.frames();
  const auto is_fixed = [](const Vector3& v) {
    return std::all_of(v.begin(), v.end(), [](Expr e) { return ir::is_of_parameters(e.graph(), e.id()); });
  };
  const Matrix3 axes = frames.axes(frame);
  return !is_fixed(frames.origin(frame)) || !std::all_of(axes.begin(), axes.end(), is_fixed);
}

RelativePlaces::Turning RelativePlaces::turning(std::size_t frame) const {
  const Matrix3 axes = expressions_.frames().axes(frame);
  if (axes == ir::identity3(expressions_.graph())) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 unit = ir::unit_vector(expressions_.graph(), k);
    if (axes[k] == unit && ir::column(axes, k) == unit) return {true, k};
  }
  return {true, {}};
}

// Of what is not one analytic function everywhere, such as a table or a root of a square, a test by numbers sees the part in which the numbers are.
// Arguments are formed from their own carriers all the same.
bool RelativePlaces::has_cases(const Ast& ast) const {
  static const std::set<std::string> k_analytic{model::k_dot, "sin",  "cos",  "tan", "atan",
                                                "exp",        "sinh", "cosh", "tanh"};
  const bool is_other = ast.kind == AstKind::call && k_analytic.count(ast.name) == 0;
  const bool is_root = ast.kind == AstKind::power && !is_whole(ast.children[1]);
  if (ast.kind == AstKind::comparison || is_other || is_root) return has_places(ast);
  return std::any_of(ast.children.begin(), ast.children.end(), [this](const Ast& child) { return has_cases(child); });
}

std::optional<std::size_t> RelativePlaces::carrier(const Ast& ast) {
  std::set<std::size_t> frames;
  collect(ast, frames);
  if (frames.empty() || has_spins(ast)) return std::nullopt;
  const std::size_t frame = moving_carrier(frames);
  if (frame == k_space || has_cases(ast) || !is_the_same_from(frame, ast)) return std::nullopt;
  return frame;
}

// Exactly, at places and rates that are any numbers: what two turns about different axes by angles that are no part of a whole turn leave
// as it is, all turns do.
bool RelativePlaces::is_the_same_from(std::size_t frame, const Ast& ast) const {
  ir::Graph& graph = expressions_.graph();
  PlaceSymbols symbols(graph, true);
  expressions_.watch(&symbols);
  const Expr value = expressions_(ast);
  expressions_.watch(nullptr);
  const Turning turning = this->turning(frame);
  std::vector<Matrix3> turns;
  if (!turning.is_any) {
    turns = {ir::identity3(graph)};
  } else if (turning.axis) {
    std::array<int, 4> quaternion{3, 0, 0, 0};
    quaternion[*turning.axis + 1] = 4;
    turns = {turn_by(graph, quaternion, 5)};
  } else {
    turns = {turn_by(graph, {1, 2, 2, 4}, 5), turn_by(graph, {6, 2, 5, 4}, 9)};
  }
  Numbers numbers;
  for (const Matrix3& turn : turns) {
    Vector3 omega = numbers.vector(graph);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!turning.is_any || (turning.axis && k != *turning.axis)) omega[k] = Expr(graph, graph.constant(0));
    }
    const RigidMotion motion{turn, omega, numbers.vector(graph), numbers.vector(graph)};
    ir::Substitution before(graph), after(graph);
    const auto put_in = [&](const PlaceSymbols::Vector& vector, bool is_place) {
      const Vector3 at = numbers.vector(graph), rate = numbers.vector(graph);
      put(vector, at, rate, before);
      const Vector3 turned = ir::multiply(motion.turn, at);
      const Vector3 turning_rate = ir::multiply(motion.turn, rate) + cross(motion.omega, turned);
      put(vector, is_place ? turned + motion.shift : turned, is_place ? turning_rate + motion.velocity : turning_rate,
          after);
    };
    for (const auto& [index, vector] : symbols.all()) put_in(vector, true);
    for (const auto& [index, vector] : symbols.all_axes()) put_in(vector, false);
    if (!(before(value) == after(value))) return false;
  }
  return true;
}

}  // namespace gaussgen::kinematics
