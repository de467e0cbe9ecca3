#pragma once
// The instances of a scene, as models whose functions can be executed: derived once for each code.

#include <memory>
#include <optional>
#include <vector>

#include "sim/run/among_instances.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/run.hpp"

namespace gausssim {

struct PreparedInstances {
  std::vector<std::unique_ptr<const PreparedModel>> all;  ///< in the order of the scene; at least one
  std::unique_ptr<AmongInstances> among;                  ///< what they share
};

/// Nothing, and `code`: some of them are wrong; all that is wrong has been said. Throws as `prepare`.
std::optional<PreparedInstances> prepare_instances(const RunOptions& options, const gaussgen::support::Source& text,
                                                   int& code);

}  // namespace gausssim
