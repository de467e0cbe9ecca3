#pragma once
// What changes its mode during a motion: contacts, dry friction, links that break. docs/regimes.md.

#include <string>
#include <vector>

#include "model/choices.hpp"
#include "model/model.hpp"

namespace gausssim {

/// By name, as the generator reads it.
using Modes = gaussgen::model::GivenRegime;

struct ContactSwitch {
  std::string name;
  double restitution = 0;
  std::string impulse_unit = {};  ///< empty where the model states no units
};

struct FrictionSwitch {
  std::string name;
  std::size_t slips = 1;

  /// While it sticks or slides.
  const char* sliding(bool backwards) const { return slips > 1 ? "slides" : backwards ? "backwards" : "forwards"; }
};

struct Switches {
  std::vector<ContactSwitch> contacts;
  std::vector<FrictionSwitch> frictions;
  std::vector<std::string> links;

  bool any() const { return !contacts.empty() || !frictions.empty() || !links.empty(); }
};

/// Of a model as it was read, with its parameters.
Switches switches_of(const gaussgen::model::Model& model);

/// All contacts are open, no friction acts, and what may break holds.
Modes ground_of(const Switches& switches);

/// A function in the emitted struct Guards, in its order.
struct GuardOf {
  std::string name, of;
  gaussgen::model::Guard::Kind kind = gaussgen::model::Guard::Kind::falls;
  std::vector<std::size_t> rows = {};  ///< constraints of the model whose reactions it judges
  bool has_limit = false, is_brittle = false;
};

std::vector<GuardOf> guards_of(const gaussgen::model::Model& model);

/// Of each constraint: whether a force contains its reaction.
std::vector<char> reactions_in_forces(const gaussgen::model::Model& model);

}  // namespace gausssim
