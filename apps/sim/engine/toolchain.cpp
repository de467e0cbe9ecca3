#include "sim/engine/toolchain.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

extern char** environ;

namespace gausssim {

namespace {

namespace fs = std::filesystem;

/// The executable file that a name of a command stands for; empty if there is none.
std::string on_path(const std::string& command) {
  const auto is_executable = [](const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
  };
  if (command.find('/') != std::string::npos) return is_executable(command) ? command : "";
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "/usr/bin:/bin" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path candidate = fs::path(rest.substr(0, end)) / command;
    if (end > 0 && is_executable(candidate)) return candidate.string();
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return "";
}

/// What tells one build of a program from another without running it.
std::string identity_of_file(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  struct stat info {};
  if (error || ::stat(real.c_str(), &info) != 0) return path;
  return fmt::format("{} {} {}.{}", real.string(), info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec);
}

/// -march=native means what this line says.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line, result;
  while (std::getline(info, line) && !line.empty()) {
    if (line.rfind("model name", 0) == 0 || line.rfind("flags", 0) == 0 || line.rfind("Features", 0) == 0)
      result += line + "\n";
  }
  return result;
}

std::string text_of_pipe(int descriptor) {
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

/// The exit status of a program, and what it says on standard error.
std::pair<int, std::string> run(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {-1, "no pipe"};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawn(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string said = text_of_pipe(ends[0]);
  ::close(ends[0]);
  if (error != 0) return {-1, "it cannot be started"};
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

}  // namespace

std::string Toolchain::identity() const {
  return fmt::format("{}\n{} {}\n{}", identity_of_file(compiler), fmt::join(flags, " "), fmt::join(libraries, " "),
                     processor());
}

std::optional<Toolchain> find_toolchain() {
  // Products and sums are rounded one by one, as by the interpreter and by gauss_add_model. g++ 12 contracts a pair of them (vfmaddsub) all the same
  // where it makes vectors of straight code, which is switched off then; loops become vectors without it. Power series are loops over orders: unrolled they take a
  // sixth less, at no price in compilation.
  const std::vector<std::string> flags{
      "-std=c++17",     "-O2",   "-march=native", "-ffp-contract=off",   "-fno-tree-slp-vectorize",
      "-funroll-loops", "-fPIC", "-shared",       "-fvisibility=hidden", "-w"};
  const char* const own = std::getenv("CXX");
  const std::vector<std::string> commands = own != nullptr && *own != '\0'
                                                ? std::vector<std::string>{own}
                                                : std::vector<std::string>{"c++", "g++", "clang++"};
  for (const std::string& command : commands) {
    if (const std::string path = on_path(command); !path.empty()) return Toolchain{path, flags};
  }
  return std::nullopt;
}

std::optional<std::string> failure_of_compiling(const Toolchain& toolchain, const std::string& source,
                                                const std::string& result) {
  std::vector<std::string> words{toolchain.compiler};
  words.insert(words.end(), toolchain.flags.begin(), toolchain.flags.end());
  words.insert(words.end(), {"-o", result, source});
  words.insert(words.end(), toolchain.libraries.begin(), toolchain.libraries.end());
  const auto [status, said] = run(words);
  if (status == 0) return std::nullopt;
  return said.empty() ? fmt::format("it ended with {}", status) : said;
}

}  // namespace gausssim
