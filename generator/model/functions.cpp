#include "model/functions.hpp"

#include <algorithm>
#include <iterator>

namespace gaussgen::model {

namespace {

constexpr Function k_functions[] = {
    {"sin", 1}, {"cos", 1}, {"tan", 1},  {"asin", 1}, {"acos", 1}, {"atan", 1}, {"atan2", 2},
    {"exp", 1}, {"log", 1}, {"sqrt", 1}, {"sinh", 1}, {"cosh", 1}, {"tanh", 1}, {k_dot, 1},
};

struct Substitute {
  const char* name;
  const char* advice;
};

constexpr const char* k_for_size = "write sqrt(x^2) for |x|";
constexpr const char* k_for_sign = "write tanh(x/eps) with a small eps for the sign of x";

constexpr Substitute k_substitutes[] = {
    {"abs", k_for_size},
    {"fabs", k_for_size},
    {"sgn", k_for_sign},
    {"sign", k_for_sign},
    {"signum", k_for_sign},
    {"max", "write (a + b + sqrt((a - b)^2))/2 for the larger of a and b"},
    {"min", "write (a + b - sqrt((a - b)^2))/2 for the smaller of a and b"},
    {"pow", "write x^2, or exp(b*log(a)) for a^b with a variable b"},
    {"ln", "write log(x), the natural logarithm"},
    {"log10", "write log(x)/log(10)"},
    {"cot", "write 1/tan(x)"},
    {"sec", "write 1/cos(x)"},
    {"der", "write dot(x) for the rate of x"},
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
