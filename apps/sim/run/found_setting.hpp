#pragma once
// A setting that was found for an error that somebody accepts, and what says so.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/engines.hpp"
#include "sim/run/error_estimate.hpp"

namespace gausssim {

/// A setting that was tried.
struct Trial {
  Setting setting;
  DeliveredError error;
  double seconds = 0;          ///< of the processor, for one run
  std::string why;             ///< there was no motion
  long steps = 0;              ///< of that run
  bool is_unsuitable = false;  ///< the method does not take the model, whatever its steps
};

struct FoundSetting {
  Trial chosen;
  std::vector<Trial> trials;  ///< the best of each method that came into question
  Yardstick reference;        ///< of a tighter run, which another one agrees with
  std::string reference_in_words;
  double agreement = 0;  ///< of the two
};

/// What is asked for.
struct Wanted {
  double error = 0;     ///< of all outputs, relative to their ranges
  double budget = 600;  ///< seconds of the search
  bool is_told = true;  ///< what is tried, on a terminal
};

/// The cheapest setting that delivers an error in all outputs, as `advise` finds it. Nothing: `why`.
using FindSetting = std::function<std::optional<FoundSetting>(const PreparedModel& prepared, Engines& engines,
                                                              const Wanted& wanted, std::string& why)>;

}  // namespace gausssim
