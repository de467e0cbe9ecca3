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

/// Each once or several times, in the order in which they run.
const std::vector<Pass>& passes();

/// What a pass made of a request.
struct PassEffect {
  std::string pass;
  int before = 0;  ///< operations
  int after = 0;   ///< the same as before where the pass would have added some, and was left out
  double milliseconds = 0;
};

/// The same values with fewer operations. `effects`, if given, tells what each pass made of it.
Request optimise(Graph& graph, const Request& request, std::vector<PassEffect>* effects = nullptr);

}  // namespace gaussgen::passes
