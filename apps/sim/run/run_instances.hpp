#pragma once
// `gauss-sim run` of a scene with several bodies of one model, each of which moves by itself.

#include "sim/run/run.hpp"
#include "support/source.hpp"

namespace gausssim {

/// Whether it is a scene with the key `instances`. What is wrong with it is said by who reads it.
bool has_instances(const gaussgen::support::Source& text);

/// All instances over the same samples, one after another, into one table. Within an Interruption. Returns an exit code; throws as `run`.
int run_instances(const RunOptions& options, const gaussgen::support::Source& text);

}  // namespace gausssim
