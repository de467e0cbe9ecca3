#pragma once
// The summary of a run: what a program reads beside the table.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/run/finished_run.hpp"

namespace gausssim {

/// How it went, without the model, the scene, and what a run that goes on needs.
nlohmann::ordered_json how_it_went(const FinishedRun& finished);

/// JSON, as docs/scenes.md describes it.
std::string summary_of(const FinishedRun& finished);

}  // namespace gausssim
