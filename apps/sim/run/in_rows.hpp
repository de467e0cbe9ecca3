#pragma once
// Whole runs: with all that they say, or for what they take.

#include "sim/run/error_estimate.hpp"

namespace gausssim {

struct RunInRows {
  Simulated run;
  Rows rows;
};

enum class Meter { drift, none };

RunInRows in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting, Meter meter);

/// Nobody listens: for its time, steps and calls.
Simulated unheard(const PreparedModel& prepared, const Engine& engine, const Setting& setting);

}  // namespace gausssim
