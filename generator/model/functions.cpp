#include "model/functions.hpp"

#include <algorithm>
#include <iterator>

namespace gaussgen::model {

namespace {

constexpr Function k_functions[] = {
    {"sin", 1},
    {"cos", 1},
    {"tan", 1},
    {"asin", 1},
    {"acos", 1},
    {"atan", 1},
    {"atan2", 2},
    {"exp", 1},
    {"log", 1},
    {"sqrt", 1},
    {"sinh", 1},
    {"cosh", 1},
    {"tanh", 1},
    {"pow", 2},
    {"abs", 1},
    {"sign", 1},
    {"min", 2, k_most_arguments},
    {"max", 2, k_most_arguments},
    {k_piecewise, 3, k_most_arguments + 1},
    {k_dot, 1},
    {k_distance, 2},
};

struct Substitute {
  const char* name;
  const char* advice;
};

constexpr const char* k_for_sign = "write sign(x), which is 0 at 0";
constexpr const char* k_for_cases = "write piecewise(x < 0, a, b): a where x < 0, else b";

constexpr Substitute k_substitutes[] = {
    {"fabs", "write abs(x) for |x|"},
    {"sgn", k_for_sign},
    {"signum", k_for_sign},
    {"if", k_for_cases},
    {"ifelse", k_for_cases},
    {"where", k_for_cases},
    {"select", k_for_cases},
    {"step", "write piecewise(x < 0, 0, 1)"},
    {"heaviside", "write piecewise(x < 0, 0, 1)"},
    {"clip", "write min(max(x, a), b) for x between a and b"},
    {"clamp", "write min(max(x, a), b) for x between a and b"},
    {"cbrt", "write x^(1/3)"},
    {"ln", "write log(x), the natural logarithm"},
    {"log10", "write log(x)/log(10)"},
    {"cot", "write 1/tan(x)"},
    {"sec", "write 1/cos(x)"},
    {"der", "write dot(x) for the rate of x"},
    {"ddot", "accelerations are not available in a model, rates dot(x) are"},
    {"diff", "write dot(x) for the rate of x"},
};

}  // namespace

std::string substitute_for(std::string_view name) {
  const auto* found = std::find_if(std::begin(k_substitutes), std::end(k_substitutes),
                                   [&](const Substitute& other) { return other.name == name; });
  return found == std::end(k_substitutes) ? "" : found->advice;
}

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
