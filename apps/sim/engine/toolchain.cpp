#include "sim/engine/toolchain.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "sim/engine/child_process.hpp"

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

/// As a shell has them: blanks part words, quotes and backslashes keep them together.
std::vector<std::string> shell_words(std::string_view text) {
  std::vector<std::string> words;
  bool is_inside = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_blank = c == ' ' || c == '\t' || c == '\n';
    if (quote == 0 && is_blank) {
      is_inside = false;
      continue;
    }
    if (!is_inside) words.emplace_back();
    is_inside = true;
    if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else {
      const bool is_escape = c == '\\' && quote != '\'' && i + 1 < text.size();
      words.back() += is_escape ? text[++i] : c;
    }
  }
  return words;
}

std::string chosen_compiler() {
  const char* const own = std::getenv("CXX");
  const std::string text = own == nullptr ? "" : own;
  return text.find_first_not_of(" \t\n") == std::string::npos ? "" : text;
}

/// A path with blanks is one word.
std::vector<std::string> words_of(const std::string& chosen) {
  return on_path(chosen).empty() ? shell_words(chosen) : std::vector<std::string>{chosen};
}

}  // namespace

std::string Toolchain::identity() const {
  std::string programs = identity_of_file(compiler);
  // CXX="ccache g++" names two.
  for (const std::string& word : arguments) {
    const std::string path = on_path(word);
    programs += "\n" + (path.empty() ? word : identity_of_file(path));
  }
  return fmt::format("{}\n{} {}\n{}", programs, fmt::join(flags, " "), fmt::join(libraries, " "), processor());
}

bool is_compiler_chosen() { return !chosen_compiler().empty(); }

std::optional<Toolchain> find_toolchain(std::string& why) {
  // Products and sums are rounded one by one, as by the interpreter and by gauss_add_model. g++ 12 contracts a pair of them (vfmaddsub) all the same
  // where it makes vectors of straight code, which is switched off then; loops become vectors without it. Power series are loops over orders: unrolled they take a
  // sixth less, at no price in compilation.
  const std::vector<std::string> flags{
      "-std=c++17",     "-O2",   "-march=native", "-ffp-contract=off",   "-fno-tree-slp-vectorize",
      "-funroll-loops", "-fPIC", "-shared",       "-fvisibility=hidden", "-w"};
  if (const std::string chosen = chosen_compiler(); !chosen.empty()) {
    std::vector<std::string> words = words_of(chosen);
    const std::string path = words.empty() ? "" : on_path(words.front());
    if (!path.empty()) return Toolchain{path, {words.begin() + 1, words.end()}, flags};
    why = fmt::format("CXX is '{}', and that is no program that can be run", chosen);
    return std::nullopt;
  }
  for (const char* const command : {"c++", "g++", "clang++"}) {
    if (const std::string path = on_path(command); !path.empty()) return Toolchain{path, {}, flags};
  }
  why = "there is no C++ compiler on the path; CXX may name one";
  return std::nullopt;
}

Compilation compile(const Toolchain& toolchain, const std::string& source, const std::string& result,
                    const std::function<bool()>& ends) {
  std::vector<std::string> words{toolchain.compiler};
  for (const auto* const more : {&toolchain.arguments, &toolchain.flags})
    words.insert(words.end(), more->begin(), more->end());
  words.insert(words.end(), {"-o", result, source});
  words.insert(words.end(), toolchain.libraries.begin(), toolchain.libraries.end());
  const Finished run = run_program(words, ends);
  if (run.was_ended) return {{}, true};
  if (run.status == 0) return {};
  return {run.said.empty() ? fmt::format("it ended with {}", run.status) : run.said};
}

}  // namespace gausssim
