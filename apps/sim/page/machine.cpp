#include "sim/page/machine.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "sim/engine/toolchain.hpp"

namespace gausssim {

namespace {

std::string value_in(const char* file, const std::string& key, char separator) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind(key, 0) != 0) continue;
    std::string value = line.substr(std::min(line.find(separator) + 1, line.size()));
    value.erase(0, std::min(value.find_first_not_of(" \t\""), value.size()));
    value.erase(value.find_last_not_of(" \t\"") + 1);
    return value;
  }
  return "";
}

}  // namespace

Computer this_machine() {
  Computer machine;
  machine.processor = value_in("/proc/cpuinfo", "model name", ':');
  machine.system = value_in("/etc/os-release", "PRETTY_NAME", '=');
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  std::string why;
  if (const auto toolchain = find_toolchain(why)) {
    const std::string name = std::filesystem::path(toolchain->compiler).filename().string();
    machine.compiler =
        fmt::format("{}{}{}", name, toolchain->arguments.empty() ? "" : " ", fmt::join(toolchain->arguments, " "));
    machine.flags = fmt::format("{}", fmt::join(toolchain->flags, " "));
  }
  return machine;
}

}  // namespace gausssim
