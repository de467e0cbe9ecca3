#pragma once
// Regimes: which mode each switch of a model is in (docs/regimes.md). Private to the folder.

#include <string>
#include <vector>

#include "model/reading.hpp"

namespace gaussgen::model {

/// That of the regime that is read, of those which it may have; the first one where nobody chooses.
Mode mode_of(const std::string& name, const std::vector<Mode>& modes, Reading& reading);

/// Modes that are chosen of what the model does not have: throws WrongRegime.
void check_regime(const Reading& reading);

/// Of an open contact, nothing is left.
bool is_reaction_of_open_contact(const std::string& symbol, const Model& model);

/// What friction makes of itself in its mode: a force, or rows that hold as long as it sticks.
void take_friction(DryFriction friction, Force force, Reading& reading);

/// What ends the regime; after all that has modes.
void make_guards(Reading& reading);

}  // namespace gaussgen::model
