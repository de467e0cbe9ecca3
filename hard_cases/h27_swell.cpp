// Expressions that swell: chains in space by Euler's angles, as they are generated.

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "process.hpp"
#include "registry.hpp"

namespace hard_cases {

namespace {

struct Generation {
  double operations = k_breaks_down;  ///< of rhs
  double seconds = k_breaks_down;
  double megabytes = k_breaks_down;  ///< largest resident size
};

/// Sums, products, quotients, roots and functions of `rhs`, as a header's table has them.
double operations_in(const std::string& header) {
  const std::size_t table = header.find("// Operations per call"), row = header.find("//   rhs ", table);
  if (table == std::string::npos || row == std::string::npos) return k_breaks_down;
  std::istringstream numbers(header.substr(row + 8, header.find('\n', row) - row - 8));
  double sum = 0;
  for (double each = 0; numbers >> each;) sum += each;
  return sum;
}

Generation generate(int links, const std::string& more) {
  // The largest of all children of one process, which has no other.
  const std::string measured =
      "'" GAUSS_PYTHON
      "' -c 'import resource, subprocess, sys, time; t = time.monotonic(); subprocess.run(sys.argv[1:], check=True); "
      "print(\"\\nseconds\", time.monotonic() - t, \"kilobytes\", "
      "resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' ";
  const Outcome outcome =
      run_program(measured + "'" GAUSS_GEN "' '" GAUSS_SOURCE_DIR "/hard_cases/models/zxz_chain.yaml' --count n=" +
                  std::to_string(links) + " --outputs rhs -o - " + more);
  if (outcome.exit_code != 0) return {};
  return {operations_in(outcome.said), number_behind(outcome.said, "\nseconds"),
          number_behind(outcome.said, "kilobytes") / 1024};
}

}  // namespace

std::vector<Figure> swell(const Scope& scope) {
  const Generation two = generate(2, ""), three = generate(3, ""), eight = generate(8, "");
  const Generation naive_two = generate(2, "--route paper"), naive_three = generate(3, "--route paper");
  std::vector<Figure> result = {
      {"H27.growth", "operations of 3 links by those of 2 (z-x-z); the bar is cubic", "1",
       naive_three.operations / naive_two.operations, three.operations / two.operations, 3.375, naive_three.seconds,
       three.seconds, "naive: the paper's expressions term by term"},
      {"H27.operations", "operations of the right-hand side of 8 links", "1", std::nullopt, eight.operations, 10'000, 0,
       eight.seconds},
      {"H27.memory", "memory to generate 8 links", "MB", std::nullopt, eight.megabytes, 100}};
  if (!scope.is_timed) return result;
  const Generation sixteen = generate(16, "");
  const std::string operations = std::to_string(static_cast<int>(sixteen.operations)) + " operations";
  result.push_back({"H27.time", "time to generate 8 links", "s", std::nullopt, eight.seconds, 1});
  result.push_back({"H27.long", "time to generate 16 links", "s", std::nullopt, sixteen.seconds, 10, 0, sixteen.seconds,
                    operations});
  return result;
}

}  // namespace hard_cases
