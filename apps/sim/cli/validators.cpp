#include "sim/cli/validators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/suggest.hpp"

namespace gausssim {

namespace {

CLI::Validator above_0(bool (*is_small)(double), const char* what) {
  const auto refuse = [=](const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool is_good = end == text.c_str() + text.size() && value > 0 && is_small(value);
    return is_good ? std::string() : fmt::format("'{}' is no number {}", text, what);
  };
  return {refuse, ""};
}

}  // namespace

CLI::Validator positive() {
  return above_0([](double value) { return std::isfinite(value); }, "above 0");
}

CLI::Validator share() {
  return above_0([](double value) { return value < 1; }, "above 0 and below 1");
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
