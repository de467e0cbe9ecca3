#include "machine.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace bench {

namespace {

/// What follows the colon in the first line that starts with `key`.
std::string entry(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t colon = line.find(':');
    return colon == std::string::npos ? line : line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

void print_machine() {
  std::printf("%s, %u processors, load %s\n", entry("/proc/cpuinfo", "model name").c_str(),
              std::thread::hardware_concurrency(), entry("/proc/loadavg", "").c_str());
#if defined(__clang__)
  std::printf("clang++ %s,%s\n", __clang_version__, GAUSS_FLAGS);
#else
  std::printf("g++ %s,%s\n", __VERSION__, GAUSS_FLAGS);
#endif
  std::fflush(stdout);
  if (std::system("'" GAUSS_GEN "' --version") != 0) std::printf("gauss-gen: version unknown\n");
}

}  // namespace bench
