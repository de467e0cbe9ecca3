#include "generation.hpp"

#include <cstdlib>
#include <stdexcept>

namespace bench {

Times generation(const std::string& model) {
  constexpr int k_runs = 21;
  const std::string command = std::string("'" GAUSS_GEN "' '" GAUSS_MODELS "/") + model + ".yaml' -o - >/dev/null";
  std::vector<double> times;
  for (int i = 0; i <= k_runs; ++i) {
    int code = 0;
    const double taken = seconds([&] { code = std::system(command.c_str()); });
    if (code != 0) throw std::runtime_error("failed: " + command);
    if (i > 0) times.push_back(taken);
  }
  return summary(times);
}

}  // namespace bench
