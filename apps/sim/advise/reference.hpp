#pragma once
// What a setting is compared with: two runs that agree far better than the error that is asked for.

#include <optional>
#include <string>

#include "sim/advise/loss.hpp"
#include "sim/run/found_setting.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

/// Why a run did not arrive; empty: it did.
std::string why_not(const Simulated& run);

struct TightRun {
  Yardstick yardstick;
  std::string in_words;
  double agreement = 0;
};

/// In double, else in number types of more digits, until two tolerances agree to a twentieth of `error`; not in those that lose more. Nothing: `why`. Throws Interrupted and
/// OutOfTime.
std::optional<TightRun> tight_run(const PreparedModel& prepared, Engines& engines, double error, const Loss& loss,
                                  const TimeLimit& limit, std::string& why);

/// The number types that a method may be run in, those of fewest digits first.
std::vector<std::string> numbers_from(const std::string& first, const std::string& method);

}  // namespace gausssim
