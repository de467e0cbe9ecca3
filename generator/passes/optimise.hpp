#pragma once
// The passes in their order (docs/decisions/0008-passes.md).

#include <string>
#include <vector>

#include "passes/program.hpp"

namespace gaussgen::passes {

struct Pass {
  const char* name;
  Request (*run)(Graph&, const Request&);
};

/// Those that recognise sines and cosines, also of parameters: before what depends on parameters alone becomes opaque.
const std::vector<Pass>& identities();

/// Those that run on what is left then. There are several orders; none is the best one for all programs.
const std::vector<std::vector<Pass>>& orders();

/// What a pass made of a request.
struct PassEffect {
  std::string pass;
  int before = 0;  ///< operations
  int after =
      0;  ///< the same as before where the pass would have added some, and was left out; more for those that serve something else
  double milliseconds = 0;
};

/// The same values in no more operations: each pass counts where it saves some. `effects`, if given, gets a line for each.
Request apply(Graph& graph, const Request& request, const std::vector<Pass>& passes,
              std::vector<PassEffect>* effects = nullptr);

/// By the order that leaves fewest operations; the first one, where another is not worth it. `effects` are those of its passes.
Request apply_best_order(Graph& graph, const Request& request, std::vector<PassEffect>* effects = nullptr);

/// In front of all others, and whatever it takes: digits are worth more than operations.
Request apply_cancellation(Graph& graph, const Request& request, std::vector<PassEffect>* effects = nullptr,
                           const std::vector<std::string>& as_written = {});

/// Behind all others, and measured in instructions instead of operations: rotations in the place of calls.
Request apply_rotations(Graph& graph, const Request& request, std::vector<PassEffect>* effects = nullptr);

}  // namespace gaussgen::passes
