#include "sim/regimes/switches.hpp"

#include <algorithm>
#include <functional>

#include "model/evaluate.hpp"
#include "model/expressions.hpp"

namespace gausssim {

namespace model = gaussgen::model;

Switches switches_of(const model::Model& from) {
  Switches result;
  const model::Values values = model::parameter_values(from);
  for (const model::Contact& contact : from.contacts) {
    const auto restitution = contact.restitution ? model::value_of(*contact.restitution, values) : std::nullopt;
    result.contacts.push_back({contact.name.text, restitution.value_or(0), contact.impulse_unit});
  }
  for (const model::DryFriction& friction : from.frictions)
    result.frictions.push_back({friction.name.text, friction.law.slips.size()});
  for (const model::Constraint& row : from.constraints) {
    const std::string name = model::name_in_file(row);
    if (row.breaks_at && std::find(result.links.begin(), result.links.end(), name) == result.links.end())
      result.links.push_back(name);
  }
  return result;
}

Modes ground_of(const Switches& switches) {
  Modes modes;
  for (const ContactSwitch& contact : switches.contacts) modes[contact.name] = "open";
  for (const FrictionSwitch& friction : switches.frictions) modes[friction.name] = "free";
  for (const std::string& link : switches.links) modes[link] = "holds";
  return modes;
}

std::vector<GuardOf> guards_of(const model::Model& from) {
  std::vector<GuardOf> result;
  const auto row_of = [&](const model::Name& name) {
    const auto row = std::find_if(from.constraints.begin(), from.constraints.end(),
                                  [&](const model::Constraint& one) { return one.name.text == name.text; });
    return static_cast<std::size_t>(row - from.constraints.begin());
  };
  for (const model::Guard& guard : from.guards) {
    GuardOf one{guard.name, guard.of.text, guard.kind, {}, guard.limit.has_value(), false};
    for (const model::Name& row : guard.rows) one.rows.push_back(row_of(row));
    one.is_brittle = !one.rows.empty() && from.constraints[one.rows.front()].breaks_at.has_value();
    result.push_back(std::move(one));
  }
  return result;
}

std::vector<char> reactions_in_forces(const model::Model& from) {
  std::vector<char> result(from.constraints.size(), 0);
  const auto mark = [&](const model::NamedReaction& reaction) {
    for (std::size_t row = 0; row < result.size(); ++row) {
      // That of a held coordinate is made of those of all constraints.
      if (reaction.is_held || from.constraints[row].name.text == reaction.of) result[row] = 1;
    }
  };
  const std::function<void(const model::Ast&)> look = [&](const model::Ast& ast) {
    for (const model::Ast& child : ast.children) look(child);
    if (ast.kind != model::AstKind::symbol) return;
    const auto known = from.symbols.find(ast.name);
    if (known != from.symbols.end() && known->second.kind == model::SymbolKind::reaction)
      mark(from.reactions[known->second.index]);
  };
  for (const model::Force& force : from.forces) model::for_each_expression_of(force, look);
  return result;
}

}  // namespace gausssim
