#pragma once
// The passes in their order.

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

/// Those that run on what is left then, each once or several times, in the order in which they run.
const std::vector<Pass>& passes();

/// What a pass made of a request.
struct PassEffect {
  std::string pass;
  int before = 0;  ///< operations
  int after = 0;   ///< the same as before where the pass would have added some, and was left out
  double milliseconds = 0;
};

/// The same values in no more operations: each pass counts where it saves some. `effects`, if given, gets a line for each.
Request optimise(Graph& graph, const Request& request, const std::vector<Pass>& passes,
                 std::vector<PassEffect>* effects = nullptr);

}  // namespace gaussgen::passes
