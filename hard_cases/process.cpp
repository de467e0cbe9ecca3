#include "process.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "case.hpp"

namespace hard_cases {

Outcome run_program(const std::string& line) {
  std::fflush(stdout);
  std::FILE* pipe = popen(("{ " + line + "; } 2>&1").c_str(), "r");
  if (pipe == nullptr) return {};
  Outcome result;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    result.said.append(buffer.data(), count);
  const int status = pclose(pipe);
  if (status != -1 && WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

std::string python_test(const std::string& file, const std::string& environment) {
  return environment +
         " GAUSS_GEN='" GAUSS_GEN "' GAUSS_SOURCE_DIR='" GAUSS_SOURCE_DIR "' '" GAUSS_PYTHON "' -B '" GAUSS_SOURCE_DIR
         "/tests/" +
         file + "'";
}

double number_behind(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name);
  if (at == std::string::npos) return k_breaks_down;
  const std::size_t digit = text.find_first_of("-0123456789", at + name.size());
  return digit == std::string::npos ? k_breaks_down : std::strtod(text.c_str() + digit, nullptr);
}

}  // namespace hard_cases
