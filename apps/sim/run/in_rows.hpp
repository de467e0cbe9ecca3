#pragma once
// Whole runs: with all that they say, or for what they take.

#include <future>

#include "sim/run/error_estimate.hpp"

namespace gausssim {

struct RunInRows {
  Simulated run;
  Rows rows;
};

enum class Meter { drift, none };

RunInRows in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting, Meter meter);

/// Beside other runs, if there is the memory for all of them; else when it is asked for. It ends after `seconds`. `prepared` and `engine` outlive it.
std::future<RunInRows> begin_in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                                     double seconds);

/// Whether rows of another run are there for all of the first one.
bool gets_as_far(const Simulated& other, const Simulated& run);

/// What jumps at an event, as speeds in an impact, has two values there, and rounding tells which of them a sample at its very instant has: such rows of `other` become
/// those that it is compared with. `events`: of these.
void agree_at_events(RunInRows& other, const std::vector<Event>& events, const Rows& rows, const Span& span);

/// Nobody listens: for its time, steps and calls.
Simulated unheard(const PreparedModel& prepared, const Engine& engine, const Setting& setting);

}  // namespace gausssim
