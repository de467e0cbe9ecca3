#pragma once
// Values that no model can have, found before anything is simulated.

#include "model/model.hpp"
#include "sim/ensemble/plan.hpp"
#include "sim/ensemble/vary.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Reports what is wrong with the parameters and bodies of the first trajectory that cannot be, and how many more there are. `model` is as `vary` left it.
void check_draws(const Ensemble& ensemble, const std::vector<Placed>& places, const gaussgen::model::Model& model,
                 gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
