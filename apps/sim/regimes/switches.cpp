#include "sim/regimes/switches.hpp"

#include <algorithm>

#include "model/evaluate.hpp"

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
  for (const model::Guard& guard : from.guards) result.push_back({guard.name, guard.of.text, guard.kind});
  return result;
}

}  // namespace gausssim
