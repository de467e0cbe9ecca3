#pragma once
// From a scene and options to the setting of a simulation: what `run` and `ensemble` share.

#include "sim/run/build_engine.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/run.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

/// Options have precedence over what the scene says.
void apply(const RunOptions& options, Scene& scene);

EngineChoice engine_choice(const Scene& scene);

/// What no model can change: refused before one is read. Throws cli::UsageError.
void check_method(const Scene& scene);

/// A model with all that its method takes, or those that may be chosen for an error. Nothing: `code`, and why has been said.
std::optional<PreparedModel> prepare_run(const RunOptions& options, int& code);

}  // namespace gausssim
