#include "sim/cli/validators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/suggest.hpp"

namespace gausssim {

CLI::Validator positive() {
  const auto refuse = [](const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool is_good = end == text.c_str() + text.size() && value > 0 && std::isfinite(value);
    return is_good ? std::string() : fmt::format("'{}' is no number above 0", text);
  };
  return {refuse, ""};
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto refuse = [names](const std::string& text) {
    if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
    const std::string near = gaussgen::support::did_you_mean(text, names);
    return fmt::format("there is no '{}'; {}", text,
                       near.empty() ? "choose from " + gaussgen::support::joined(names) : near);
  };
  return {refuse, fmt::format("{{{}}}", fmt::join(names, ","))};
}

}  // namespace gausssim
