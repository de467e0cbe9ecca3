#pragma once
// Motions through regimes of contacts and friction, by gauss-sim.

#include <map>
#include <string>
#include <vector>

namespace hard_cases {

struct Happening {
  double t = 0;
  std::string what;  ///< "floor hits"
};

struct Simulated {
  int exit_code = -1;
  std::map<std::string, std::vector<double>> table;  ///< by names without units; what is no number there is none here
  std::vector<Happening> events;
  std::string said;  ///< on standard error
  double seconds = 0;

  bool is_finite() const;

  /// At the end; breaks down where there is none.
  double last(const std::string& column) const;
};

/// Of a file in the checkout, as `gauss-sim run` has it with these options.
Simulated simulated(const std::string& file, const std::string& options);

}  // namespace hard_cases
