// Same bits, whatever compiles an emitted model: the test of tests/determinism, with its figures.

#include "process.hpp"
#include "registry.hpp"

namespace hard_cases {

std::vector<Figure> same_bits(const Scope&) {
  Stopwatch stopwatch;
  const Outcome outcome = run_program(
      python_test("determinism/test_trajectories.py", "GAUSS_TRAJECTORY_HEADERS='" GAUSS_TRAJECTORY_HEADERS "'") +
      " --json");
  const double seconds = stopwatch.seconds();
  const auto value = [&](const char* name) {
    return outcome.exit_code == 0 ? number_behind(outcome.said, name) : k_breaks_down;
  };
  const double variants = value("\"variants\":"), models = value("\"models\":");
  const std::string remark = std::to_string(static_cast<int>(variants)) + " ways to compile " +
                             std::to_string(static_cast<int>(models)) +
                             " models: g++ and clang++, -O0 to -O3, with and without FMA";
  return {
      {"H25.bits", "models with other bits in any of 1e4 states; naive: products and sums contracted as compilers like",
       "1", value("\"differing_as_usual\":"), value("\"differing\":"), 0, 0, seconds, remark},
      {"H25.fast", "last state of 1e4 steps with -ffast-math, asked for, by its size", "1", std::nullopt,
       value("\"fast_math\":"), 1e-12, 0, 0, "motions that do not enlarge differences"}};
}

}  // namespace hard_cases
