#include "model/functions.hpp"

#include <algorithm>
#include <iterator>

namespace gaussgen::model {

namespace {

constexpr Function k_functions[] = {
    {"sin", 1}, {"cos", 1}, {"tan", 1},  {"asin", 1}, {"acos", 1}, {"atan", 1}, {"atan2", 2},
    {"exp", 1}, {"log", 1}, {"sqrt", 1}, {"sinh", 1}, {"cosh", 1}, {"tanh", 1}, {k_dot, 1},
};

}  // namespace

const Function* find_function(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(k_functions), std::end(k_functions), [&](const Function& f) { return f.name == name; });
  return found == std::end(k_functions) ? nullptr : found;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const Function& function : k_functions) names.emplace_back(function.name);
  return names;
}

bool is_reserved(std::string_view name) {
  return name == "t" || name == "pi" || name == "I" || find_function(name) != nullptr;
}

}  // namespace gaussgen::model
