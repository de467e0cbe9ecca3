#pragma once
// What the second descriptions of models are made with.

#include "gauss/oracle/bare_models.hpp"

namespace gaussgen::oracle {

/// Random parameters and state; `free` names the coordinates of the bare system, an angular velocity for a rotation.
Case start(const model::Model& model, unsigned seed, const std::vector<std::string>& free);

/// Adds a held coordinate with its rate and acceleration.
void hold(BareSystem& bare, const std::function<Real(const Real& t)>& c);

// Models that no file has; all features meet in them.
Case driven_gyroscope(unsigned seed);
Case free_body(unsigned seed, bool in_space);
Case coupled_drives(unsigned seed);
Case released_top(unsigned seed);

}  // namespace gaussgen::oracle
