#pragma once
// What tells how far a run may be off that nothing else is compared with: tighter runs, until two of them agree far better than the run with them.

#include <optional>
#include <string>

#include "sim/run/engines.hpp"
#include "sim/run/error_estimate.hpp"
#include "sim/run/in_rows.hpp"

namespace gausssim {

constexpr double k_agree = 0.25;  ///< of the error of a run, by which two tighter ones may differ

struct TighterRuns {
  Yardstick yardstick;                      ///< of the tightest
  DeliveredError error;                     ///< of the run, against it
  std::optional<DeliveredError> agreement;  ///< of the two tightest; nothing where only one arrives
};

/// Why there is no estimate.
struct WhyNone {
  std::string text;
  bool is_doubtful = false;  ///< the run may be none of the model at all, as where a tighter one stops before
};

/// What runs may take that tell something of one that has ended.
double most_seconds_beside(const Simulated& run);

/// Of a run with its rows, by the engine of its setting. Nothing, and `why`: no tighter run is another one, or arrives within some times what the run took.
std::optional<TighterRuns> tighter_runs(const PreparedModel& prepared, const Engine& engine, Engines& engines,
                                        const Setting& setting, const Simulated& run, const Rows& rows, WhyNone& why);

}  // namespace gausssim
