// Degenerate input: the table of tests/cli/test_degenerate.py, each row a model of nothing in some respect.

#include "process.hpp"
#include "registry.hpp"

namespace hard_cases {

std::vector<Figure> degenerate(const Scope&) {
  Stopwatch stopwatch;
  const Outcome outcome = run_program(python_test("cli/test_degenerate.py", "") + " --json");
  const auto value = [&](const char* name) {
    return outcome.exit_code == 0 ? number_behind(outcome.said, name) : k_breaks_down;
  };
  const std::string models = std::to_string(static_cast<int>(value("\"refused\":"))) + " models to refuse, " +
                             std::to_string(static_cast<int>(value("\"answered\":"))) + " to answer";
  return {{"H29.otherwise",
           "checks of degenerate models that end otherwise than by a named finding or the answer by hand", "1",
           std::nullopt, value("\"otherwise\":"), 0, 0, stopwatch.seconds(), models}};
}

}  // namespace hard_cases
