#include "kinematics/expressions.hpp"

#include <map>

#include "ir/removable.hpp"
#include "ir/substitute.hpp"
#include "kinematics/place_symbols.hpp"
#include "kinematics/slip.hpp"
#include "kinematics/solve_sparse.hpp"
#include "model/functions.hpp"
#include "support/assert.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Function;
using model::Ast;
using model::AstKind;
using support::Rational;

Expressions::Expressions(const model::Model& model, const Symbols& symbols, ir::Graph& graph, bool fold, bool limits)
    : model_(model),
      symbols_(symbols),
      graph_(graph),
      fold_(fold),
      limits_(limits),
      time_derivative_(graph),
      carried_derivative_(graph),
      frames_(model, symbols, *this),
      relative_places_(model, *this) {
  seed_rates();
}

Frames& Expressions::frames_from(std::size_t base) {
  if (base == model::k_space) return frames_;
  std::unique_ptr<Frames>& known = frames_from_[base];
  if (!known) known = std::make_unique<Frames>(model_, symbols_, *this, base);
  return *known;
}

void Expressions::seed_what_speeds_leave(ir::Directional& derivative) {
  for (const HeldCoordinate& held : symbols_.held) derivative.seed(held.symbol, symbol(held.rate));
  for (std::size_t i = 0; i < model_.orientations.size(); ++i) {
    const std::array<Expr, 4> rates = quaternion_rates(i);
    for (std::size_t k = 0; k < rates.size(); ++k) {
      const ConfigurationIndex e{symbols_.first_quaternion_component[i].value + k};
      derivative.seed(symbols_.configuration[e].symbol, rates[k]);
    }
  }
  derivative.seed(symbols_.time, number(1));
}

// u = Y q̇ + Z, so q̇ = Y⁻¹ (u - Z), for the coordinates whose rates are in the definitions of the speeds.
std::vector<Expr> Expressions::rates_from_speeds() {
  std::vector<ir::SymbolId> rates;
  std::vector<Expr> u;
  defining_.emplace(graph_);
  for (std::size_t i = 0; i < model_.coordinates.size(); ++i) {
    const model::Coordinate& coordinate = model_.coordinates[i];
    const Symbols::Place& place = symbols_.coordinates[i];
    if (coordinate.speed) {
      rates.push_back(graph_.declare(ir::SymbolClass::speed, coordinate.name.text + "_dot"));
      u.push_back(symbol(symbols_.speeds[FreeIndex{place.index}].symbol));
      defining_->seed(symbols_.configuration[ConfigurationIndex{place.index}].symbol, symbol(rates.back()));
    }
  }
  seed_what_speeds_leave(*defining_);
  ir::Substitution at_rest(graph_);
  for (const ir::SymbolId rate : rates) at_rest.replace(rate, number(0));
  ir::Substitution unturned(graph_);
  for (const FreeIndex first : symbols_.first_angular_velocity) {
    for (std::size_t i = 0; i < 3; ++i) unturned.replace(symbols_.speeds[FreeIndex{first.value + i}].symbol, number(0));
  }
  for (std::size_t i = 0; i < model_.speeds.size(); ++i) {
    const Expr is = (*this)(model_.speeds[i].is);
    speed_matrix_.emplace_back();
    for (const ir::SymbolId rate : rates) speed_matrix_.back().push_back(ir::partial(is, rate));
    u[i] = u[i] - at_rest(is);
    speeds_at_rest_.push_back(unturned(at_rest(is)));
  }
  defining_.reset();
  for (const auto& row : speed_matrix_) {
    for (const Expr entry : row) has_rates_ = has_rates_ && at_rest(entry).id() == entry.id();
  }
  auto solution = has_rates_ ? solve_sparse(speed_matrix_, u, LargeBlocks::refuse) : std::nullopt;
  has_rates_ = solution.has_value();
  return solution.value_or(u);
}

void Expressions::seed_rates() {
  const std::vector<Expr> from_speeds = model_.speeds.empty() ? std::vector<Expr>() : rates_from_speeds();
  std::size_t next = 0;
  for (std::size_t i = 0; i < symbols_.coordinates.size(); ++i) {
    const Symbols::Place& place = symbols_.coordinates[i];
    if (place.is_held) continue;
    const bool is_replaced = model_.coordinates[i].speed.has_value();
    configuration_rates_.push_back(is_replaced ? from_speeds[next++]
                                               : symbol(symbols_.speeds[FreeIndex{place.index}].symbol));
  }
  for (std::size_t i = 0; i < model_.orientations.size(); ++i) {
    for (const Expr rate : quaternion_rates(i)) configuration_rates_.push_back(rate);
  }
  for (const ConfigurationIndex i : configuration_rates_.indices()) {
    time_derivative_.seed(symbols_.configuration[i].symbol, configuration_rates_[i]);
    carried_derivative_.seed(symbols_.configuration[i].symbol, configuration_rates_[i]);
  }
  seed_what_speeds_leave(time_derivative_);
  seed_what_speeds_leave(carried_derivative_);
}

// ė = ½ (0, ω) ∘ e with ω in space, ė = ½ e ∘ (0, ω) with ω in the body (Wittenburg, Dynamics of Multibody Systems, 2.2).
std::array<Expr, 4> Expressions::quaternion_rates(std::size_t orientation) {
  const ConfigurationIndex first = symbols_.first_quaternion_component[orientation];
  const auto e = [&](std::size_t i) {
    return symbol(symbols_.configuration[ConfigurationIndex{first.value + i}].symbol);
  };
  const auto u = [&](std::size_t i) {
    return symbol(symbols_.speeds[FreeIndex{symbols_.first_angular_velocity[orientation].value + i}].symbol);
  };
  const ir::Vector3 vector{e(1), e(2), e(3)};
  const ir::Vector3 omega{u(0), u(1), u(2)};
  const Rational half = Rational(1) / 2;
  const Expr scalar = -half * (vector[0] * omega[0] + vector[1] * omega[1] + vector[2] * omega[2]);
  const bool in_space = model_.orientations[orientation].axes == model::Axes::space;
  const ir::Vector3 turn = in_space ? cross(omega, vector) : cross(vector, omega);
  const auto component = [&](std::size_t i) { return half * (e(0) * omega[i] + turn[i]); };
  return {scalar, component(0), component(1), component(2)};
}

Expr Expressions::operator()(const Ast& ast) {
  if (looks_for_carriers_) return formed_from_carriers(ast);
  const bool is_in_space = watched_ == nullptr && seen_ == &frames_;
  if (!is_in_space || !relative_places_.has_places(ast)) return formed(ast);
  looks_for_carriers_ = true;
  const Expr result = formed_from_carriers(ast);
  looks_for_carriers_ = false;
  return result;
}

Expr Expressions::formed_from_carriers(const Ast& ast) {
  looks_for_carriers_ = false;
  const std::optional<std::size_t> carrier = relative_places_.carrier(ast);
  if (carrier) seen_ = &frames_from(*carrier);
  looks_for_carriers_ = !carrier;
  const Expr result = formed(ast);
  seen_ = &frames_;
  looks_for_carriers_ = true;
  return result;
}

Expr Expressions::formed(const Ast& ast) {
  std::vector<Expr> children;
  // A power takes its exponent as a number, and a call its arguments by itself.
  if (ast.kind != AstKind::power && ast.kind != AstKind::call) {
    for (const Ast& child : ast.children) children.push_back((*this)(child));
  }
  switch (ast.kind) {
    case AstKind::number: return number(ast.number);
    case AstKind::symbol: return resolved(ast.name);
    case AstKind::negate: return -children[0];
    case AstKind::reciprocal: return ir::pow(children[0], -1);
    case AstKind::power: return ir::pow((*this)(ast.children[0]), constant_value(ast.children[1]));
    case AstKind::call: return call(ast);
    case AstKind::comparison: {
      // a > b is b < a
      const bool is_mirrored = ast.name[0] == '>';
      const Expr a = children[is_mirrored ? 1 : 0], b = children[is_mirrored ? 0 : 1];
      return ast.name.size() == 1 ? ir::less(a, b) : ir::at_most(a, b);
    }
    case AstKind::sum:
    case AstKind::product: {
      std::vector<ir::NodeId> ids;
      for (const Expr& child : children) ids.push_back(child.id());
      if (ast.kind == AstKind::sum) return {graph_, graph_.sum(ids)};
      const Expr product(graph_, graph_.product_in_groups(ids, "factors"));
      return limits_ ? ir::without_removable_pole(product, symbol(symbols_.epsilon)) : product;
    }
  }
  return number(0);
}

ir::Vector3 Expressions::operator()(const std::array<Ast, 3>& vector) {
  return {(*this)(vector[0]), (*this)(vector[1]), (*this)(vector[2])};
}

// Once for each parameter: formulas may use each other many times over.
Expr Expressions::folded(std::size_t parameter) {
  if (const auto known = folded_.find(parameter); known != folded_.end()) return known->second;
  const Expr value = (*this)(model_.parameters[parameter].value);
  folded_.emplace(parameter, value);
  return value;
}

Expr Expressions::resolved(const std::string& name) {
  const model::SymbolRef ref = model_.resolve(name);
  switch (ref.kind) {
    case model::SymbolKind::time: return symbol(symbols_.time);
    case model::SymbolKind::pi: return symbol(symbols_.pi);
    case model::SymbolKind::parameter: return fold_ ? folded(ref.index) : symbol(symbols_.parameters[ref.index]);
    case model::SymbolKind::input: return symbol(symbols_.inputs[ref.index]);
    case model::SymbolKind::coordinate: {
      const Symbols::Place& place = symbols_.coordinates[ref.index];
      return symbol(place.is_held ? symbols_.held[HeldIndex{place.index}].symbol
                                  : symbols_.configuration[ConfigurationIndex{place.index}].symbol);
    }
    case model::SymbolKind::quaternion_component: {
      const ConfigurationIndex first = symbols_.first_quaternion_component[ref.index / 4];
      return symbol(symbols_.configuration[ConfigurationIndex{first.value + ref.index % 4}].symbol);
    }
    case model::SymbolKind::angular_velocity: {
      const FreeIndex first = symbols_.first_angular_velocity[ref.index / 3];
      return symbol(symbols_.speeds[FreeIndex{first.value + ref.index % 3}].symbol);
    }
    case model::SymbolKind::speed: {
      const Symbols::Place& place = symbols_.coordinates[model_.coordinate_of_speed(ref.index)];
      return symbol(symbols_.speeds[FreeIndex{place.index}].symbol);
    }
    case model::SymbolKind::place: return place(ref.index / 3, ref.index % 3);
    case model::SymbolKind::spin: return frames_.omega(ref.index / 3, model::Axes::space)[ref.index % 3];
    case model::SymbolKind::axis: return axis(ref.index);
    case model::SymbolKind::slip: return slip(ref.index / 2, ref.index % 2);
    case model::SymbolKind::reaction:
      if (shows_reactions_) return symbol(symbols_.reactions[ref.index]);
      if (model_.reactions[ref.index].is_absent) return number(0);
      return reactions_.empty() ? symbol(symbols_.reactions[ref.index]) : reactions_[ref.index];
  }
  return number(0);
}

Expr Expressions::slip(std::size_t friction, std::size_t direction) {
  const auto& law = model_.frictions[friction].law.slips[direction];
  if (const auto* along = std::get_if<model::VelocityLaw>(&law)) return (*this)(along->phi);
  const auto& contact = std::get<model::SlipLaw>(law);
  return kinematics::slip(*this, contact, contact_line(*this, contact));
}

// 9 frame + 3 axis + component
Expr Expressions::axis(std::size_t index) {
  if (watched_ == nullptr || !watched_->has_axes()) return seen_->axes(index / 9)[index % 3][index / 3 % 3];
  const PlaceSymbols::Component& symbols = watched_->of_axis(index / 3)[index % 3];
  return watched(symbols);
}

Expr Expressions::place(std::size_t frame, std::size_t component) {
  if (watched_ == nullptr) {
    if (carries_velocities_) seen_->carry_velocities(frame, carried_derivative_);
    return seen_->origin(frame)[component];
  }
  const PlaceSymbols::Component& symbols = watched_->of(frame)[component];
  return watched(symbols);
}

Expr Expressions::watched(const PlaceSymbols::Component& component) {
  for (ir::Directional* derivative : {&time_derivative_, &carried_derivative_})
    derivative->seed(component.place, symbol(component.rate));
  return symbol(component.place);
}

Expr Expressions::call(const Ast& ast) {
  if (ast.name == "dot") return rate((*this)(ast.children[0]));
  if (ast.name == "sqrt") return ir::pow((*this)(ast.children[0]), Rational(1) / 2);
  if (ast.name == model::k_piecewise) return cases(ast);
  std::vector<ir::NodeId> arguments;
  for (const Ast& child : ast.children) arguments.push_back((*this)(child).id());
  if (ast.table != nullptr) return {graph_, graph_.look_up(symbols_.tables.at(ast.name), 0, arguments[0])};
  static const std::map<std::string, Function> k_functions{
      {"sin", Function::sin},   {"cos", Function::cos},   {"tan", Function::tan},     {"asin", Function::asin},
      {"acos", Function::acos}, {"atan", Function::atan}, {"atan2", Function::atan2}, {"exp", Function::exp},
      {"log", Function::log},   {"sinh", Function::sinh}, {"cosh", Function::cosh},   {"tanh", Function::tanh},
      {"abs", Function::abs},   {"sign", Function::sign}, {"min", Function::min},     {"max", Function::max}};
  const auto found = k_functions.find(ast.name);
  GAUSS_ASSERT(found != k_functions.end(), "function={}", ast.name);
  const bool is_extreme = ast.name == "min" || ast.name == "max";
  if (!is_extreme) return {graph_, graph_.call(found->second, arguments)};
  ir::NodeId result = arguments[0];
  for (std::size_t i = 1; i < arguments.size(); ++i) result = graph_.call(found->second, {result, arguments[i]});
  return {graph_, result};
}

Expr Expressions::cases(const Ast& piecewise) {
  const std::vector<Ast>& children = piecewise.children;
  Expr result = (*this)(children.back());
  for (std::size_t i = children.size() - 1; i >= 2; i -= 2) {
    const Expr condition = (*this)(children[i - 2]);
    const Expr value = (*this)(children[i - 1]);
    result = {graph_, graph_.call(Function::piecewise, {condition.id(), value.id(), result.id()})};
  }
  return result;
}

Rational constant_value(const Ast& ast) {
  switch (ast.kind) {
    case AstKind::number: return ast.number;
    case AstKind::negate: return -constant_value(ast.children[0]);
    case AstKind::reciprocal: return 1 / constant_value(ast.children[0]);
    case AstKind::sum: {
      Rational sum = 0;
      for (const Ast& child : ast.children) sum = sum + constant_value(child);
      return sum;
    }
    case AstKind::product: {
      Rational product = 1;
      for (const Ast& child : ast.children) product = product * constant_value(child);
      return product;
    }
    default: GAUSS_ASSERT(false, "not a constant: {}", ast.name); return 0;
  }
}

}  // namespace gaussgen::kinematics
