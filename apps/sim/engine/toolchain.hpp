#pragma once
// The compiler of the system.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gausssim {

struct Toolchain {
  std::string compiler;                ///< path
  std::vector<std::string> arguments;  ///< that CXX has behind it
  std::vector<std::string> flags;      ///< of all plugins
  std::vector<std::string> libraries = {};

  /// Another one where anything is another that may change what it makes: the compiler, its flags, the processor.
  std::string identity() const;
};

/// That of CXX, which may have arguments as for make and CMake, else c++, g++ or clang++ on the path. Nothing: `why`.
std::optional<Toolchain> find_toolchain(std::string& why);

/// CXX says which one.
bool is_compiler_chosen();

struct Compilation {
  std::optional<std::string> failure = {};  ///< what the compiler says then
  bool was_ended = false;                   ///< by `ends`
};

/// Runs the compiler. No shell has a part in it.
Compilation compile(const Toolchain& toolchain, const std::string& source, const std::string& result,
                    const std::function<bool()>& ends);

}  // namespace gausssim
