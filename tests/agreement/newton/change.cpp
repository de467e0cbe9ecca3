#include "newton/change.hpp"

#include <algorithm>

namespace agreement::newton {

using gaussgen::model::Ast;
using gaussgen::model::AstKind;
using gaussgen::model::GeneralizedForce;
using gaussgen::model::Model;
using gaussgen::support::Rational;

namespace {

Ast thousandths(int n) {
  Ast ast;
  ast.number = Rational(n) / Rational(1000);
  return ast;
}

Ast named(const std::string& name) {
  Ast ast;
  ast.kind = AstKind::symbol;
  ast.name = name;
  return ast;
}

Ast many(AstKind kind, std::vector<Ast> children, const std::string& name = "") {
  Ast ast;
  ast.kind = kind;
  ast.name = name;
  ast.children = std::move(children);
  return ast;
}

Ast times(Ast a, Ast b) { return many(AstKind::product, {std::move(a), std::move(b)}); }
Ast negated(Ast a) { return many(AstKind::negate, {std::move(a)}); }

/// The law of a spring along a coordinate, written out.
GeneralizedForce written_out(const gaussgen::model::CoordinateSpring& law) {
  const Ast y = named(law.coordinate.text);
  const Ast stretch = law.rest ? many(AstKind::sum, {y, negated(*law.rest)}) : y;
  Ast force = negated(times(law.stiffness, stretch));
  if (law.damping)
    force = many(AstKind::sum, {force, negated(times(*law.damping, many(AstKind::call, {stretch}, "dot")))});
  return {{{law.coordinate, force}}};
}

}  // namespace

Change::Change(const Model& model, Kind kind, unsigned seed) {
  std::mt19937 random(seed);
  const auto within = [&](int most) { return std::uniform_int_distribution<int>(-most, most)(random); };
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (model.coordinates[i].held_at) continue;
    rows_.push_back({i, model.coordinates[i].speed.has_value(), {}, 0, 0, 0, 0});
    names_.push_back(model.coordinates[i].name.text);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const bool is_mixed = kind == Kind::affine && rows_[j].has_speed == rows_[i].has_speed;
      // Dominant on the diagonal: so it has an inverse.
      const int most = 600 / static_cast<int>(rows_.size());
      rows_[i].factors.push_back(i == j ? 1000 : is_mixed ? within(most) : 0);
      // Later ones only: so it has an inverse, step by step.
      if (j > i && rows_[j].has_speed == rows_[i].has_speed) others.push_back(j);
    }
    rows_[i].shift = kind == Kind::affine ? within(300) : 0;
    if (kind == Kind::affine) continue;
    rows_[i].drift = within(200);
    if (others.empty()) continue;
    rows_[i].bend = within(400);
    rows_[i].bent_by = others[random() % others.size()];
  }
}

Ast Change::symbol(std::size_t row) const { return named(names_[row]); }

Ast Change::expression(const Row& row) const {
  std::vector<Ast> terms{thousandths(row.shift), times(thousandths(row.drift), named("t"))};
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    if (row.factors[j] != 0) terms.push_back(times(thousandths(row.factors[j]), symbol(j)));
  }
  if (row.bend != 0) terms.push_back(times(thousandths(row.bend), many(AstKind::call, {symbol(row.bent_by)}, "sin")));
  return many(AstKind::sum, std::move(terms));
}

Ast Change::derivative(const Row& row, std::size_t by) const {
  if (row.bend == 0 || row.bent_by != by) return thousandths(row.factors[by]);
  return times(thousandths(row.bend), many(AstKind::call, {symbol(by)}, "cos"));
}

void Change::rewrite(Ast& ast) const {
  if (ast.kind == AstKind::symbol) {
    const auto found = std::find(names_.begin(), names_.end(), ast.name);
    if (found != names_.end()) ast = expression(rows_[static_cast<std::size_t>(found - names_.begin())]);
    return;
  }
  for (Ast& child : ast.children) rewrite(child);
}

void Change::rewrite(std::array<Ast, 3>& vector) const {
  for (Ast& component : vector) rewrite(component);
}

void Change::rewrite(gaussgen::model::Constraint& constraint) const {
  if (constraint.point) rewrite(*constraint.point);
  if (auto* velocity = std::get_if<gaussgen::model::VelocityLaw>(&constraint.law)) {
    rewrite(velocity->phi);
  } else if (auto* position = std::get_if<gaussgen::model::PositionLaw>(&constraint.law)) {
    rewrite(position->f);
    if (position->phi) rewrite(*position->phi);
  } else if (auto* at = std::get_if<std::array<Ast, 3>>(&std::get<gaussgen::model::SlipLaw>(constraint.law).at)) {
    rewrite(*at);
  }
}

void Change::rewrite(gaussgen::model::Force& force) const {
  if (const auto* spring = std::get_if<gaussgen::model::CoordinateSpring>(&force.law)) {
    const GeneralizedForce law = written_out(*spring);
    force.law = law;
  }
  if (auto* potential = std::get_if<gaussgen::model::Potential>(&force.law)) {
    rewrite(potential->energy);
  } else if (auto* generalized = std::get_if<GeneralizedForce>(&force.law)) {
    for (auto& component : generalized->components) rewrite(component.second);
    const GeneralizedForce law = spread(*generalized);
    force.law = law;
  } else if (auto* point = std::get_if<gaussgen::model::PointForce>(&force.law)) {
    rewrite(point->components);
  } else if (auto* torque = std::get_if<gaussgen::model::Torque>(&force.law)) {
    rewrite(torque->components);
  }
}

// Q_p = Q_x ∂x/∂p
GeneralizedForce Change::spread(const GeneralizedForce& law) const {
  GeneralizedForce result;
  for (const auto& [name, value] : law.components) {
    const auto found = std::find(names_.begin(), names_.end(), name.text);
    if (found == names_.end()) {
      result.components.emplace_back(name, value);
      continue;
    }
    const Row& row = rows_[static_cast<std::size_t>(found - names_.begin())];
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      if (row.factors[j] == 0 && (row.bend == 0 || row.bent_by != j)) continue;
      result.components.emplace_back(gaussgen::model::Name{names_[j], {}}, times(value, derivative(row, j)));
    }
  }
  return result;
}

Model Change::of(Model model) const {
  for (auto& speed : model.speeds) rewrite(speed.is);
  for (auto& frame : model.frames) {
    rewrite(frame.position);
    auto* turns = std::get_if<gaussgen::model::Turns>(&frame.attitude);
    if (turns == nullptr) continue;
    for (auto& turn : *turns) rewrite(turn.angle);
  }
  for (auto& constraint : model.constraints) rewrite(constraint);
  for (auto& force : model.forces) rewrite(force);
  model.quantities.clear();
  model.dependent.clear();
  return model;
}

State Change::old_state(const State& state) const {
  State old = state;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    double x = row.shift + row.drift * state.time;
    double rate = row.drift;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      x += row.factors[j] * state.configuration[j];
      rate += row.factors[j] * state.speeds[j];
    }
    if (row.bend != 0) {
      x += row.bend * std::sin(state.configuration[row.bent_by]);
      rate += row.bend * std::cos(state.configuration[row.bent_by]) * state.speeds[row.bent_by];
    }
    old.configuration[i] = x / 1000;
    if (!row.has_speed) old.speeds[i] = rate / 1000;
  }
  return old;
}

}  // namespace agreement::newton
