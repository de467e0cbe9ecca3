#pragma once
// The manual page and the completions of shells, from the options themselves.

#include <string>

namespace CLI {
class App;
}

namespace gausssim {

std::string manual_of(const CLI::App& app);

/// `shell`: bash, zsh or fish.
std::string completion_of(const CLI::App& app, const std::string& shell);

}  // namespace gausssim
