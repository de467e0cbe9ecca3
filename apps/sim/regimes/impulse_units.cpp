#include "sim/regimes/impulse_units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gausssim {

namespace {

bool has_several_units(const Switches& switches) {
  const auto& contacts = switches.contacts;
  return std::any_of(contacts.begin(), contacts.end(), [&](const ContactSwitch& contact) {
    return contact.impulse_unit != contacts.front().impulse_unit;
  });
}

/// "floor hits" is of the contact floor. What has no impulse has no unit.
std::string unit_of(const Event& event, const Switches& switches) {
  const std::string name = event.what.substr(0, event.what.find(' '));
  for (const ContactSwitch& contact : switches.contacts) {
    if (contact.name == name && event.impulse != 0) return contact.impulse_unit;
  }
  return "";
}

}  // namespace

std::string head_of_impulses(const Switches& switches) {
  if (has_several_units(switches)) return "impulse,unit";
  const std::string unit = switches.contacts.empty() ? "" : switches.contacts.front().impulse_unit;
  return unit.empty() ? "impulse" : fmt::format("impulse [{}]", unit);
}

std::string cell_of_impulse(const Event& event, const Switches& switches) {
  const std::string number = fmt::format("{}", event.impulse);
  return has_several_units(switches) ? number + "," + unit_of(event, switches) : number;
}

}  // namespace gausssim
