#pragma once
// From a scene and options to the setting of a simulation: what `run`, `advise` and `ensemble` share.

#include "sim/run/among_instances.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/run.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

EngineChoice engine_choice(const Scene& scene);

/// Options have precedence over what the scene says; requests what the method takes. What no model can change is refused before one is read: throws
/// cli::UsageError.
void apply(const RunOptions& options, Scene& scene, Request& request);

/// A model with all that its method takes, or those that may be chosen for an error. Nothing: `code`, and why has been said. `text`: of the file, where it has
/// been read.
std::optional<PreparedModel> prepare_run(const RunOptions& options, int& code,
                                         std::optional<gaussgen::support::Source> text = std::nullopt);

/// Likewise one of several instances.
std::optional<PreparedModel> prepare_instance(const RunOptions& options, const std::string& instance,
                                              const gaussgen::support::Source& text, AmongInstances& among, int& code);

/// One of the scene's `formulations`, of which nothing is said. Nothing: it cannot be derived.
std::optional<PreparedModel> prepare_form(const RunOptions& options, const std::string& form);

}  // namespace gausssim
