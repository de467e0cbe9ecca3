#pragma once
// The summary of a run: what a program reads beside the table.

#include <string>

#include "sim/run/finished_run.hpp"

namespace gausssim {

/// JSON, as docs/scenes.md describes it.
std::string summary_of(const FinishedRun& finished);

}  // namespace gausssim
