#pragma once
// How an ensemble went, as JSON and in words.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/ensemble/outcomes.hpp"
#include "sim/ensemble/statistics.hpp"
#include "sim/run/build_engine.hpp"

namespace gausssim {

struct EnsembleTold {
  const PreparedModel& prepared;
  const EnsembleSetting& setting;
  const Outcomes& outcomes;
  std::string engine;
  EngineTimes times;
  double lanes_seconds = 0;  ///< of compilation
  bool was_interrupted = false;
  std::vector<Statistics> statistics = {};  ///< of each output at the end
};

/// Of trajectories that arrived; infinities and what is no number are left out.
std::vector<Statistics> statistics_of_outputs(const Outcomes& outcomes);

/// For a terminal: counts, a table of outputs, and seconds.
std::string ensemble_text(const EnsembleTold& told);

nlohmann::ordered_json ensemble_json(const EnsembleTold& told);

/// How many ended so, by status_text; those that were not run are left out.
std::map<std::string, long> counts_by_status(const Outcomes& outcomes);

/// Per second of the run.
double rate_of(long count, const Outcomes& outcomes);

}  // namespace gausssim
