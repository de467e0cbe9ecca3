#pragma once
// What values of options may be, said as everything else is said.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gausssim {

/// A number above 0, without an upper limit that anybody would ask for.
CLI::Validator positive();

/// A number above 0 and below 1.
CLI::Validator share();

/// One of these names; a slip is told the nearest of them.
CLI::Validator one_of(const std::vector<std::string>& names);

}  // namespace gausssim
